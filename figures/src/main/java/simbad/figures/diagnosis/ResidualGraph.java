package simbad.figures.diagnosis;

import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.DoubleStream;
import simbad.figures.diagnosis.RowFinding.Fit;
import simbad.figures.page.AxisScale;
import simbad.figures.page.Graph;
import simbad.figures.page.Html;
import simbad.figures.page.Numbers;

/** How readings lie in their forecasts, before and after: as histograms. */
final class ResidualGraph {
  private static final int PIT_BINS = 20;
  private static final int RANGE_BINS = 24;

  /** Of the residuals; the few beyond it are counted in the last bins. */
  private static final double SHOWN = 0.98;

  private ResidualGraph() {}

  /** Where in its forecast each reading lies: level at 1 when the forecasts hold. */
  static Html ranks(List<RowFinding> rows) {
    double[] before = counts(rows, row -> row.before().pit() * PIT_BINS, PIT_BINS);
    double[] after = counts(rows, row -> row.after().pit() * PIT_BINS, PIT_BINS);
    double most = Math.max(max(before), max(after)) * PIT_BINS / rows.size();
    Graph graph =
        new Graph(
            "Ranks of the readings in their forecasts",
            new AxisScale(0, 1, 0.2),
            AxisScale.over(0, Math.max(most, 1.5), 4));
    graph.axes("rank of the reading in its forecast", "rows, 1 = as forecast");
    bars(
        graph, new AxisScale(0, 1, 1.0 / PIT_BINS), before, after, (double) PIT_BINS / rows.size());
    graph.level(1, "floor");
    return graph.html();
  }

  /** How far echoes lie from the median of those expected; nothing where there are too few. */
  static Optional<Html> ranges(List<RowFinding> rows) {
    double[] before = residuals(rows, RowFinding::before);
    double[] after = residuals(rows, RowFinding::after);
    if (before.length < RANGE_BINS || after.length < RANGE_BINS) {
      return Optional.empty();
    }
    double reach = Math.max(reach(before), Math.max(reach(after), 0.5));
    AxisScale x = AxisScale.over(-reach, reach, 6);
    double most = Math.max(max(shares(before, x)), max(shares(after, x)));
    Graph graph = new Graph("Residuals of the ranges", x, AxisScale.over(0, most, 4));
    graph.axes("reading minus expected echo, cm (end bins: beyond)", "share of echoes, %");
    AxisScale bins = new AxisScale(x.low(), x.high(), (x.high() - x.low()) / RANGE_BINS);
    bars(graph, bins, shares(before, x), shares(after, x), 1);
    return Optional.of(graph.html());
  }

  private static void bars(
      Graph graph, AxisScale bins, double[] before, double[] after, double scale) {
    for (int i = 0; i < before.length; i++) {
      double from = bins.low() + i * bins.step();
      double to = from + bins.step();
      double middle = (from + to) / 2;
      double margin = bins.step() * 0.06;
      String where = Numbers.number(from) + " to " + Numbers.number(to) + ": ";
      double gone = before[i] * scale;
      double left = after[i] * scale;
      graph.bar(from + margin, middle, gone, "before", where + "before " + Numbers.fixed(gone, 2));
      graph.bar(middle, to - margin, left, "after", where + "after " + Numbers.fixed(left, 2));
    }
  }

  private static double[] residuals(List<RowFinding> rows, Function<RowFinding, Fit> fit) {
    return rows.stream()
        .map(fit)
        .filter(one -> one.residualCm().isPresent())
        .mapToDouble(one -> one.residualCm().getAsDouble())
        .toArray();
  }

  private static double reach(double[] residuals) {
    return RowSurvey.quantile(DoubleStream.of(residuals).map(Math::abs).toArray(), SHOWN);
  }

  /** Percent of the residuals in each bin; those beyond the axis in the last ones. */
  private static double[] shares(double[] residuals, AxisScale x) {
    double[] shares = new double[RANGE_BINS];
    for (double residual : residuals) {
      int bin = (int) Math.floor(x.share(residual) * RANGE_BINS);
      shares[Math.max(0, Math.min(RANGE_BINS - 1, bin))] += 100.0 / residuals.length;
    }
    return shares;
  }

  private static double[] counts(
      List<RowFinding> rows, Function<RowFinding, Double> place, int bins) {
    double[] counts = new double[bins];
    rows.forEach(row -> counts[(int) Math.max(0, Math.min(bins - 1, place.apply(row)))]++);
    return counts;
  }

  private static double max(double[] values) {
    return DoubleStream.of(values).max().orElse(0);
  }
}
