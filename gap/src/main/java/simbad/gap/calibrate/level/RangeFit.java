package simbad.gap.calibrate.level;

import java.util.Arrays;
import java.util.List;
import simbad.sonar.catalogue.LevelForms;

/**
 * By how much echoes read long, and how much their ranges scatter, over their excess: curves
 * through knots, fitted robustly by Student's distribution of four degrees.
 */
final class RangeFit {
  private static final int ROUNDS = 12;
  private static final double DEGREES = 4;

  /** A walk of more than a burst's length has another cause; neighbours differ by less. */
  private static final double WALK_M = 0.03;

  private static final double WALK_STEP_M = 0.01;

  /** The believed noise is worth so many ranges. */
  private static final double BELIEVED = 6;

  /** What lies further off counts as so far, in deviations: the broad tail is another's. */
  private static final double FARTHEST = 2.5;

  /** The mean square of a normal deviate that counts so at most. */
  private static final double CUT_SQUARE = 0.96;

  private static final double LEAST_NOISE_M = 5e-4;

  private final double[] excessDb;
  private double[] beyondM;
  private final double stepVariance;
  private final double believedNoiseM;
  private double[] walk = new double[LevelForms.WALK_DB.size()];
  private double[] noise = new double[LevelForms.NOISE_DB.size()];

  /**
   * Fits.
   *
   * @param excessDb of each echo
   * @param beyondM by how much each was read beyond its nearest point, metres
   * @param resolutionM of the sensor, metres
   * @param noiseM as believed, metres
   */
  RangeFit(double[] excessDb, double[] beyondM, double resolutionM, double noiseM) {
    this.excessDb = excessDb;
    this.beyondM = beyondM;
    believedNoiseM = noiseM;
    stepVariance = resolutionM * resolutionM / 12;
    Arrays.fill(noise, Math.max(LEAST_NOISE_M, noiseM));
    for (int round = 0; round < ROUNDS; round++) {
      walk = walk();
      noise = noise(noiseM);
    }
  }

  /** Metres at each of {@link LevelForms#WALK_DB}. */
  double[] walkM() {
    return walk.clone();
  }

  /** Metres at each of {@link LevelForms#NOISE_DB}. */
  double[] noiseM() {
    return noise.clone();
  }

  /** What is added at an excess, metres. */
  double walkM(double excess) {
    return dot(weights(LevelForms.WALK_DB, excess), walk);
  }

  /** How much ranges scatter at an excess, square metres. */
  double variance(double excess) {
    double own = dot(weights(LevelForms.NOISE_DB, excess), noise);
    return own * own + stepVariance;
  }

  /** The same at each of some excesses. */
  double[] variances(double[] excesses) {
    return Arrays.stream(excesses).map(this::variance).toArray();
  }

  /** What is left of ranges at some excesses less the walk, metres. */
  double[] beyond(double[] excesses, double[] rangesM) {
    double[] left = new double[rangesM.length];
    Arrays.setAll(left, i -> rangesM[i] - walkM(excesses[i]));
    return left;
  }

  /**
   * Returns how much a range counts by Student's distribution, over its variance.
   *
   * @param off by how much it is off, metres
   * @param variance square metres
   */
  static double weight(double off, double variance) {
    return (DEGREES + 1) / (DEGREES + off * off / variance) / variance;
  }

  /** How surely the walk is 0 and even before any reading: 1 over square metres. */
  static double[][] prior() {
    double[][] precision = new double[LevelForms.WALK_DB.size()][LevelForms.WALK_DB.size()];
    for (int i = 0; i < precision.length; i++) {
      precision[i][i] += 1 / (WALK_M * WALK_M);
      if (i > 0) {
        tie(precision, i - 1, i, WALK_STEP_M);
      }
    }
    return precision;
  }

  /** Adds to a precision that two values differ by no more than a step, metres. */
  static void tie(double[][] precision, int one, int other, double stepM) {
    double stiff = 1 / (stepM * stepM);
    precision[one][one] += stiff;
    precision[other][other] += stiff;
    precision[one][other] -= stiff;
    precision[other][one] -= stiff;
  }

  /**
   * Takes a walk that was fitted with more than the level, and finds how much is scattered about
   * it.
   *
   * @param walkM at each of {@link LevelForms#WALK_DB}, metres
   * @param newBeyondM by how much each echo was read too far, less what is none of the level's
   * @return by how much the walk moved at most, metres
   */
  double take(double[] walkM, double[] newBeyondM) {
    double moved = 0;
    for (int i = 0; i < walkM.length; i++) {
      moved = Math.max(moved, Math.abs(walkM[i] - walk[i]));
    }
    walk = walkM;
    beyondM = newBeyondM;
    noise = noise(believedNoiseM);
    return moved;
  }

  private double[] walk() {
    Normal equations = new Normal(prior());
    for (int echo = 0; echo < excessDb.length; echo++) {
      double[] row = weights(LevelForms.WALK_DB, excessDb[echo]);
      double off = beyondM[echo] - dot(row, walk);
      equations.add(row, weight(off, variance(excessDb[echo])), beyondM[echo]);
    }
    return equations.solve();
  }

  private double[] noise(double believedM) {
    double[] sum = new double[noise.length];
    double[] count = new double[noise.length];
    Arrays.fill(sum, BELIEVED * (believedM * believedM + stepVariance));
    Arrays.fill(count, BELIEVED);
    for (int echo = 0; echo < excessDb.length; echo++) {
      double off = beyondM[echo] - walkM(excessDb[echo]);
      double most = FARTHEST * FARTHEST * variance(excessDb[echo]);
      double square = Math.min(off * off, most) / CUT_SQUARE;
      double[] weight = weights(LevelForms.NOISE_DB, excessDb[echo]);
      for (int i = 0; i < noise.length; i++) {
        sum[i] += weight[i] * square;
        count[i] += weight[i];
      }
    }
    double[] fitted = new double[noise.length];
    Arrays.setAll(
        fitted,
        i -> Math.sqrt(Math.max(LEAST_NOISE_M * LEAST_NOISE_M, sum[i] / count[i] - stepVariance)));
    return fitted;
  }

  /** How much each knot counts at a place: straight between them, constant beyond. */
  static double[] weights(List<Double> knots, double at) {
    double[] weights = new double[knots.size()];
    int last = weights.length - 1;
    int cell = 0;
    while (cell < last - 1 && knots.get(cell + 1) <= at) {
      cell++;
    }
    double share = (at - knots.get(cell)) / (knots.get(cell + 1) - knots.get(cell));
    double inside = Math.max(0, Math.min(1, share));
    weights[cell] = 1 - inside;
    weights[cell + 1] = inside;
    return weights;
  }

  /** The sum of products, as far as the first reaches. */
  static double dot(double[] one, double[] other) {
    double sum = 0;
    for (int i = 0; i < one.length; i++) {
      sum += one[i] * other[i];
    }
    return sum;
  }
}
