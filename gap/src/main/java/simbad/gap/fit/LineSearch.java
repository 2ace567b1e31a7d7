package simbad.gap.fit;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.stream.DoubleStream;
import simbad.sonar.effect.Clues.Line;
import simbad.sonar.effect.PingLog;

/**
 * Looks for lines on which echoes lie over the readings before them: for each slope the shift that
 * most of them agree on, and of all slopes those that most do.
 */
final class LineSearch {
  private static final double LEAST_SLOPE = 0.1;
  private static final double GREATEST_SLOPE = 2.2;
  private static final double SLOPE_STEP = 0.02;
  private static final double APART = 0.1;
  private static final double WIDTH_M = 0.02;
  private static final int BEST = 3;

  private final PingLog log;
  private final int[] echoes;

  LineSearch(PingLog log, int... echoes) {
    this.log = log;
    this.echoes = echoes;
  }

  /** Returns the lines with most votes, none of nearly the slope of a better one. */
  List<Line> best() {
    List<Line> all = new ArrayList<>();
    for (double slope = LEAST_SLOPE; slope <= GREATEST_SLOPE; slope += SLOPE_STEP) {
      all.add(fullest(slope));
    }
    all.sort(Comparator.comparingInt(line -> -line.votes()));
    List<Line> best = new ArrayList<>();
    for (Line line : all) {
      if (best.size() < BEST
          && line.votes() > 0
          && best.stream().noneMatch(other -> Math.abs(other.slope() - line.slope()) < APART)) {
        best.add(line);
      }
    }
    return best;
  }

  private Line fullest(double slope) {
    double[] shifts = shifts(slope).sorted().toArray();
    int from = 0;
    Line best = new Line(slope, 0, 0);
    for (int to = 0; to < shifts.length; to++) {
      while (shifts[to] - shifts[from] > WIDTH_M) {
        from++;
      }
      if (to - from + 1 > best.votes()) {
        best = new Line(slope, (shifts[from] + shifts[to]) / 2, to - from + 1);
      }
    }
    return best;
  }

  private DoubleStream shifts(double slope) {
    return Arrays.stream(echoes).mapToDouble(i -> slope * log.rangeM(i - 1) - log.rangeM(i));
  }
}
