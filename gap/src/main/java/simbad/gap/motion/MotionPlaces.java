package simbad.gap.motion;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.IntPredicate;
import java.util.function.ToDoubleFunction;
import simbad.gap.score.BenjaminiHochberg;
import simbad.motion.MotionRun;
import simbad.motion.forecast.Window;

/** Slices the windows of half a second into quarters along each axis, the worst first. */
final class MotionPlaces {
  private static final int SLICES = 4;
  private static final int LEAST_ROWS = 5;
  private static final int LEAST_BLOCKS = 5;
  private static final double BLOCK_S = 10;
  private static final String[] COMPONENTS = {"along", "across", "turn"};

  private final List<MotionRun> runs;
  private final MotionGap gap;
  private final double[][] before;
  private final double[][] after;
  private final List<MotionPlace> places = new ArrayList<>();
  private final List<Double> chances = new ArrayList<>();
  private final double total;

  private MotionPlaces(List<MotionRun> runs, MotionGap gap) {
    this.runs = runs;
    this.gap = gap;
    before = inUnits(gap.shortBefore());
    after = inUnits(gap.shortAfter());
    total = Arrays.stream(before).mapToDouble(row -> row[0] + row[1] + row[2]).sum();
  }

  static List<MotionPlace> of(List<MotionRun> runs, MotionGap gap) {
    MotionPlaces own = new MotionPlaces(runs, gap);
    new WindowAxes(runs).byName().forEach(own::slice);
    own.byRun();
    return own.sorted();
  }

  /** Scores in units of the nominal mean of each component, a third each. */
  private double[][] inUnits(double[][] scores) {
    double[][] units = new double[scores.length][3];
    for (int i = 0; i < units.length; i++) {
      for (int c = 0; c < 3; c++) {
        double mean = gap.before()[0][c];
        units[i][c] = mean > 0 ? scores[i][c] / mean / 3 : 0;
      }
    }
    return units;
  }

  private void slice(String axis, ToDoubleFunction<Window> value) {
    double[] values = gap.shortest().stream().mapToDouble(value).toArray();
    double[] sorted = values.clone();
    Arrays.sort(sorted);
    double from = sorted.length == 0 ? 0 : sorted[0];
    for (int s = 0; s < SLICES && sorted.length > SLICES; s++) {
      double low = from;
      double high = sorted[(int) ((s + 1L) * (sorted.length - 1) / SLICES)];
      boolean last = s == SLICES - 1;
      if (high > low || last) {
        add(axis, "", low, high, i -> values[i] >= low && (values[i] < high || last));
      }
      from = high;
    }
  }

  private void byRun() {
    for (int r = 0; r < runs.size() && runs.size() > 1; r++) {
      int run = r;
      add("run", runs.get(r).name(), 0, 0, i -> gap.shortest().get(i).run() == run);
    }
  }

  private void add(String axis, String name, double low, double high, IntPredicate in) {
    double[] was = new double[3];
    double is = 0;
    int rows = 0;
    Map<Long, Double> excess = new TreeMap<>();
    for (int i = 0; i < before.length; i++) {
      if (in.test(i)) {
        double off = 0;
        for (int c = 0; c < 3; c++) {
          was[c] += before[i][c];
          is += after[i][c];
          off += before[i][c] - after[i][c];
        }
        Window window = gap.shortest().get(i);
        long block = (long) Math.floor(window.startS() / BLOCK_S) * runs.size() + window.run();
        excess.merge(block, off, Double::sum);
        rows++;
      }
    }
    double sum = was[0] + was[1] + was[2];
    if (rows >= LEAST_ROWS && total > 0) {
      int worst = was[0] >= was[1] && was[0] >= was[2] ? 0 : was[1] >= was[2] ? 1 : 2;
      places.add(
          new MotionPlace(
              axis,
              name,
              low,
              high,
              rows,
              sum / total,
              sum / rows,
              is / rows,
              COMPONENTS[worst],
              1));
      chances.add(chance(excess.values().stream().mapToDouble(v -> v).toArray()));
    }
  }

  /** How probable it is that blocks are so much above 0 by chance. */
  private static double chance(double[] excess) {
    double mean = Arrays.stream(excess).average().orElse(0);
    double square = Arrays.stream(excess).map(v -> (v - mean) * (v - mean)).sum();
    if (excess.length < LEAST_BLOCKS || square == 0) {
      return 1;
    }
    double error = Math.sqrt(square / (excess.length - 1) / excess.length);
    return 1 - NormalChance.below(mean / error);
  }

  /** Returns the places, the largest share first, each with its q-value. */
  private List<MotionPlace> sorted() {
    double[] q = BenjaminiHochberg.falseDiscoveryRates(chances);
    for (int i = 0; i < q.length; i++) {
      MotionPlace p = places.get(i);
      places.set(
          i,
          new MotionPlace(
              p.axis(),
              p.name(),
              p.low(),
              p.high(),
              p.rows(),
              p.share(),
              p.before(),
              p.after(),
              p.component(),
              q[i]));
    }
    return places.stream()
        .sorted(Comparator.comparingDouble((MotionPlace place) -> -place.share()))
        .toList();
  }
}
