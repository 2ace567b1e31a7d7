package simbad.gap.fit;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import simbad.sonar.effect.Geometry;
import simbad.sonar.shape.ThresholdTable;

/**
 * Improves a table of thresholds value by value: each is moved to where the readings of the
 * bearings on both sides of it are most probable, the table being straight between its points.
 */
final class TableSweep {
  private static final int SWEEPS = 4;
  private static final double[] MOVES_M = {
    -0.8, -0.4, -0.2, -0.1, -0.05, -0.02, -0.01, 0.01, 0.02, 0.05, 0.1, 0.2, 0.4, 0.8
  };

  /** Against needless zigzag, nats for each metre that a value stands off its neighbours. */
  private static final double HOLD = 1.2;

  /**
   * The same for the logarithm of their ratio, against a hole or a spike on the word of one ping:
   * near the obstacle a metre counts for little.
   */
  private static final double RATIO_HOLD = 1;

  /** Of smaller thresholds a ratio says nothing, metres. */
  private static final double NEAR_M = 0.02;

  /**
   * In the body of any obstacle, metres. A value of 0 would silence the bearings on both sides as
   * well, whatever their own is, so that neither of two neighbours at 0 could leave it alone.
   */
  private static final double LEAST_M = 0.005;

  private final LogClues clues;
  private final Hearing hearing;
  private final int obstacle;
  private final double edgeM;

  TableSweep(LogClues clues, Hearing hearing, int obstacle) {
    this.clues = clues;
    this.hearing = hearing;
    this.obstacle = obstacle;
    edgeM = Math.max(0.01, clues.edgeWidthM());
  }

  void improve(double[] table, double greatestM) {
    List<List<Integer>> cells = cells(table.length);
    Arrays.setAll(table, i -> Math.max(LEAST_M, table[i]));
    for (int sweep = 0; sweep < SWEEPS; sweep++) {
      for (int i = 0; i < table.length; i++) {
        improve(table, i, greatestM, cells);
      }
    }
  }

  /** Pings by the cell between two bearings that theirs lies in. */
  private List<List<Integer>> cells(int size) {
    List<List<Integer>> cells = new ArrayList<>();
    for (int i = 0; i < size; i++) {
      cells.add(new ArrayList<>());
    }
    Geometry g = clues.geometry;
    for (int ping : clues.inCone(obstacle).toArray()) {
      int line = ping * g.obstacles() + obstacle;
      cells.get((int) (g.bearingRad(line) / (2 * Math.PI) * size) % size).add(ping);
    }
    return cells;
  }

  private void improve(double[] table, int i, double greatestM, List<List<Integer>> cells) {
    int before = (i + table.length - 1) % table.length;
    double start = table[i];
    double bestValue = start;
    double best = merit(table, before, i, cells);
    for (double move : MOVES_M) {
      table[i] = Math.max(LEAST_M, Math.min(greatestM + 0.5, start + move));
      double merit = merit(table, before, i, cells);
      if (merit > best) {
        best = merit;
        bestValue = table[i];
      }
    }
    table[i] = bestValue;
  }

  private double merit(double[] table, int before, int at, List<List<Integer>> cells) {
    ThresholdTable thresholds = ThresholdTable.of(table);
    int after = (at + 1) % table.length;
    return likelihood(thresholds, cells.get(before))
        + likelihood(thresholds, cells.get(at))
        - zigzag(table[at], table[before])
        - zigzag(table[at], table[after]);
  }

  private static double zigzag(double oneM, double otherM) {
    return HOLD * Math.abs(oneM - otherM)
        + RATIO_HOLD * Math.abs(Math.log((oneM + NEAR_M) / (otherM + NEAR_M)));
  }

  private double likelihood(ThresholdTable thresholds, List<Integer> pings) {
    double sum = 0;
    Geometry g = clues.geometry;
    for (int ping : pings) {
      int line = ping * g.obstacles() + obstacle;
      double beyond = g.centreDistanceM(line) - thresholds.thresholdM(g.bearingRad(line));
      sum += hearing.logLikelihood(ping, 1 / (1 + Math.exp(beyond / edgeM)));
    }
    return sum;
  }
}
