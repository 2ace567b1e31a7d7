package simbad.gap.calibrate.level;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.hipparchus.linear.RealMatrix;
import simbad.sonar.catalogue.LevelForms;
import simbad.sonar.scene.SonarSpec;

/**
 * What echoes read of their distances: a share that is the air's, and what is added by the level,
 * near by, and by the bearing that an obstacle is seen from. All are fitted together: a share of
 * the distance, a constant walk and the constant of an obstacle look much alike, and one after the
 * other they settle too slowly. Student's weights for what lies far off.
 *
 * @param scale share of the distance
 * @param byLevel walk and noise
 * @param nearM what is added near by: the values of {@link LevelForms#nearRange}, metres
 * @param byBearing of each obstacle
 * @param covariance of the share, the walk and what is added near by, in this order, whatever the
 *     paths are
 */
@SuppressWarnings("ArrayRecordComponent") // read only
record Ranges(
    double scale,
    RangeFit byLevel,
    double[] nearM,
    List<PathFit> byBearing,
    RealMatrix covariance) {
  private static final int ROUNDS = 40;
  private static final double SETTLED_M = 1e-5;

  /** Three kelvin are half a per cent of the speed of sound. */
  private static final double SCALE_SPREAD = 0.005;

  /** What is near is read as far as what is 0.4 m away, but for so much from knot to knot. */
  private static final double NEAR_STEP_M = 0.003;

  /** Copies the list. */
  Ranges {
    byBearing = List.copyOf(byBearing);
  }

  /**
   * Fits.
   *
   * @param predictor of levels, with the values of a fit
   * @param trials of which those that were read count
   * @param targets the obstacles
   * @param sensor as believed
   */
  static Ranges of(
      Predictor predictor, List<Trials.Trial> trials, List<Believed> targets, SonarSpec sensor) {
    List<Trials.Trial> read = trials.stream().filter(Trials.Trial::isRead).toList();
    double[] excess = new double[read.size()];
    Arrays.setAll(excess, i -> predictor.excess(predictor.row(read.get(i))).decibels());
    double[] beyond = read.stream().mapToDouble(Trials.Trial::beyondM).toArray();
    List<PathFit> paths = new ArrayList<>();
    for (int target = 0; target < targets.size(); target++) {
      paths.add(new PathFit(targets.get(target), target, read));
    }
    RangeFit walk = new RangeFit(excess, beyond, sensor.resolutionM(), sensor.rangeNoiseM());
    double[][] rows = new double[excess.length][];
    Arrays.setAll(rows, i -> row(read.get(i).nearestM(), excess[i]));
    double scale = 1;
    double[] near = new double[LevelForms.NEAR_M.size() - 1];
    int walks = LevelForms.WALK_DB.size();
    Normal equations = new Normal(prior());
    for (int round = 0; round < ROUNDS; round++) {
      double[] weight = weights(walk.beyond(excess, left(read, scale, near, paths)), walk, excess);
      equations = equations(read, rows, weight, paths);
      double[] shared = equations.solve();
      paths.forEach(path -> path.take(shared));
      double moved = Math.abs(1 + shared[0] - scale);
      scale = 1 + shared[0];
      near = Arrays.copyOfRange(shared, 1 + walks, shared.length);
      moved += walk.take(Arrays.copyOfRange(shared, 1, 1 + walks), left(read, scale, near, paths));
      if (moved < SETTLED_M) {
        break;
      }
    }
    return new Ranges(scale, walk, near, paths, equations.covariance());
  }

  private static double[] weights(double[] off, RangeFit walk, double[] excess) {
    double[] weights = walk.variances(excess);
    Arrays.setAll(weights, i -> RangeFit.weight(off[i], weights[i]));
    return weights;
  }

  /**
   * How much an echo says of the share of the distance over 1, of the walk, and of what is near.
   */
  static double[] row(double nearestM, double excess) {
    double[] walk = RangeFit.weights(LevelForms.WALK_DB, excess);
    double[] near = RangeFit.weights(LevelForms.NEAR_M, nearestM);
    double[] row = new double[walk.length + near.length];
    row[0] = nearestM;
    System.arraycopy(walk, 0, row, 1, walk.length);
    System.arraycopy(near, 0, row, 1 + walk.length, near.length - 1);
    return row;
  }

  private static double[][] prior() {
    double[][] walk = RangeFit.prior();
    int size = 1 + walk.length + LevelForms.NEAR_M.size() - 1;
    double[][] prior = new double[size][size];
    prior[0][0] = 1 / (SCALE_SPREAD * SCALE_SPREAD);
    for (int i = 0; i < walk.length; i++) {
      System.arraycopy(walk[i], 0, prior[i + 1], 1, walk.length);
    }
    int last = size - 1;
    for (int at = 1 + walk.length; at < last; at++) {
      RangeFit.tie(prior, at, at + 1, NEAR_STEP_M);
    }
    // What follows the last one is 0.
    prior[last][last] += 1 / (NEAR_STEP_M * NEAR_STEP_M);
    return prior;
  }

  /**
   * The share of the distance over 1, the walk, what is near; what bearings add is taken by the
   * paths.
   */
  private static Normal equations(
      List<Trials.Trial> read, double[][] rows, double[] weight, List<PathFit> paths) {
    Normal normal = new Normal(prior());
    for (int i = 0; i < weight.length; i++) {
      normal.add(rows[i], weight[i], read.get(i).beyondM());
    }
    paths.forEach(path -> path.leave(normal, rows, weight));
    return normal;
  }

  /** What is read too far, less what a scale and paths say. */
  private static double[] left(
      List<Trials.Trial> read, double scale, double[] near, List<PathFit> paths) {
    double[] left = new double[read.size()];
    for (int i = 0; i < left.length; i++) {
      Trials.Trial trial = read.get(i);
      left[i] =
          trial.beyondM()
              - (scale - 1) * trial.nearestM()
              - RangeFit.dot(near, RangeFit.weights(LevelForms.NEAR_M, trial.nearestM()))
              - paths.get(trial.target()).at(trial);
    }
    return left;
  }
}
