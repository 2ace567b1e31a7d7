package simbad.gap.calibrate.level;

import java.util.Arrays;
import java.util.OptionalDouble;
import java.util.function.IntPredicate;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;
import simbad.sonar.frame.Angles;
import simbad.sonar.ping.NearField;

/**
 * What an outline itself says of an obstacle's strength where its table says nothing: between two
 * of the table's bearings, and where a threshold is so short that it says "weak" and no more.
 * Kirchhoff's integral has the lobes, but not how strongly the material answers, and its dips are
 * too deep. Immutable.
 */
final class OutlineLobes {
  /** So much more or less than a straight line says is believed, as of near fields. */
  private static final double MOST_DB = 3;

  /** What is weak is believed to be so much weaker at most than a threshold could show. */
  private static final double MOST_WEAKER_DB = 10;

  /** Below that a sum has cancelled, which no real outline's does. */
  private static final double LEAST_DB = -60;

  private final NearField field;

  /** By the table's bearings, decibels of no common level. */
  private final double[] levelDb;

  private final OptionalDouble offsetDb;

  /**
   * Compares an outline with its table.
   *
   * @param field of the obstacle
   * @param points number of the table's bearings
   * @param tells whether a point of the table says how strong the obstacle is there
   * @param strengthDb what it says, decibels
   */
  OutlineLobes(NearField field, int points, IntPredicate tells, IntToDoubleFunction strengthDb) {
    this.field = field;
    levelDb = new double[points];
    Arrays.setAll(levelDb, this::levelDb);
    double[] apart =
        IntStream.range(0, points)
            .filter(tells)
            .mapToDouble(i -> strengthDb.applyAsDouble(i) - levelDb[i])
            .sorted()
            .toArray();
    offsetDb =
        apart.length == 0 ? OptionalDouble.empty() : OptionalDouble.of(apart[apart.length / 2]);
  }

  private double levelDb(double place) {
    double bearingRad = place * Angles.TURN_RAD / levelDb.length;
    return Math.max(LEAST_DB, field.believedDb(bearingRad % Angles.TURN_RAD));
  }

  /**
   * By how much it is stronger between two points of the table than a straight line says.
   *
   * @param place in points of the table
   * @return decibels, in [-3, 3]
   */
  double aboveLineDb(double place) {
    int cell = (int) place;
    double here = levelDb[cell % levelDb.length];
    double next = levelDb[(cell + 1) % levelDb.length];
    double above = levelDb(place) - here - (place - cell) * (next - here);
    return Math.max(-MOST_DB, Math.min(MOST_DB, above));
  }

  /**
   * By how much it is weaker at a point of the table than the shortest threshold that tells.
   *
   * @param point of the table
   * @param shortestDb the strength that such a threshold shows
   * @param unknownDb what is returned where the table tells nothing at all
   * @return decibels, in [-10, 0], or unknownDb
   */
  double weakerDb(int point, double shortestDb, double unknownDb) {
    if (offsetDb.isEmpty()) {
      return unknownDb;
    }
    double weaker = offsetDb.getAsDouble() + levelDb[point] - shortestDb;
    return Math.max(-MOST_WEAKER_DB, Math.min(0, weaker));
  }
}
