package simbad.benchmarks.constants;

import java.util.Arrays;
import java.util.function.ToDoubleFunction;
import org.hipparchus.optim.InitialGuess;
import org.hipparchus.optim.MaxEval;
import org.hipparchus.optim.SimpleBounds;
import org.hipparchus.optim.nonlinear.scalar.GoalType;
import org.hipparchus.optim.nonlinear.scalar.ObjectiveFunction;
import org.hipparchus.optim.nonlinear.scalar.noderiv.BOBYQAOptimizer;

/** Most probable weights of a regression, which have a normal prior around 0. */
final class Regression {
  private static final double FURTHEST = 4;
  private static final int EVALUATIONS = 20_000;

  private Regression() {}

  /**
   * Finds them.
   *
   * @param size number of weights, at least 2
   * @param spread standard deviation of the prior, positive
   * @param score log probability of what is so, natural, by the weights
   */
  static double[] fitted(int size, double spread, ToDoubleFunction<double[]> score) {
    double[] bound = new double[size];
    Arrays.fill(bound, FURTHEST * spread);
    double[] low = Arrays.stream(bound).map(b -> -b).toArray();
    return new BOBYQAOptimizer(2 * size + 1)
        .optimize(
            new MaxEval(EVALUATIONS),
            new ObjectiveFunction(
                values -> {
                  double prior = 0;
                  for (double value : values) {
                    prior += value * value / (2 * spread * spread);
                  }
                  return prior - score.applyAsDouble(values);
                }),
            GoalType.MINIMIZE,
            new InitialGuess(new double[size]),
            new SimpleBounds(low, bound))
        .getPoint();
  }
}
