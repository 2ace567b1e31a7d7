package simbad.scattering;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import simbad.sonar.level.Air;
import simbad.sonar.shape.Outline;
import simbad.sonar.shape.ThresholdTable;

/**
 * What is known of one obstacle's thresholds, to calibrate on.
 *
 * @param backscatter how it echoes
 * @param thresholdM by the index of their bearings, metres, positive; at least one
 */
public record KnownThresholds(Backscatter backscatter, Map<Integer, Double> thresholdM) {
  /** The bench of the thesis turned its obstacles in steps of 5 degrees. */
  public static final int BEARINGS = 72;

  /** One that is never heard counts as heard at the least distance that a bench can set. */
  private static final double LEAST_M = 0.01;

  /** Copies the map and checks what is in it. */
  public KnownThresholds {
    thresholdM = Map.copyOf(thresholdM);
    if (thresholdM.isEmpty()) {
      throw new IllegalArgumentException("thresholdM is empty; a calibration needs a threshold");
    }
    thresholdM.forEach((index, metres) -> check(backscatter, index, metres));
  }

  private static void check(Backscatter backscatter, int index, double metres) {
    if (!(index >= 0
        && index < backscatter.size()
        && metres > 0
        && ThresholdTable.isThreshold(metres))) {
      throw new IllegalArgumentException(
          "threshold = "
              + metres
              + " m at bearing number "
              + index
              + " is none of "
              + backscatter.size());
    }
  }

  /**
   * Takes all of a table that is not 0.
   *
   * @param outlines of the obstacle, in the table's frame
   * @param table its measured thresholds
   * @param air in which they were measured
   */
  public static KnownThresholds of(List<Outline> outlines, ThresholdTable table, Air air) {
    Map<Integer, Double> known = new TreeMap<>();
    for (int i = 0; i < table.size(); i++) {
      if (table.valueM(i) > 0) {
        known.put(i, table.valueM(i));
      }
    }
    return new KnownThresholds(Backscatter.of(outlines, air, table.size()), known);
  }

  /** Mean square of the logarithm of predicted over known. */
  double misfit(SonarEquation equation, double raisedDb) {
    double sum = 0;
    // In the order of the bearings: a sum in a map's own order would not be the same twice.
    for (int i = 0; i < backscatter.size(); i++) {
      Double known = thresholdM.get(i);
      if (known != null) {
        double predicted = equation.thresholdM(backscatter.levelDb(i) + raisedDb);
        double ratio = Math.log(Math.max(predicted, LEAST_M) / known);
        sum += ratio * ratio;
      }
    }
    return sum / thresholdM.size();
  }

  /** How many lie between the thresholds of echoes that are so much weaker and stronger. */
  int within(SonarEquation equation, double spreadDb, double slackM) {
    int count = 0;
    for (Map.Entry<Integer, Double> known : thresholdM.entrySet()) {
      double level = backscatter.levelDb(known.getKey());
      boolean low = known.getValue() >= equation.thresholdM(level - spreadDb) - slackM;
      boolean high = known.getValue() <= equation.thresholdM(level + spreadDb) + slackM;
      count += low && high ? 1 : 0;
    }
    return count;
  }

  int size() {
    return thresholdM.size();
  }
}
