package simbad.gap.calibrate.level;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import simbad.sonar.scene.SonarSpec;

/**
 * What echoes read of their distances: a share that is the air's, and what is added by the level
 * and by the bearing that an obstacle is seen from. Each is fitted in turn to what the others
 * leave.
 *
 * @param scale share of the distance
 * @param byLevel walk and noise
 * @param byBearing of each obstacle
 */
record Ranges(double scale, RangeFit byLevel, List<PathFit> byBearing) {
  private static final int ROUNDS = 4;
  private static final double DEGREES = 4;

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
    List<PathFit> paths = new ArrayList<>();
    targets.forEach(target -> paths.add(new PathFit(target)));
    double scale = 1;
    RangeFit walk = walk(excess, left(read, scale, paths), sensor);
    for (int round = 1; round < ROUNDS; round++) {
      double[] variance = walk.variances(excess);
      scale = scale(read, walk.beyond(excess, left(read, 1, paths)), variance);
      double[] left = walk.beyond(excess, left(read, scale, List.of()));
      for (int target = 0; target < paths.size(); target++) {
        paths.get(target).fit(read, target, left, variance);
      }
      walk = walk(excess, left(read, scale, paths), sensor);
    }
    return new Ranges(scale, walk, paths);
  }

  private static RangeFit walk(double[] excess, double[] left, SonarSpec sensor) {
    return new RangeFit(excess, left, sensor.resolutionM(), sensor.rangeNoiseM());
  }

  /** What is read too far, less what a scale and paths say. */
  private static double[] left(List<Trials.Trial> read, double scale, List<PathFit> paths) {
    double[] left = new double[read.size()];
    for (int i = 0; i < left.length; i++) {
      Trials.Trial trial = read.get(i);
      double path = paths.isEmpty() ? 0 : paths.get(trial.target()).at(trial);
      left[i] = trial.beyondM() - (scale - 1) * trial.nearestM() - path;
    }
    return left;
  }

  private static double scale(List<Trials.Trial> read, double[] left, double[] variance) {
    double sum = 0;
    double precision = 1 / (SCALE_SPREAD * SCALE_SPREAD);
    for (int i = 0; i < left.length; i++) {
      double own = (DEGREES + 1) / (DEGREES + left[i] * left[i] / variance[i]) / variance[i];
      double nearest = read.get(i).nearestM();
      sum += own * nearest * left[i];
      precision += own * nearest * nearest;
    }
    return 1 + sum / precision;
  }
}
