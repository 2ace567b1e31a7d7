package simbad.cli;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.nio.file.Path;
import java.util.Locale;
import java.util.SplittableRandom;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import simbad.experiments.report.TableName;
import simbad.experiments.table.TableComparison;
import simbad.figures.report.TablePicture;
import simbad.gap.diagnosis.Interval;
import simbad.obstacles.ObstacleType;
import simbad.sonar.shape.ThresholdBand;

/** {@code simbad table compare}. */
@Command(
    name = "compare",
    description = {
      "Compare two threshold tables: correlation of their logarithms, differences bearing by bearing, and"
          + " the rotation and mirror of the second that fits the first best."
    },
    footer = {
      "",
      "Example: simbad table compare angle my-angle.csv --out both.svg",
      "Example: simbad table compare square predicted.csv --bearings"
    })
final class TableCompareCommand extends Subcommand {
  /** Of the resampling: the same tables give the same intervals. */
  private static final long SEED = 1;

  @Parameters(index = "0", paramLabel = "A", description = "An obstacle's name, or TABLE.csv.")
  private String first = "";

  @Parameters(
      index = "1",
      paramLabel = "B",
      description = "The other table. It is compared at A's bearings.")
  private String second = "";

  @Option(
      names = "--out",
      paramLabel = "FILE",
      description = "Draw both in one picture, *.png or *.svg.")
  private @Nullable Path file;

  @Option(names = "--bearings", description = "Print thresholds and difference at every bearing.")
  private boolean listed;

  @Option(names = "--json", description = "Print everything as one JSON object.")
  private boolean json;

  @Override
  protected void run() throws Exception {
    if (file != null) {
      requirePicture("--out", file);
    }
    ObstacleType a = ObstacleArgument.parse(first);
    ObstacleType b = ObstacleArgument.parse(second);
    TableComparison comparison = TableComparison.of(a.thresholds().table(), b.thresholds().table());
    if (file != null) {
      OutputFile.refuseExisting(file);
      OutputFile.draw(TablePicture.of(a, b), file);
    }
    if (json) {
      out().println(json(b, comparison));
    } else {
      print(a, b, comparison);
    }
  }

  private void print(ObstacleType a, ObstacleType b, TableComparison c) {
    line("%s and %s, %d bearings", TableName.of(a), TableName.of(b), c.bearings().size());
    printLikeness(c);
    line(
        "  second minus first: mean %+.3f m, mean absolute %.3f m",
        c.meanDifferenceM(), c.meanAbsoluteDifferenceM());
    line(
        "  best: second turned by %s degrees%s, log-correlation %.3f",
        degrees(c.best().rotationDeg()),
        c.best().mirrored() ? ", mirrored first" : "",
        c.best().correlation());
    b.thresholds()
        .band()
        .ifPresent(
            band ->
                line(
                    "  %d of the first's thresholds within the second's band",
                    withinBand(c, band)));
    if (listed) {
      out().println("bearing_deg,first_m,second_m,difference_m");
      c.bearings()
          .forEach(
              row ->
                  line(
                      "%s,%.3f,%.3f,%.3f",
                      degrees(row.bearingDeg()), row.firstM(), row.secondM(), row.differenceM()));
    }
  }

  private void printLikeness(TableComparison c) {
    Interval correlation = c.correlationInterval(new SplittableRandom(SEED));
    Interval ratio = c.medianRatioInterval(new SplittableRandom(SEED));
    line(
        "  log-correlation %.3f (95 %% interval %.3f to %.3f); median ratio error %.1f %% (%.0f to %.0f)",
        c.correlation(),
        correlation.low(),
        correlation.high(),
        100 * c.medianRatioError(),
        100 * ratio.low(),
        100 * ratio.high());
  }

  private static long withinBand(TableComparison c, ThresholdBand band) {
    return c.bearings().stream()
        .filter(row -> band.holds(Math.toRadians(row.bearingDeg()), row.firstM()))
        .count();
  }

  /** Whole degrees without a point. */
  private static String degrees(double value) {
    return value == Math.rint(value) ? Long.toString((long) value) : Double.toString(value);
  }

  private void line(String format, Object... values) {
    out().println(String.format(Locale.ROOT, format, values));
  }

  private static void put(ObjectNode root, String name, Interval interval) {
    root.putArray(name).add(interval.low()).add(interval.high());
  }

  private static ObjectNode json(ObstacleType b, TableComparison c) {
    ObjectNode root = new ObjectMapper().createObjectNode();
    root.put("log_correlation", c.correlation());
    put(root, "log_correlation_ci95", c.correlationInterval(new SplittableRandom(SEED)));
    root.put("median_ratio_error", c.medianRatioError());
    put(root, "median_ratio_error_ci95", c.medianRatioInterval(new SplittableRandom(SEED)));
    root.put("mean_difference_m", c.meanDifferenceM());
    root.put("mean_absolute_difference_m", c.meanAbsoluteDifferenceM());
    root.put("best_rotation_deg", c.best().rotationDeg());
    root.put("best_mirrored", c.best().mirrored());
    root.put("best_log_correlation", c.best().correlation());
    b.thresholds()
        .band()
        .ifPresent(band -> root.put("first_within_second_band", withinBand(c, band)));
    ArrayNode rows = root.putArray("bearings");
    c.bearings()
        .forEach(
            row ->
                rows.addObject()
                    .put("bearing_deg", row.bearingDeg())
                    .put("first_m", row.firstM())
                    .put("second_m", row.secondM()));
    return root;
  }
}
