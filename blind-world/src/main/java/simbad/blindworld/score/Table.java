package simbad.blindworld.score;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.function.Function;

/** Scores of several sorts of answers in columns. */
final class Table {

  private static final int NAME = 42;
  private static final int COLUMN = 26;

  private final String part;
  private final Map<String, Scores> bySort;

  Table(String part, Map<String, Scores> bySort) {
    this.part = part;
    this.bySort = bySort;
  }

  String text() {
    StringBuilder text = new StringBuilder();
    row(text, part, bySort.keySet().stream().toList());
    Scores first = bySort.values().iterator().next();
    for (String name : first.shares().keySet()) {
      each(text, "  " + name, s -> String.valueOf(s.shares().get(name)));
    }
    each(text, "  mean of the classes, right", s -> number(s.classMean()));
    each(text, "  probability of the truth, mean", s -> number(s.probabilityOfTruth()));
    each(text, "  unknown AUROC", s -> number(s.auroc()));
    each(
        text,
        "  verdict: ECE, log score better by",
        s ->
            number(Calibration.expectedError(s.verdictClaims()))
                + ", "
                + percent(s.verdictBetterBy()));
    each(text, "  first effect: ECE, log score better by", s -> calibration(s.firstNamedClaims()));
    each(text, "  shrinkage claimed vs sealed, points", s -> median(s.shrinkErrors()));
    each(text, "  share of the oracle's removal", s -> median(s.removals()));
    each(text, "  first place: removable gap over rows", s -> median(s.density()));
    return text.toString();
  }

  private static String calibration(List<Calibration.Claim> claims) {
    return number(Calibration.expectedError(claims))
        + ", "
        + percent(Calibration.findBetterBy(claims));
  }

  private static String median(List<Double> values) {
    return values.isEmpty() ? "-" : number(Spread.median(values)) + " (n=" + values.size() + ")";
  }

  private static String number(double value) {
    return String.format(Locale.ROOT, "%.3f", value);
  }

  private static String percent(OptionalDouble share) {
    return share.isEmpty() ? "-" : String.format(Locale.ROOT, "%.0f%%", 100 * share.getAsDouble());
  }

  private void each(StringBuilder text, String name, Function<Scores, String> cell) {
    row(text, name, bySort.values().stream().map(cell).toList());
  }

  private static void row(StringBuilder text, String name, List<String> cells) {
    text.append(padded(name, NAME));
    cells.forEach(cell -> text.append(padded(cell, COLUMN)));
    text.append('\n');
  }

  private static String padded(String cell, int width) {
    return cell + " ".repeat(Math.max(1, width - cell.length()));
  }
}
