package simbad.sonar.ping;

import java.util.Arrays;
import simbad.sonar.check.Checks;
import simbad.sonar.frame.Angles;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.shape.Outline;

/**
 * From where on an obstacle its echo comes, and how much stronger or weaker it is near by than its
 * strength says. A strength is that of a distance: near by, less of a flat side lies within one
 * wave of its nearest point, and its parts no longer add up.
 *
 * <p>Computed by Kirchhoff's integral round the outline: each piece that faces the sensor answers
 * in proportion to the cosine of its angle, with the phase of its distance there and back. The
 * echo's place is the mean direction of what adds up, its level the sum's, both over the band of a
 * burst. The integral leaves out what bends round corners and is reflected twice, so the dips of
 * its level are too deep: more than 3 dB is not believed. It knows nothing of height.
 *
 * <p>Values are computed when they are first asked for. Two threads that compute one find the same.
 */
public final class NearField {
  /** Of references that were not fitted on, as much as this makes most likely. */
  private static final double MOST_DB = 3;

  /** Even bearings at which it is known, from 0 on. */
  private static final int BEARINGS = 144;

  /** Distances to the centre at which it is known, metres; constant before and behind. */
  private static final double[] DISTANCE_M = {
    0.1, 0.14, 0.2, 0.28, 0.4, 0.56, 0.8, 1.13, 1.6, 2.26, 3.2, 4.53
  };

  private static final double LEAST_REFERENCE_M = 0.2;

  /**
   * Half of the band in which a burst of eight periods has its energy, as a share of the carrier.
   */
  private static final double BAND = 0.1;

  private static final int WAVES = 5;
  private static final double PIECES_PER_WAVE = 5;
  private static final double LEAST_POWER = 1e-12;

  private final Obstacle obstacle;
  private final double[] offCentreRad = new double[BEARINGS * DISTANCE_M.length];
  private final double[] addedDb = new double[offCentreRad.length];

  /** Of the echo from the distance at which the strength is believed, by bearing. */
  private final double[] believedDb = new double[BEARINGS];

  private final Pieces pieces;

  /**
   * Prepares the near field of an obstacle.
   *
   * @param obstacle its outline, and its thresholds: at their distance its strength is believed
   * @param wavenumberPerM of the carrier, radians per metre
   */
  public NearField(Obstacle obstacle, double wavenumberPerM) {
    Checks.positive("wavenumberPerM", wavenumberPerM);
    this.obstacle = obstacle;
    pieces = new Pieces(obstacle.outline(), wavenumberPerM);
    Arrays.fill(offCentreRad, Double.NaN);
    Arrays.fill(addedDb, Double.NaN);
    Arrays.fill(believedDb, Double.NaN);
  }

  /** Returns the distances to the centre at which it is known, rising, metres. */
  static double[] distancesM() {
    return DISTANCE_M.clone();
  }

  /**
   * Returns the level of the echo from the distance at which the strength is believed: that of the
   * obstacle's threshold. Of no common level: its differences between bearings are those of
   * strengths, but for dips that are too deep.
   *
   * @param bearingRad of the sensor in the obstacle's own frame, in [0, 2 pi]
   * @return decibels
   */
  public double believedDb(double bearingRad) {
    double lostM = obstacle.detection().thresholdM(bearingRad);
    double furthestM = DISTANCE_M[DISTANCE_M.length - 1];
    double atM = Math.max(LEAST_REFERENCE_M, Math.min(furthestM, lostM));
    return pieces.echo(bearingRad, atM).levelDb;
  }

  /**
   * Returns the direction from which the echo comes.
   *
   * @param bearingRad of the sensor in the obstacle's own frame, in [0, 2 pi]
   * @param distanceM from the sensor to the obstacle's centre, positive
   * @return angle from the direction of the centre, radians, positive counter-clockwise
   */
  public double offCentreRad(double bearingRad, double distanceM) {
    return at(offCentreRad, bearingRad, distanceM);
  }

  /**
   * Returns by how much the echo is stronger than the strength at this bearing says, which is
   * believed of the threshold's distance.
   *
   * @param bearingRad of the sensor in the obstacle's own frame, in [0, 2 pi]
   * @param distanceM from the sensor to the obstacle's centre, positive
   * @return decibels, in [-3, 3]
   */
  public double addedDb(double bearingRad, double distanceM) {
    return at(addedDb, bearingRad, distanceM);
  }

  /** Straight between its values, over the bearing and over the distance. */
  private double at(double[] values, double bearingRad, double distanceM) {
    double turn = bearingRad / Angles.TURN_RAD * BEARINGS;
    int here = (int) turn % BEARINGS;
    int next = (here + 1) % BEARINGS;
    double share = turn - (int) turn;
    int near = 0;
    while (near < DISTANCE_M.length - 2 && distanceM > DISTANCE_M[near + 1]) {
      near++;
    }
    double way = (distanceM - DISTANCE_M[near]) / (DISTANCE_M[near + 1] - DISTANCE_M[near]);
    double first = between(value(values, here, near), value(values, next, near), share);
    double second = between(value(values, here, near + 1), value(values, next, near + 1), share);
    return between(first, second, Math.max(0, Math.min(1, way)));
  }

