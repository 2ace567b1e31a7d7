package simbad.figures.batch;

import java.util.List;
import java.util.OptionalDouble;
import simbad.experiments.batch.BatchSurvey.Group;
import simbad.figures.page.AxisScale;
import simbad.figures.page.Graph;
import simbad.figures.page.Html;
import simbad.figures.page.Numbers;
import simbad.figures.page.PagePicture;
import simbad.figures.page.Svg;
import simbad.figures.page.Svg.Spot;

/** The errors round one obstacle: for each sensor a bar as long as the mean of its runs. */
final class ErrorBars {
  private static final String NOTHING = "\u2013";
  private static final double ROW = 26;
  private static final double BAR = 16;
  private static final double LEFT = 128;
  private static final double RIGHT = 70;
  private static final double BELOW = 48;
  private static final int MOST_LETTERS = 16;

  private final Svg svg;
  private final AxisScale scale;
  private final double bottom;

  private ErrorBars(String obstacle, List<Group> groups) {
    bottom = ROW * groups.size();
    svg = new Svg(Graph.WIDTH, (int) (bottom + BELOW), "Mean radial error round " + obstacle);
    scale =
        AxisScale.over(
            0, groups.stream().mapToDouble(group -> group.meanCm().orElse(0)).max().orElse(0), 4);
  }

  /** Returns the picture with its numbers. */
  static PagePicture of(String obstacle, List<Group> groups) {
    ErrorBars bars = new ErrorBars(obstacle, groups);
    bars.axis();
    for (int i = 0; i < groups.size(); i++) {
      bars.row(groups.get(i), ROW * i);
    }
    return new PagePicture(
        obstacle,
        bars.svg.html(),
        Html.of("Mean of the runs\u2019 mean radial errors."),
        Html.NONE);
  }

  private double x(double cm) {
    return LEFT + scale.share(cm) * (Graph.WIDTH - LEFT - RIGHT);
  }

  private void axis() {
    for (double tick : scale.ticks()) {
      svg.line(new Spot(x(tick), 0), new Spot(x(tick), bottom), "grid");
      svg.words(new Spot(x(tick), bottom + 18), "middle", scale.label(tick));
    }
    svg.words(new Spot(x(scale.high() / 2), bottom + 40), "middle", "mean radial error, cm");
  }

  private void row(Group group, double top) {
    double middle = top + ROW / 2 + 5;
    svg.words(new Spot(LEFT - 8, middle), "end", shortened(group.sensor()));
    String mean = number(group.meanCm());
    String tip =
        group.sensor() + ": mean " + mean + " cm, maximum " + number(group.maxCm()) + " cm";
    double length = x(group.meanCm().orElse(0)) - LEFT;
    svg.rectangle(
        new Spot(LEFT, top + (ROW - BAR) / 2), new Spot(Math.max(1, length), BAR), "after", tip);
    svg.words(new Spot(LEFT + length + 6, middle), "start", mean);
  }

  private static String shortened(String name) {
    return name.length() <= MOST_LETTERS ? name : name.substring(0, MOST_LETTERS - 1) + "…";
  }

  /** Returns centimetres, or a dash for nothing. */
  static String number(OptionalDouble cm) {
    return cm.isPresent() ? Numbers.fixed(cm.getAsDouble(), 2) : NOTHING;
  }
}
