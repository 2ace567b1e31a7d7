package simbad.gap.calibrate;

import java.util.Arrays;
import org.hipparchus.linear.ArrayRealVector;
import org.hipparchus.linear.MatrixUtils;
import org.hipparchus.linear.RealMatrix;
import simbad.sonar.effect.Geometry;
import simbad.sonar.effect.LevelForms;
import simbad.sonar.frame.Angles;

/**
 * How far a reference leaves the level law open: by how many nats a log would be likelier if the
 * set-up moved as far as that allows. All rows of a log see the same set-up, so that more rows do
 * not make what it is off by an effect. The move is the most probable one under a normal
 * distribution of the values, with the log's information by its scores (Berndt, Hall, Hall and
 * Hausman 1974).
 */
public final class Leeway {
  /** Half of what differs from one day to the next (docs/method/level-model.md). */
  private static final double DAYS_GAIN_DB = 0.15;

  private static final double DAYS_ABSORPTION_DB_PER_M = 0.05;
  private static final double DAYS_TURN_RAD = Math.toRadians(0.25);
  private static final double DAYS_PLACE_M = 0.002;
  private static final double DAYS_AIR = 0.0009;

  /** An obstacle's echo path is the same over so wide a sector. */
  private static final int SECTORS = 24;

  /** What was read further from every obstacle has to do with none of them. */
  private static final double NEAR_M = 0.2;

  private static final int WALK = LevelForms.WALK_DB.size();
  private static final int SCALE = WALK;
  private static final int CONSTANT = WALK + 1;
  private static final int TARGETS = WALK + 2;

  private final Layout layout;
  private final Predictor predictor;
  private final int targets;
  private final RealMatrix excessPrecision;
  private final RealMatrix rangePrecision;

  private Leeway(Known known, RealMatrix excess, RealMatrix range) {
    layout = known.layout;
    predictor = known.predictor;
    targets = known.ranges.byBearing().size();
    excessPrecision = inverse(excess);
    rangePrecision = inverse(range);
  }

  /**
   * What a fit knows of its values.
   *
   * @param layout of the values of levels
   * @param predictor of excesses, set to the values
   * @param covariance of the values
   * @param ranges as fitted
   */
  record Known(Layout layout, Predictor predictor, RealMatrix covariance, Ranges ranges) {}

  /**
   * Returns what a fit leaves open, what differs from one day to the next, and where the law is a
   * little wrong.
   *
   * @param known by the fit
   * @param excessDb by how much levels are off at a distance, beyond what the fit knows of itself
   * @param rangeM the same of ranges, metres
   */
  static Leeway of(Known known, double excessDb, double rangeM) {
    RealMatrix excess = known.covariance.copy();
    double off = excessDb * excessDb;
    add(excess, Layout.LEVEL, DAYS_GAIN_DB * DAYS_GAIN_DB + off);
    add(excess, 1, DAYS_ABSORPTION_DB_PER_M * DAYS_ABSORPTION_DB_PER_M);
    add(excess, known.layout.squint(), DAYS_TURN_RAD * DAYS_TURN_RAD);
    for (int knot = 0; knot < LevelForms.RECEIVER_M.size(); knot++) {
      add(excess, Layout.RECEIVER + knot, off);
    }
    return new Leeway(known, excess, ofRanges(known.ranges, rangeM));
  }

  private static RealMatrix ofRanges(Ranges ranges, double rangeM) {
    int targets = ranges.byBearing().size();
    int size = TARGETS + targets * (SECTORS + 1);
    RealMatrix range = MatrixUtils.createRealMatrix(size, size);
    range.setSubMatrix(ranges.byLevel().covariance().getData(), 0, 0);
    for (int knot = 0; knot < WALK; knot++) {
      add(range, knot, rangeM * rangeM);
    }
    add(range, SCALE, DAYS_AIR * DAYS_AIR);
    add(range, CONSTANT, DAYS_PLACE_M * DAYS_PLACE_M + rangeM * rangeM);
    for (int target = 0; target < targets; target++) {
      add(range, constant(target), DAYS_PLACE_M * DAYS_PLACE_M);
      double[] path = ranges.byBearing().get(target).values();
      for (int sector = 0; sector < SECTORS; sector++) {
        add(range, sector(target, sector), variance(path, sector));
      }
    }
    return range;
  }

  private static RealMatrix inverse(RealMatrix matrix) {
    return Matrices.positive(matrix).getSolver().getInverse();
  }

  private static void add(RealMatrix matrix, int at, double variance) {
    matrix.addToEntry(at, at, variance);
  }

