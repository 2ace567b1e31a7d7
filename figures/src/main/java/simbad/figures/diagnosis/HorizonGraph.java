package simbad.figures.diagnosis;

import java.util.List;
import simbad.figures.page.AxisScale;
import simbad.figures.page.ChartAxis;
import simbad.figures.page.Graph;
import simbad.figures.page.Html;
import simbad.gap.motion.MotionDiagnosis;

/** How a component's score grows with the time that is forecast, before and after. */
final class HorizonGraph {
  private static final double MARGIN = 0.2;

  private HorizonGraph() {}

  static Html of(String name, MotionPage.Shown shown, MotionDiagnosis.Gap gap, int component) {
    double most = 0;
    for (int h = 0; h < MotionPage.HORIZONS.length; h++) {
      double larger = Math.max(gap.before()[h][component], gap.after()[h][component]);
      most = Math.max(most, shown.times() * larger);
    }
    Graph graph =
        new Graph(
            "Score " + name + ", before and after", new Horizons(), AxisScale.over(0, most, 4));
    graph.axes(
        "forecast over, s",
        "score, " + (shown.unit().equals("°") ? "degrees" : shown.unit().replace("\u00a0", "")));
    for (int h = 0; h < MotionPage.HORIZONS.length; h++) {
      bar(graph, h + MARGIN, "before", shown, gap.before()[h][component]);
      bar(graph, h + 0.5, "after", shown, gap.after()[h][component]);
    }
    return graph.html();
  }

  private static void bar(
      Graph graph, double from, String style, MotionPage.Shown shown, double value) {
    String seconds = MotionPage.HORIZONS[(int) from];
    graph.bar(
        from,
        from + 0.5 - MARGIN,
        shown.times() * value,
        style,
        seconds + " s, " + style + ": " + shown.words(value));
  }

  /** A place for each, its label in the middle. */
  private record Horizons() implements ChartAxis {
    @Override
    public double share(double value) {
      return value / MotionPage.HORIZONS.length;
    }

    @Override
    public List<Double> ticks() {
      return List.of(0.5, 1.5, 2.5);
    }

    @Override
    public String label(double tick) {
      return MotionPage.HORIZONS[(int) tick];
    }
  }
}
