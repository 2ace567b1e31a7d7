package simbad.sonar.shape;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import simbad.sonar.frame.Angles;
import simbad.sonar.frame.Point;

/**
 * Detection thresholds by bearing: how far from an obstacle's centre a sensor just loses it.
 *
 * <p>Value i belongs to bearing i * 360 / n degrees in the obstacle's own frame. Between two values
 * the threshold is the radius of the straight edge between their points, as in the shadow's mesh
 * (not a mean of the radii). Immutable.
 */
public final class ThresholdTable {
  /** Fewer points enclose nothing. */
  public static final int LEAST_SIZE = 3;

  /** No ultrasonic sensor in air hears further, in metres; a larger number is a slip of units. */
  public static final double GREATEST_THRESHOLD_M = 100;

  /** As a share of the spacing: a bearing so near a table's bearing is that bearing, rounded. */
  private static final double ROUNDING = 1e-9;

  private final double[] thresholdM;
  private final double spacingRad;
  private final double sinSpacing;

  private ThresholdTable(double[] thresholdM) {
    this.thresholdM = thresholdM;
    spacingRad = Angles.TURN_RAD / thresholdM.length;
    sinSpacing = Math.sin(spacingRad);
  }

  /**
   * Creates a table.
   *
   * @param thresholdM metres, in [0, 100] each, at least 3; 0 means that nothing is ever heard
   *     there
   * @throws IllegalArgumentException for fewer values or one that is out of range
   */
  public static ThresholdTable of(double... thresholdM) {
    if (thresholdM.length < LEAST_SIZE) {
      throw new IllegalArgumentException(
          "thresholdM has " + thresholdM.length + " values; at least " + LEAST_SIZE);
    }
    for (double value : thresholdM) {
      if (!isThreshold(value)) {
        throw new IllegalArgumentException(
            "threshold = " + value + " is not in [0, " + GREATEST_THRESHOLD_M + "] m");
      }
    }
    return new ThresholdTable(thresholdM.clone());
  }

  /**
   * Creates a table of one threshold all round.
   *
   * @param size number of bearings, at least 3
   * @param threshold metres, in [0, 100]
   */
  public static ThresholdTable uniform(int size, double threshold) {
    double[] values = new double[size];
    Arrays.fill(values, threshold);
    return of(values);
  }

  /** Tells whether a value may stand in a table: in [0, 100] metres. */
  public static boolean isThreshold(double metres) {
    return metres >= 0 && metres <= GREATEST_THRESHOLD_M;
  }

  /** Returns the number of bearings. */
  public int size() {
    return thresholdM.length;
  }

  /** Returns the angle between two neighbouring bearings in radians. */
  public double spacingRad() {
    return spacingRad;
  }

  /**
   * Returns the bearing of a value in radians, in [0, 2 pi).
   *
   * @param index from 0
   */
  public double bearingRad(int index) {
    return index * spacingRad;
  }

  /**
   * Returns a value of the table in metres.
   *
   * @param index from 0
   */
  public double valueM(int index) {
    return thresholdM[index];
  }

  /** Returns all values in metres, in the order of their bearings. */
  public double[] valuesM() {
    return thresholdM.clone();
  }

  /** Returns the greatest value in metres; no point of the shadow is further from the centre. */
  public double greatestM() {
    return Arrays.stream(thresholdM).max().orElseThrow();
  }

  /**
   * Returns the threshold at any bearing: the radius there of the polygon whose corners are the
   * table's points.
   *
   * @param bearingRad in [0, 2 pi)
   * @return metres, at least 0
   * @throws IllegalArgumentException if the bearing is not in its interval
   */
  public double thresholdM(double bearingRad) {
    if (!(bearingRad >= 0 && bearingRad < Angles.TURN_RAD)) {
      throw new IllegalArgumentException("bearingRad = " + bearingRad + " is not in [0, 2 pi)");
    }
    double cells = bearingRad / spacingRad;
    double nearest = Math.rint(cells);
    if (Math.abs(cells - nearest) < ROUNDING) {
      return thresholdM[wrapped((int) nearest)];
    }
    int cell = (int) cells;
    double here = thresholdM[cell];
    double next = thresholdM[wrapped(cell + 1)];
    double past = (cells - cell) * spacingRad;
    if (here == 0 || next == 0) {
      return 0;
    }
    double chord = here * Math.sin(past) + next * Math.sin(spacingRad - past);
    return here * next * sinSpacing / chord;
  }

  private int wrapped(int index) {
    return index == thresholdM.length ? 0 : index;
  }

  /**
   * Returns the table's points in the obstacle's own frame, in the order of their bearings: (T sin
   * b, T cos b).
   */
  public List<Point> points() {
    List<Point> points = new ArrayList<>(size());
    for (int i = 0; i < size(); i++) {
      double bearing = bearingRad(i);
      points.add(new Point(thresholdM[i] * Math.sin(bearing), thresholdM[i] * Math.cos(bearing)));
    }
    return List.copyOf(points);
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof ThresholdTable that && Arrays.equals(thresholdM, that.thresholdM);
  }

  @Override
  public int hashCode() {
    return Arrays.hashCode(thresholdM);
  }

  @Override
  public String toString() {
    return "ThresholdTable" + Arrays.toString(thresholdM);
  }
}