  private static int constant(int target) {
    return TARGETS + target * (SECTORS + 1);
  }

  private static int sector(int target, int sector) {
    return constant(target) + 1 + sector;
  }

  private static double variance(double[] path, int sector) {
    int each = LevelForms.BEARINGS / SECTORS;
    int first = LevelForms.BEARINGS + sector * each;
    return Arrays.stream(path, first, first + each).map(own -> own * own).average().orElse(0);
  }

  /**
   * Returns by how many nats a log would be likelier if the set-up moved.
   *
   * @param geometry of the log under a hypothesis
   * @param added what the hypothesis adds to the excess of each line of sight, decibels
   * @param perDecibel by how much the log probability of each reading rises with the excess
   * @param perMetre the same with its range
   * @return at least 0
   */
  public double nats(Geometry geometry, double[] added, double[] perDecibel, double[] perMetre) {
    Sums levels = new Sums(layout.size());
    Sums metres = new Sums(rangePrecision.getRowDimension());
    Predictor.Slope slope = new Predictor.Slope();
    for (int ping = 0; ping < perDecibel.length; ping++) {
      if (perDecibel[ping] == 0 && perMetre[ping] == 0) {
        continue;
      }
      int line = line(geometry, ping);
      if (line < 0) {
        continue;
      }
      Predictor.Row row = predictor.row(trial(geometry, ping, line, added[line]));
      Predictor.Excess own = predictor.excess(row);
      predictor.slope(row, own, slope);
      levels.add(slope, perDecibel[ping]);
      if (geometry.log().echo(ping)) {
        metres.add(ranges(row.trial(), own.decibels()), perMetre[ping]);
      }
    }
    return levels.nats(excessPrecision) + metres.nats(rangePrecision);
  }

  /** The line of sight that a reading is most about; negative for none. */
  private int line(Geometry geometry, int ping) {
    boolean read = geometry.log().echo(ping);
    int best = -1;
    double least = read ? NEAR_M : Double.POSITIVE_INFINITY;
    for (int target = 0; target < targets; target++) {
      int line = ping * targets + target;
      double nearest = geometry.nearestM(line);
      double off = read ? Math.abs(nearest - geometry.log().rangeM(ping)) : nearest;
      if (off < least) {
        least = off;
        best = line;
      }
    }
    return best;
  }

  private Trials.Trial trial(Geometry geometry, int ping, int line, double addedDb) {
    return new Trials.Trial(
        ping,
        line % targets,
        geometry.bearingRad(line),
        geometry.centreDistanceM(line),
        geometry.nearestM(line),
        geometry.nearestSignedOffAxisRad(line),
        geometry.log().echo(ping),
        addedDb,
        1,
        0);
  }

  private double[] ranges(Trials.Trial trial, double excessDb) {
    double[] all = new double[rangePrecision.getRowDimension()];
    double[] walk = RangeFit.weights(LevelForms.WALK_DB, excessDb);
    System.arraycopy(walk, 0, all, 0, WALK);
    all[SCALE] = trial.nearestM();
    all[CONSTANT] = 1;
    all[constant(trial.target())] = 1;
    int place = (int) (trial.bearingRad() / Angles.TURN_RAD * SECTORS);
    all[sector(trial.target(), Math.floorMod(place, SECTORS))] = 1;
    return all;
  }

  /** Sums of scores, and of their squares. */
  private static final class Sums {
    private final double[] score;
    private final RealMatrix information;

    Sums(int size) {
      score = new double[size];
      information = MatrixUtils.createRealMatrix(size, size);
    }

    void add(Predictor.Slope slope, double rise) {
      for (int i = 0; i < slope.size(); i++) {
        score[slope.index(i)] += rise * slope.value(i);
        for (int j = 0; j < slope.size(); j++) {
          double product = rise * rise * slope.value(i) * slope.value(j);
          information.addToEntry(slope.index(i), slope.index(j), product);
        }
      }
    }

    void add(double[] weights, double rise) {
      for (int i = 0; i < weights.length; i++) {
        if (weights[i] != 0) {
          score[i] += rise * weights[i];
          for (int j = 0; j < weights.length; j++) {
            information.addToEntry(i, j, rise * rise * weights[i] * weights[j]);
          }
        }
      }
    }

    /** Half the gain of a step to the top. */
    double nats(RealMatrix precision) {
      ArrayRealVector right = new ArrayRealVector(score);
      RealMatrix all = precision.add(information);
      return Matrices.positive(all).getSolver().solve(right).dotProduct(right) / 2;
    }
  }
}
