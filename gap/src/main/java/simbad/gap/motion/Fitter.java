package simbad.gap.motion;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.Function;
import java.util.function.IntPredicate;
import org.hipparchus.linear.Array2DRowRealMatrix;
import org.hipparchus.linear.ArrayRealVector;
import org.hipparchus.linear.RealMatrix;
import org.hipparchus.linear.RealVector;
import org.hipparchus.linear.SingularValueDecomposition;
import simbad.motion.effect.MotionForm;
import simbad.motion.effect.MotionParameter;

/** Fits a hypothesis' values by weighted least squares, damped, with Student's weights. */
final class Fitter {
  /** Parts of a log of which each is left out once. */
  private static final int STRETCHES = 10;

  private static final int ROUNDS = 12;
  private static final double ENOUGH = 1e-5;

  private final Evidence evidence;

  Fitter(Evidence evidence) {
    this.evidence = evidence;
  }

  /** Fits from the values that a hypothesis has, to the windows that a mask lets through. */
  Fit fit(Hypothesis from, boolean[] mask) {
    Hypothesis best = from;
    double[][] residuals = evidence.residuals(best.chain());
    Scatter scatter = Scatter.of(residuals, mask);
    double score = score(residuals, scatter, mask);
    double damping = 1e-3;
    for (int round = 0; round < ROUNDS && best.values().length > 0; round++) {
      Hypothesis next = step(best, residuals, scatter, mask, damping);
      double[][] nextResiduals = evidence.residuals(next.chain());
      // With the scales as they were: the median's jumps would hide what a small step gains.
      double gain = score(nextResiduals, scatter, mask) - score;
      if (gain > 0) {
        best = next;
        residuals = nextResiduals;
        scatter = Scatter.of(residuals, mask);
        score = score(residuals, scatter, mask);
        damping /= 10;
      } else {
        damping = Math.max(damping, 1e-4) * 30;
      }
      boolean settled = gain > 0 && gain < ENOUGH * evidence.size();
      if (settled || damping > 1e4) {
        break;
      }
    }
    return new Fit(best, residuals, scatter, score);
  }

  /** Fits from each of a new form's starts and returns the best. */
  Fit fitWith(Hypothesis base, MotionForm form, boolean[] mask) {
    double[] bestStart = form.starts().get(0);
    double best = Double.NEGATIVE_INFINITY;
    for (double[] start : form.starts()) {
      double[][] residuals = evidence.residuals(base.with(form, start).chain());
      double score = score(residuals, Scatter.of(residuals, mask), mask);
      if (score > best) {
        best = score;
        bestStart = start;
      }
    }
    return fit(base.with(form, bestStart), mask);
  }

  private static double score(double[][] residuals, Scatter scatter, boolean[] mask) {
    double sum = 0;
    for (int i = 0; i < residuals.length; i++) {
      if (mask[i]) {
        sum += scatter.logDensity(residuals[i]);
      }
    }
    return sum;
  }

  private Hypothesis step(
      Hypothesis at, double[][] residuals, Scatter scatter, boolean[] mask, double damping) {
    Normal normal = normal(at, residuals, scatter, mask);
    int n = at.values().length;
    for (int i = 0; i < n; i++) {
      double own = normal.matrix.getEntry(i, i);
      normal.matrix.setEntry(i, i, own * (1 + damping) + 1e-12);
    }
    RealVector move =
        new SingularValueDecomposition(normal.matrix).getSolver().solve(normal.vector);
    double[] values = new double[n];
    List<MotionParameter> parameters = parameters(at);
    for (int i = 0; i < n; i++) {
      values[i] = parameters.get(i).within(at.values()[i] + move.getEntry(i));
    }
    return at.withValues(values);
  }

  /** The normal equations of one round. */
  private record Normal(RealMatrix matrix, RealVector vector) {}

  private Normal normal(Hypothesis at, double[][] residuals, Scatter scatter, boolean[] mask) {
    double[][][] slopes = slopes(at, residuals);
    int n = slopes.length;
    double[][] matrix = new double[n][n];
    double[] vector = new double[n];
    for (int w = 0; w < residuals.length; w++) {
      if (mask[w]) {
        for (int c = 0; c < 3; c++) {
          double weight = scatter.weight(residuals[w], c);
          for (int i = 0; i < n; i++) {
            vector[i] += weight * slopes[i][w][c] * residuals[w][c];
            for (int j = 0; j <= i; j++) {
              matrix[i][j] += weight * slopes[i][w][c] * slopes[j][w][c];
            }
          }
        }
      }
    }
    for (int i = 0; i < n; i++) {
      for (int j = 0; j < i; j++) {
        matrix[j][i] = matrix[i][j];
      }
    }
    return new Normal(new Array2DRowRealMatrix(matrix), new ArrayRealVector(vector));
  }

  /** By parameter, window and component: how the expected displacement changes with the value. */
  private double[][][] slopes(Hypothesis at, double[][] residuals) {
    List<MotionParameter> parameters = parameters(at);
    double[][][] slopes = new double[parameters.size()][][];
    for (int p = 0; p < slopes.length; p++) {
      double[] values = at.values().clone();
      double step = parameters.get(p).practical();
      values[p] = values[p] + step > parameters.get(p).high() ? values[p] - step : values[p] + step;
      double moved = values[p] - at.values()[p];
      double[][] other = evidence.residuals(at.withValues(values).chain());
      for (int w = 0; w < other.length; w++) {
        for (int c = 0; c < 3; c++) {
          double difference = residuals[w][c] - other[w][c];
          other[w][c] = (c == 2 ? Math.IEEEremainder(difference, 2 * Math.PI) : difference) / moved;
        }
      }
      slopes[p] = other;
    }
    return slopes;
  }

  static List<MotionParameter> parameters(Hypothesis hypothesis) {
    List<MotionParameter> parameters = new ArrayList<>();
    hypothesis.forms().forEach(form -> parameters.addAll(form.parameters()));
    return parameters;
  }

  /** Returns standard errors of a hypothesis' values. */
  double[] standardErrors(Hypothesis fitted) {
    return standardErrors(fitted.values(), mask -> fit(fitted, mask).hypothesis().values());
  }

  /**
   * Returns standard errors of numbers, by leaving out a stretch of the log at a time (Kunsch
   * 1989): windows hang together, and a floor or a battery changes slowly.
   *
   * @param whole the numbers on all windows
   * @param on them on the windows that a mask lets through
   */
  double[] standardErrors(double[] whole, Function<boolean[], double[]> on) {
    double[] errors = new double[whole.length];
    for (int stretch = 0; stretch < STRETCHES; stretch++) {
      double[] values = on.apply(withoutStretch(stretch));
      for (int i = 0; i < errors.length; i++) {
        errors[i] += (values[i] - whole[i]) * (values[i] - whole[i]);
      }
    }
    double factor = (STRETCHES - 1.0) / STRETCHES;
    Arrays.setAll(errors, i -> Math.sqrt(errors[i] * factor));
    return errors;
  }

  private boolean[] withoutStretch(int left) {
    boolean[] mask = new boolean[evidence.size()];
    for (int i = 0; i < mask.length; i++) {
      mask[i] = (int) ((long) i * STRETCHES / mask.length) != left;
    }
    return mask;
  }

  boolean[] all() {
    return mask(fold -> true);
  }

  boolean[] without(int left) {
    return mask(fold -> fold != left);
  }

  private boolean[] mask(IntPredicate taken) {
    boolean[] mask = new boolean[evidence.size()];
    for (int i = 0; i < mask.length; i++) {
      mask[i] = taken.test(evidence.fold(i));
    }
    return mask;
  }
}
