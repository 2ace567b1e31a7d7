package simbad.experiments.blindcheck;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import simbad.experiments.blindcheck.CheckScores.Estimate;

/** The scoring table for the console: what stands on the page's first screen. */
public final class CheckSummary {
  private CheckSummary() {}

  /** The lines, part by part. */
  public static List<String> lines(CheckScores scores) {
    List<String> lines = new ArrayList<>();
    for (String part : scores.parts()) {
      lines.add(part);
      lines.add(line("", "diagnosis", "95 % interval", "", "baseline", "oracle"));
      for (Measure measure : Measure.ALL.subList(0, Measure.FIRST)) {
        find(scores, part, CheckScores.DIAGNOSIS, measure)
            .ifPresent(found -> lines.add(line(scores, part, measure, found)));
      }
    }
    return lines;
  }

  private static Optional<Estimate> find(
      CheckScores scores, String part, String sort, Measure measure) {
    return scores.figures(part, sort).flatMap(measure.of());
  }

  private static String line(CheckScores scores, String part, Measure measure, Estimate found) {
    List<String> others =
        CheckScores.SORTS.stream()
            .skip(1)
            .map(sort -> find(scores, part, sort, measure))
            .map(other -> other.map(e -> measure.text(e.value())).orElse("-"))
            .toList();
    return line(
        measure.words(),
        measure.text(found.value()),
        measure.number(found.low()) + " to " + measure.number(found.high()),
        found.counted(),
        others.get(0),
        others.get(1));
  }

  private static String line(Object... cells) {
    return String.format(Locale.ROOT, "  %-52s %12s  %-17s %-14s %10s %10s", cells)
        .replace('\u00a0', ' ')
        .stripTrailing();
  }
}
