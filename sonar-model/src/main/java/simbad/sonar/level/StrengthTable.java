package simbad.sonar.level;

import java.util.Arrays;
import simbad.sonar.frame.Angles;

/**
 * Target strengths at even bearings: value i belongs to bearing i * 360 / n degrees in the
 * obstacle's own frame. Between two bearings it is straight in decibels. Immutable.
 */
public final class StrengthTable implements TargetStrength {
  /** Stronger or weaker, in decibels, is a slip of units. */
  public static final double GREATEST_DB = 300;

  private final double[] strengthDb;

  private StrengthTable(double[] strengthDb) {
    this.strengthDb = strengthDb;
  }

  /**
   * Creates a table.
   *
   * @param strengthDb decibels, in [-300, 300]; at least one value
   */
  public static StrengthTable of(double... strengthDb) {
    if (strengthDb.length == 0) {
      throw new IllegalArgumentException("strengthDb is empty; at least one value");
    }
    for (double value : strengthDb) {
      if (!isStrength(value)) {
        throw new IllegalArgumentException("strength = " + value + " is not in [-300, 300] dB");
      }
    }
    return new StrengthTable(strengthDb.clone());
  }

  /** Tells whether a value may stand in a table: in [-300, 300] dB. */
  public static boolean isStrength(double decibels) {
    return Math.abs(decibels) <= GREATEST_DB;
  }

  /** Returns the number of bearings. */
  public int size() {
    return strengthDb.length;
  }

  /** Returns all values in decibels, in the order of their bearings. */
  public double[] valuesDb() {
    return strengthDb.clone();
  }

  @Override
  public double strengthDb(double bearingRad) {
    if (!(bearingRad >= 0 && bearingRad < Angles.TURN_RAD)) {
      throw new IllegalArgumentException("bearingRad = " + bearingRad + " is not in [0, 2 pi)");
    }
    double cells = bearingRad / Angles.TURN_RAD * strengthDb.length;
    int cell = Math.min((int) cells, strengthDb.length - 1);
    double here = strengthDb[cell];
    double next = strengthDb[cell + 1 == strengthDb.length ? 0 : cell + 1];
    return here + (next - here) * (cells - cell);
  }

  @Override
  public double greatestDb() {
    return Arrays.stream(strengthDb).max().orElseThrow();
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof StrengthTable that && Arrays.equals(strengthDb, that.strengthDb);
  }

  @Override
  public int hashCode() {
    return Arrays.hashCode(strengthDb);
  }

  @Override
  public String toString() {
    return "StrengthTable" + Arrays.toString(strengthDb);
  }
}
