package simbad.figures.diagnosis;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Function;
import simbad.figures.page.AxisScale;
import simbad.figures.page.Graph;
import simbad.figures.page.Html;
import simbad.figures.page.Numbers;

/** The mean gap before and after, by some quantity of the rows, in bins of one width. */
final class GapGraph {
  private static final int BINS = 12;
  private static final int TICKS = 6;
  private static final int LEAST_ROWS = 3;

  /** Shares of a bin's width at which its two bars begin and end. */
  private static final double[] BARS = {0.08, 0.5, 0.92};

  private record Bin(int rows, double beforeCm, double afterCm) {}

  private GapGraph() {}

  /**
   * Draws the graph.
   *
   * @param title of the x axis with its unit
   * @param least below which a difference in the quantity says nothing
   * @param rows to draw
   * @param quantity of a row; rows without it are left out
   * @return nothing where the quantity is the same in all rows
   */
  static Optional<Html> of(
      String title,
      double least,
      List<RowFinding> rows,
      Function<RowFinding, OptionalDouble> quantity) {
    List<RowFinding> with = rows.stream().filter(row -> quantity.apply(row).isPresent()).toList();
    double[] values =
        with.stream().mapToDouble(row -> quantity.apply(row).getAsDouble()).sorted().toArray();
    if (values.length == 0 || values[values.length - 1] - values[0] < least) {
      return Optional.empty();
    }
    double width = AxisScale.roundStep((values[values.length - 1] - values[0]) / BINS);
    AxisScale x = AxisScale.over(values[0], values[values.length - 1], TICKS);
    List<Bin> bins = new ArrayList<>();
    int count = (int) Math.max(1, Math.round((x.high() - x.low()) / width));
    for (int i = 0; i < count; i++) {
      double from = x.low() + i * width;
      boolean last = i == count - 1;
      bins.add(
          bin(
              with.stream()
                  .filter(row -> quantity.apply(row).getAsDouble() >= from)
                  .filter(row -> last || quantity.apply(row).getAsDouble() < from + width)
                  .toList()));
    }
    return Optional.of(draw(title, x, width, bins));
  }

  private static Bin bin(List<RowFinding> rows) {
    return new Bin(
        rows.size(),
        rows.stream().mapToDouble(row -> row.before().gapCm()).average().orElse(0),
        rows.stream().mapToDouble(row -> row.after().gapCm()).average().orElse(0));
  }

  private static Html draw(String title, AxisScale x, double width, List<Bin> bins) {
    double most =
        bins.stream()
            .filter(bin -> bin.rows() >= LEAST_ROWS)
            .mapToDouble(bin -> Math.max(bin.beforeCm(), bin.afterCm()))
            .max()
            .orElse(1);
    Graph graph = new Graph("Mean gap by " + title, x, AxisScale.over(0, Math.max(most, 1e-3), 4));
    graph.axes(title, "mean gap, cm");
    for (int i = 0; i < bins.size(); i++) {
      Bin bin = bins.get(i);
      if (bin.rows() >= LEAST_ROWS) {
        double from = x.low() + i * width;
        String where =
            x.label(from) + " to " + x.label(from + width) + ", " + bin.rows() + " rows: ";
        graph.bar(
            from + BARS[0] * width,
            from + BARS[1] * width,
            bin.beforeCm(),
            "before",
            where + "before " + Numbers.fixed(bin.beforeCm(), 2) + " cm");
        graph.bar(
            from + BARS[1] * width,
            from + BARS[2] * width,
            bin.afterCm(),
            "after",
            where + "after " + Numbers.fixed(bin.afterCm(), 2) + " cm");
      }
    }
    return graph.html();
  }
}
