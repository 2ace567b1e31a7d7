package simbad.gap.calibrate.level;

import java.util.List;
import org.hipparchus.linear.ArrayRealVector;
import org.hipparchus.linear.CholeskyDecomposition;
import org.hipparchus.linear.MatrixUtils;
import org.hipparchus.linear.RealMatrix;

/**
 * Finds the most probable values of the level law before a log, and how surely they are known: by
 * Fisher's scoring, since the excess is linear in nearly all of them (McCullagh and Nelder 1989,
 * section 2.5), and Laplace's approximation at the end.
 */
final class LevelFit {
  private static final int STEPS = 60;
  private static final int HALVINGS = 12;

  /** A step that gains less ends the search, natural. */
  private static final double GAIN = 1e-4;

  private final Prior prior;
  private final Predictor predictor;
  private final List<Predictor.Row> trials;
  private final List<Predictor.Row> cones;
  private final Misses misses;
  private double[] values;
  private double cost;
  private RealMatrix information = MatrixUtils.createRealIdentityMatrix(1);
  private double[] gradient = {};

  /**
   * Fits.
   *
   * @param prior of the values
   * @param predictor of excesses
   * @param trials what was heard
   * @param cones what the scene says of the beam
   * @param missRate as believed
   */
  LevelFit(
      Prior prior,
      Predictor predictor,
      List<Trials.Trial> trials,
      List<Trials.Trial> cones,
      double missRate) {
    this.prior = prior;
    this.predictor = predictor;
    this.trials = trials.stream().map(predictor::row).toList();
    this.cones = cones.stream().map(predictor::row).toList();
    misses = new Misses(missRate);
    values = prior.mean();
    cost = Double.POSITIVE_INFINITY;
    for (int step = 0; step < STEPS; step++) {
      double next = step();
      if (cost - next < GAIN && step > 2) {
        break;
      }
      cost = next;
    }
    weigh();
  }

  /** One step downhill; returns the cost there. */
  private double step() {
    weigh();
    double[] move =
        Matrices.positive(information).getSolver().solve(new ArrayRealVector(gradient)).toArray();
    double here = cost(values);
    double share = 1;
    for (int i = 0; i < HALVINGS; i++) {
      double[] there = moved(move, share);
      double cost = cost(there);
      if (cost < here) {
        values = there;
        here = cost;
        break;
      }
      share /= 2;
    }
    predictor.set(values);
    misses.update(predictor, trials);
    return here;
  }

  private double[] moved(double[] move, double share) {
    double[] there = values.clone();
    for (int i = 0; i < there.length; i++) {
      there[i] += share * move[i];
    }
    return there;
  }

  private double cost(double[] at) {
    predictor.set(at);
    double sum = prior.cost(at);
    for (Predictor.Row row : trials) {
      double heard = misses.chance(predictor.excess(row).inDeviations(), row.trial().share());
      sum -= Math.log(row.trial().isRead() ? heard : 1 - heard);
    }
    for (Predictor.Row row : cones) {
      double off = predictor.excess(row).decibels() / Cones.DEVIATION_DB;
      sum += off * off / 2;
    }
    return sum;
  }

  /** Fisher's information and the gradient of the log posterior here. */
  private void weigh() {
    int size = values.length;
    predictor.set(values);
    information = MatrixUtils.createRealMatrix(prior.precision());
    gradient = new double[size];
    double[] mean = prior.mean();
    for (int i = 0; i < size; i++) {
      for (int j = 0; j < size; j++) {
        gradient[i] -= prior.precision()[i][j] * (values[j] - mean[j]);
      }
    }
    Predictor.Slope slope = new Predictor.Slope();
    for (Predictor.Row row : trials) {
      Predictor.Excess excess = predictor.excess(row);
      predictor.slope(row, excess, slope);
      double heard = misses.chance(excess.inDeviations(), row.trial().share());
      double rise = misses.slope(excess.inDeviations(), row.trial().share());
      double spread = heard * (1 - heard);
      double score = ((row.trial().isRead() ? 1 : 0) - heard) * rise / spread;
      add(slope, slope.size(), 1 / excess.deviationDb(), score, rise * rise / spread);
    }
    for (Predictor.Row row : cones) {
      Predictor.Excess excess = predictor.excess(row);
      predictor.slope(row, excess, slope);
      // All but the last: how surely a cone is known does not depend on the scatter.
      double off = excess.decibels() / Cones.DEVIATION_DB;
      add(slope, slope.size() - 1, 1 / Cones.DEVIATION_DB, -off, 1);
    }
  }

  /** Adds what one trial says of where the excess lies in units of its scatter. */
  private void add(Predictor.Slope slope, int count, double unit, double score, double weight) {
    for (int i = 0; i < count; i++) {
      int at = slope.index(i);
      double own = unit * slope.value(i);
      gradient[at] += score * own;
      for (int j = 0; j < count; j++) {
        information.addToEntry(at, slope.index(j), weight * own * unit * slope.value(j));
      }
    }
  }

  /** Returns the values. */
  double[] values() {
    return values.clone();
  }

  /**
   * Returns how probable the log is, of all values, by Laplace; natural logarithm and a constant.
   */
  double evidence() {
    return -cost - Matrices.logDeterminant(information) / 2;
  }

  /** Returns how improbable the values were before the log: natural logarithm. */
  double priorCost() {
    return prior.cost(values);
  }

  /** Returns the share of echoes that are missed whatever their strength. */
  double missRate() {
    return misses.rate();
  }

  /** Returns the covariance of the values, by Laplace. */
  RealMatrix covariance() {
    CholeskyDecomposition decomposition = Matrices.positive(information.copy());
    return decomposition.getSolver().getInverse();
  }
}
