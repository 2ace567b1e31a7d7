package simbad.figures.blindcheck;

import java.util.OptionalDouble;
import simbad.experiments.blindcheck.CheckScores.Estimate;
import simbad.experiments.blindcheck.Measure;
import simbad.figures.page.Html;
import simbad.figures.page.Numbers;

/**
 * The cells of one figure: value, interval as numbers and as a bar, how counted, reached or not.
 */
final class ScoreCell {
  private static final double FULL_POINTS = 20;
  private static final double FULL_ERROR = 0.2;

  private ScoreCell() {}

  /** Value and interval, as numbers and as a bar. */
  static Html value(Measure measure, Estimate found, boolean off) {
    String interval = measure.number(found.low()) + " to " + measure.number(found.high());
    return Html.of(
        Html.strong(measure.text(found.value())),
        " ",
        Html.soft(interval),
        bar(measure, found, measure.reach(off)));
  }

  /** What is to be reached, and whether it was. */
  static Html reached(Measure measure, Estimate found, boolean off) {
    OptionalDouble reach = measure.reach(off);
    return reach.isPresent() ? reached(measure, found, reach.getAsDouble()) : Html.NONE;
  }

  private static Html reached(Measure measure, Estimate found, double reach) {
    boolean met = meets(measure, found.value(), reach);
    // An interval that holds what is to be reached leaves it open.
    boolean sure =
        met == meets(measure, found.low(), reach) && met == meets(measure, found.high(), reach);
    return Html.of(
        measure.isCost() ? "≤\u00a0" : "≥\u00a0",
        measure.text(reach),
        " ",
        met ? Html.styled("b", "met", "met") : Html.styled("b", "missed", "missed"),
        sure ? "" : ", not surely");
  }

  private static boolean meets(Measure measure, double value, double reach) {
    return measure.isCost() ? value <= reach : value >= reach;
  }

  private static Html bar(Measure measure, Estimate found, OptionalDouble reach) {
    Html mark = reach.isPresent() ? mark(measure, "reach", reach.getAsDouble()) : Html.NONE;
    double low = share(measure, found.low());
    double width = share(measure, found.high()) - low;
    Html span =
        Html.placed("i", "span", "left:" + Numbers.css(low) + ";width:" + Numbers.css(width));
    return Html.styled("span", "track", span, mark(measure, "dot", found.value()), mark);
  }

  private static Html mark(Measure measure, String style, double value) {
    return Html.placed("i", style, "left:" + Numbers.css(share(measure, value)));
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
