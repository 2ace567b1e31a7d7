package simbad.cli;

import java.io.PrintWriter;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import simbad.experiments.report.ErrorWords;
import simbad.experiments.report.TableName;
import simbad.experiments.run.EdgeLoss;
import simbad.experiments.run.ErrorParts;
import simbad.experiments.run.RunResult;
import simbad.experiments.run.TraceErrors;
import simbad.experiments.run.TraceMove;

/** The figures of a run for the console. */
final class RunSummary {
  private static final String ROW = " %9s %9s %9s %9s %9s %9s %10s %11s%n";
  private static final int LEAST_WIDTH = 9;
  private static final String TITLE = "obstacle (table)";

  private RunSummary() {}

  static void print(PrintWriter out, List<RunResult> results) {
    String row = row(results);
    out.printf(
        row,
        TITLE,
        "sensor",
        ErrorWords.MEAN,
        ErrorWords.RMS,
        ErrorWords.MAX,
        ErrorWords.BESIDE,
        ErrorWords.EDGE_KEPT,
        ErrorWords.FROM_EDGE,
        ErrorWords.UNREACHED,
        ErrorWords.REDUCTION);
    for (RunResult result : results) {
      TraceErrors errors = result.errors();
      out.printf(
          row,
          name(result),
          result.sensor().word(),
          centimetres(errors.meanM()),
          centimetres(errors.rmsM()),
          centimetres(errors.maxM()),
          centimetres(
              result.hasLateralErrors()
                  ? OptionalDouble.of(errors.lateralMeanM())
                  : OptionalDouble.empty()),
          percent(errors.edge().share()),
          centimetres(errors.edge().maxM()),
          errors.unreachedBearings() + "/" + errors.radialM().size(),
          percent(result.reductionVsOriginal()));
    }
    ErrorWords.MEANINGS.forEach(out::println);
    EdgeLoss.of(results).forEach(loss -> out.println(loss.sentence()));
    TraceMove.of(results).forEach(move -> out.println(move.sentence()));
    printParts(results, out);
  }

  private static void printParts(List<RunResult> results, PrintWriter out) {
    List<ErrorParts> parts = ErrorParts.of(results);
    parts.forEach(part -> out.println(part.sentence()));
    if (parts.isEmpty() && results.stream().anyMatch(one -> one.sensor().robot().isPresent())) {
      out.println(
          "What comes from hearing and what from moving is not told: name a believed sensor beside"
              + " the diagnosed one (--sensor shadow,diagnosed:DIR)");
    }
  }

  /** As wide as the longest names. */
  private static String row(List<RunResult> results) {
    int name = results.stream().mapToInt(result -> name(result).length()).max().orElse(0);
    int sensor =
        results.stream().mapToInt(result -> result.sensor().word().length()).max().orElse(0);
    return "%-"
        + Math.max(TITLE.length(), name)
        + "s %-"
        + Math.max(LEAST_WIDTH, sensor)
        + "s"
        + ROW;
  }

  private static String name(RunResult result) {
    return TableName.of(result.type());
  }

  static String centimetres(OptionalDouble metres) {
    return metres.isPresent() ? text("%.2f", 100 * metres.getAsDouble()) : "-";
  }

  private static String percent(OptionalDouble share) {
    return share.isPresent() ? text("%.1f %%", 100 * share.getAsDouble()) : "-";
  }

  private static String text(String format, double value) {
    return String.format(Locale.ROOT, format, value);
  }
}
