package simbad.gap.calibrate.level;

import java.util.Arrays;
import java.util.List;
import simbad.sonar.catalogue.LevelForms;
import simbad.sonar.level.LevelLaw;

/**
 * What distance takes from an echo, as a linear function of the parameters that are fitted:
 * spreading, absorption and the receiver's departures.
 *
 * @param weights of the parameters, in the order of {@link #values}
 * @param offsetDb beside them
 */
@SuppressWarnings("ArrayRecordComponent") // never changed; a fit makes thousands of them
record Loss(double[] weights, double offsetDb) {
  /** Number of parameters. */
  static final int SIZE = 2 + LevelForms.RECEIVER_M.size();

  private static final double LEAST_M = 0.001;

  /** That at a distance to the centre. */
  static Loss at(double distanceM, LevelLaw believed) {
    double r = Math.max(LEAST_M, distanceM);
    double[] weights = new double[SIZE];
    weights[0] = 20 * Math.log10(r);
    weights[1] = 2 * r;
    for (int knot = 0; knot < LevelForms.RECEIVER_M.size(); knot++) {
      weights[2 + knot] = LevelForms.receiverWeight(knot, r);
    }
    return new Loss(weights, believed.receiverThresholdDb().at(r));
  }

  /** A level that depends on no parameter. */
  static Loss constant(double decibels) {
    return new Loss(new double[SIZE], decibels);
  }

  /** The values of the parameters in a law whose receiver is as believed. */
  static double[] values(LevelLaw law) {
    double[] values = new double[SIZE];
    values[0] = law.spreadingExponent();
    values[1] = law.absorptionDbPerM();
    return values;
  }

  Loss plus(double decibels) {
    return new Loss(weights, offsetDb + decibels);
  }

  /** This less another. */
  Loss minus(Loss other) {
    double[] less = weights.clone();
    for (int i = 0; i < SIZE; i++) {
      less[i] -= other.weights[i];
    }
    return new Loss(less, offsetDb - other.offsetDb);
  }

  /** Between this and another. */
  Loss towards(Loss other, double share) {
    double[] between = new double[SIZE];
    Arrays.setAll(between, i -> weights[i] + share * (other.weights[i] - weights[i]));
    return new Loss(between, offsetDb + share * (other.offsetDb - offsetDb));
  }

  static Loss mean(List<Loss> all) {
    Loss mean = all.get(0);
    for (int i = 1; i < all.size(); i++) {
      mean = mean.towards(all.get(i), 1.0 / (i + 1));
    }
    return mean;
  }

  /** The level under values of the parameters. */
  double decibels(double[] values) {
    double sum = offsetDb;
    for (int i = 0; i < SIZE; i++) {
      sum += weights[i] * values[i];
    }
    return sum;
  }
}
