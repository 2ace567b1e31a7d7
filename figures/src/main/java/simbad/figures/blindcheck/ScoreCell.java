package simbad.figures.blindcheck;

import java.util.Locale;
import java.util.OptionalDouble;
import simbad.experiments.blindcheck.CheckScores.Estimate;
import simbad.experiments.blindcheck.Measure;

/**
 * The cells of one figure: value, interval as numbers and as a bar, how counted, reached or not.
 */
final class ScoreCell {
  private static final double FULL_POINTS = 20;
  private static final double FULL_ERROR = 0.2;

  private ScoreCell() {}

  static String of(Measure measure, Estimate found, boolean off) {
    OptionalDouble reach = measure.reach(off);
    return "<td><b>"
        + measure.text(found.value())
        + "</b> <span class=\"soft\">"
        + measure.number(found.low())
        + " to "
        + measure.number(found.high())
        + "</span>"
        + bar(measure, found, reach)
        + "</td><td class=\"soft\">"
        + found.counted()
        + "</td><td class=\"n\">"
        + (reach.isPresent() ? reached(measure, found, reach.getAsDouble()) : "")
        + "</td>";
  }

  private static String reached(Measure measure, Estimate found, double reach) {
    boolean met = meets(measure, found.value(), reach);
    // An interval that holds what is to be reached leaves it open.
    boolean sure =
        met == meets(measure, found.low(), reach) && met == meets(measure, found.high(), reach);
    return (measure.isCost() ? "&le;&nbsp;" : "&ge;&nbsp;")
        + measure.text(reach)
        + (met ? " <span class=\"met\">met" : " <span class=\"missed\">missed")
        + (sure ? "</span>" : "</span>, not surely");
  }

  private static boolean meets(Measure measure, double value, double reach) {
    return measure.isCost() ? value <= reach : value >= reach;
  }

  private static String bar(Measure measure, Estimate found, OptionalDouble reach) {
    String mark =
        reach.isPresent()
            ? "<i class=\"reach\" style=\"left:" + at(measure, reach.getAsDouble()) + "%\"></i>"
            : "";
    double low = share(measure, found.low());
    return "<div class=\"track\"><i class=\"span\" style=\"left:"
        + percent(low)
        + "%;width:"
        + percent(share(measure, found.high()) - low)
        + "%\"></i><i class=\"dot\" style=\"left:"
        + at(measure, found.value())
        + "%\"></i>"
        + mark
        + "</div>";
  }

  private static String at(Measure measure, double value) {
    return percent(share(measure, value));
  }

  private static String percent(double share) {
    return String.format(Locale.ROOT, "%.1f", 100 * share);
  }

  /** Where a value lies on the bar, from 0 to 1. */
  private static double share(Measure measure, double value) {
    double full =
        switch (measure.unit()) {
          case SHARE, FAULT, GAIN, AREA -> 1;
          case ERROR -> FULL_ERROR;
          case POINTS -> FULL_POINTS;
        };
    return Math.max(0, Math.min(1, value / full));
  }
}
