package simbad.gap.calibrate.level;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import simbad.sonar.catalogue.LevelForms;
import simbad.sonar.scene.SonarSpec;

/**
 * What echoes read of their distances: a share that is the air's, and what is added by the level
 * and by the bearing that an obstacle is seen from. All are fitted together: a share of the
 * distance, a constant walk and the constant of an obstacle look much alike, and one after the
 * other they settle too slowly. Student's weights for what lies far off.
 *
 * @param scale share of the distance
 * @param byLevel walk and noise
 * @param byBearing of each obstacle
 */
record Ranges(double scale, RangeFit byLevel, List<PathFit> byBearing) {
  private static final int ROUNDS = 40;
  private static final double SETTLED_M = 1e-5;

  /** Three kelvin are half a per cent of the speed of sound. */
  private static final double SCALE_SPREAD = 0.005;

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
    for (int round = 0; round < ROUNDS; round++) {
      double[] weight = weights(walk.beyond(excess, left(read, scale, paths)), walk, excess);
      double[] shared = shared(read, rows, weight, paths);
      double moved = Math.abs(1 + shared[0] - scale);
      scale = 1 + shared[0];
      moved += walk.take(Arrays.copyOfRange(shared, 1, shared.length), left(read, scale, paths));
      if (moved < SETTLED_M) {
        break;
      }
    }
    return new Ranges(scale, walk, paths);
  }

  private static double[] weights(double[] off, RangeFit walk, double[] excess) {
    double[] weights = walk.variances(excess);
    Arrays.setAll(weights, i -> RangeFit.weight(off[i], weights[i]));
    return weights;
  }

  /** How much an echo says of the share of the distance over 1, and of the walk. */
  private static double[] row(double nearestM, double excess) {
    double[] walk = RangeFit.weights(LevelForms.WALK_DB, excess);
    double[] row = new double[walk.length + 1];
    row[0] = nearestM;
    System.arraycopy(walk, 0, row, 1, walk.length);
    return row;
  }

  private static double[][] prior() {
    double[][] walk = RangeFit.prior();
    double[][] prior = new double[walk.length + 1][walk.length + 1];
    prior[0][0] = 1 / (SCALE_SPREAD * SCALE_SPREAD);
    for (int i = 0; i < walk.length; i++) {
      System.arraycopy(walk[i], 0, prior[i + 1], 1, walk.length);
    }
    return prior;
  }

  /** The share of the distance over 1, and the walk; what bearings add is taken by the paths. */
  private static double[] shared(
      List<Trials.Trial> read, double[][] rows, double[] weight, List<PathFit> paths) {
    Normal normal = new Normal(prior());
    for (int i = 0; i < weight.length; i++) {
      normal.add(rows[i], weight[i], read.get(i).beyondM());
    }
    paths.forEach(path -> path.leave(normal, rows, weight));
    double[] shared = normal.solve();
    paths.forEach(path -> path.take(shared));
    return shared;
  }

  /** What is read too far, less what a scale and paths say. */
  private static double[] left(List<Trials.Trial> read, double scale, List<PathFit> paths) {
    double[] left = new double[read.size()];
    for (int i = 0; i < left.length; i++) {
      Trials.Trial trial = read.get(i);
      left[i] =
          trial.beyondM() - (scale - 1) * trial.nearestM() - paths.get(trial.target()).at(trial);
    }
    return left;
  }
}
