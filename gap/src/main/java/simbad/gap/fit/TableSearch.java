package simbad.gap.fit;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import simbad.sonar.effect.Forms;
import simbad.sonar.effect.Geometry;
import simbad.sonar.effect.OrientationShadow;
import simbad.sonar.shape.ThresholdTable;

/**
 * Reads a table of thresholds off a log: for each bearing the distance that parts the pings that
 * were answered from those that were not, with neighbours held together where few pings speak.
 */
final class TableSearch {
  private static final double SOFT_M = 0.06;
  private static final double STEP_M = 0.05;
  private static final double HOLD = 2;

  /** Of bearings that no ping speaks for any value between their neighbours would do. */
  private static final double MIDDLE = 0.1;

  private static final int ROUNDS = 3;
  private static final int BESIDE_ROUNDS = 2;

  /** Far off it is open how far a threshold goes. */
  private static final double MOST_FACTOR = 1.5;

  private final LogClues clues;
  private final Hearing hearing;
  private final int obstacle;
  private final int size = Forms.TABLE_SIZE;
  private final double uniformM;

  /**
   * The tables of some obstacles by their indices, one behind the other. Of several, each is read
   * off what the others leave, once with what is believed of them and once with theirs.
   */
  static double[] tables(LogClues clues, int... obstacles) {
    Map<Integer, double[]> found = new TreeMap<>();
    for (int round = 0; round < Math.min(obstacles.length, BESIDE_ROUNDS); round++) {
      for (int obstacle : obstacles) {
        List<OrientationShadow> others =
            found.entrySet().stream()
                .filter(other -> other.getKey() != obstacle)
                .map(other -> clues.shadow(other.getKey(), ThresholdTable.of(other.getValue())))
                .toList();
        found.put(obstacle, new TableSearch(clues, others, obstacle).table());
      }
    }
    return found.values().stream().flatMapToDouble(Arrays::stream).toArray();
  }

  /** Of an obstacle by its index, the others being as believed. */
  TableSearch(LogClues clues, int obstacle) {
    this(clues, List.of(), obstacle);
  }

  private TableSearch(LogClues clues, List<OrientationShadow> others, int obstacle) {
    this.clues = clues;
    this.obstacle = obstacle;
    hearing = new Hearing(clues, others, obstacle);
    uniformM = clues.setup().scene().obstacles().get(obstacle).detection().greatestM();
  }

  /** The table over the believed threshold, less 1, as a Fourier series. */
  double[] waves() {
    double[] table = table();
    double[] series = new double[1 + 2 * Forms.SHADOW_WAVES];
    for (int i = 0; i < size; i++) {
      double angle = 2 * Math.PI * i / size;
      double off = (Math.min(MOST_FACTOR, table[i] / uniformM) - 1) / size;
      series[0] += off;
      for (int wave = 1; wave <= Forms.SHADOW_WAVES; wave++) {
        series[2 * wave - 1] += 2 * off * Math.cos(wave * angle);
        series[2 * wave] += 2 * off * Math.sin(wave * angle);
      }
    }
    return series;
  }

  double[] table() {
    double greatest = greatestDistance();
    int candidates = (int) (greatest / STEP_M) + 2;
    double[][] score = new double[size][candidates];
    tally(score);
    double[] table = new double[size];
    Arrays.fill(table, Math.min(uniformM, greatest));
    for (int round = 0; round < ROUNDS; round++) {
      for (int i = 0; i < size; i++) {
        double left = table[(i + size - 1) % size];
        double right = table[(i + 1) % size];
        table[i] = bestOf(score[i], left, right);
      }
    }
    new TableSweep(clues, hearing, obstacle).improve(table, greatest);
    return table;
  }

  private double greatestDistance() {
    Geometry g = clues.geometry;
    return clues
        .inCone(obstacle)
        .mapToDouble(ping -> g.centreDistanceM(ping * g.obstacles() + obstacle))
        .max()
        .orElse(0);
  }

  private void tally(double[][] score) {
    Geometry g = clues.geometry;
    for (int ping : clues.inCone(obstacle).toArray()) {
      int line = ping * g.obstacles() + obstacle;
      int cell = (int) Math.rint(g.bearingRad(line) / (2 * Math.PI) * size) % size;
      for (int k = 0; k < score[cell].length; k++) {
        double beyond = (g.centreDistanceM(line) - k * STEP_M) / SOFT_M;
        score[cell][k] += hearing.logLikelihood(ping, 1 / (1 + Math.exp(beyond)));
      }
    }
  }

  private static double bestOf(double[] score, double left, double right) {
    int best = 0;
    double most = Double.NEGATIVE_INFINITY;
    for (int k = 0; k < score.length; k++) {
      double away = Math.abs(k * STEP_M - left) + Math.abs(k * STEP_M - right);
      double aside = Math.abs(k * STEP_M - (left + right) / 2);
      double value = score[k] - HOLD * away - MIDDLE * aside;
      if (value > most) {
        most = value;
        best = k;
      }
    }
    return best * STEP_M;
  }
}