  private static double between(double from, double to, double share) {
    return from + share * (to - from);
  }

  private double value(double[] values, int bearing, int distance) {
    int cell = bearing * DISTANCE_M.length + distance;
    double known = values[cell];
    if (Double.isNaN(known)) {
      double bearingRad = bearing * Angles.TURN_RAD / BEARINGS;
      Echo echo = pieces.echo(bearingRad, DISTANCE_M[distance]);
      double added = echo.levelDb - believedDb(bearing, bearingRad);
      offCentreRad[cell] = echo.offCentreRad;
      addedDb[cell] = Math.max(-MOST_DB, Math.min(MOST_DB, added));
      known = values[cell];
    }
    return known;
  }

  private double believedDb(int bearing, double bearingRad) {
    double known = believedDb[bearing];
    if (Double.isNaN(known)) {
      known = believedDb(bearingRad);
      believedDb[bearing] = known;
    }
    return known;
  }

  /**
   * One echo.
   *
   * @param offCentreRad by how much it comes from the left of the line to the centre
   * @param levelDb its level, of no distance
   */
  private record Echo(double offCentreRad, double levelDb) {}

  /** Short pieces of an outline, in its own frame. */
  private static final class Pieces {
    private final double[] xM;
    private final double[] zM;
    private final double[] outX;
    private final double[] outZ;
    private final double wavenumberPerM;

    Pieces(Outline outline, double wavenumberPerM) {
      this.wavenumberPerM = wavenumberPerM;
      double longestM = Angles.TURN_RAD / wavenumberPerM / PIECES_PER_WAVE;
      double sense = -Math.signum(outline.signedAreaM2());
      double[][] all = new double[4][0];
      int from = outline.size() - 1;
      for (int to = 0; to < outline.size(); to++) {
        double edgeX = outline.xM(to) - outline.xM(from);
        double edgeZ = outline.zM(to) - outline.zM(from);
        int count = (int) Math.ceil(Math.sqrt(edgeX * edgeX + edgeZ * edgeZ) / longestM);
        int first = all[0].length;
        for (int i = 0; i < all.length; i++) {
          all[i] = Arrays.copyOf(all[i], first + count);
        }
        for (int i = 0; i < count; i++) {
          double share = (i + 0.5) / count;
          all[0][first + i] = outline.xM(from) + share * edgeX;
          all[1][first + i] = outline.zM(from) + share * edgeZ;
          // As long as the piece.
          all[2][first + i] = sense * edgeZ / count;
          all[3][first + i] = -sense * edgeX / count;
        }
        from = to;
      }
      xM = all[0];
      zM = all[1];
      outX = all[2];
      outZ = all[3];
    }

    Echo echo(double bearingRad, double distanceM) {
      Sum sum = new Sum();
      double sightX = -Math.sin(bearingRad);
      double sightZ = -Math.cos(bearingRad);
      for (int i = 0; i < xM.length; i++) {
        double awayX = xM[i] + distanceM * sightX;
        double awayZ = zM[i] + distanceM * sightZ;
        double away = Math.sqrt(awayX * awayX + awayZ * awayZ);
        double facing = -(awayX * outX[i] + awayZ * outZ[i]) / away;
        if (facing > 0) {
          double across = sightZ * awayX - sightX * awayZ;
          double along = sightX * awayX + sightZ * awayZ;
          double way = 2 * wavenumberPerM * (away - distanceM);
          sum.add(facing * distanceM / away, way, Math.atan2(across, along));
        }
      }
      return sum.echo();
    }
  }

  /** What the pieces add up to at each frequency of the band. */
  private static final class Sum {
    private final double[] real = new double[WAVES];
    private final double[] imaginary = new double[WAVES];
    private final double[] realSide = new double[WAVES];
    private final double[] imaginarySide = new double[WAVES];
    private double leftRad = Double.NEGATIVE_INFINITY;
    private double rightRad = Double.POSITIVE_INFINITY;

    void add(double weight, double phaseRad, double sideRad) {
      leftRad = Math.max(leftRad, sideRad);
      rightRad = Math.min(rightRad, sideRad);
      for (int wave = 0; wave < WAVES; wave++) {
        double phase = phaseRad * (1 + BAND * (2.0 * wave / (WAVES - 1) - 1));
        double inPhase = weight * Math.cos(phase);
        double behind = weight * Math.sin(phase);
        real[wave] += inPhase;
        imaginary[wave] += behind;
        realSide[wave] += inPhase * sideRad;
        imaginarySide[wave] += behind * sideRad;
      }
    }

    Echo echo() {
      double power = 0;
      double moment = 0;
      for (int wave = 0; wave < WAVES; wave++) {
        power += real[wave] * real[wave] + imaginary[wave] * imaginary[wave];
        moment += real[wave] * realSide[wave] + imaginary[wave] * imaginarySide[wave];
      }
      if (!(power > 0)) {
        return new Echo(0, 10 * Math.log10(LEAST_POWER));
      }
      // Of waves that all but cancel, the mean may lie beside the obstacle.
      double side = Math.max(rightRad, Math.min(leftRad, moment / power));
      return new Echo(side, 10 * Math.log10(Math.max(LEAST_POWER, power)));
    }
  }
}
