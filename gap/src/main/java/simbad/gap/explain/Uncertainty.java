package simbad.gap.explain;

import java.util.List;
import org.hipparchus.exception.MathRuntimeException;
import org.hipparchus.linear.Array2DRowRealMatrix;
import org.hipparchus.linear.LUDecomposition;
import org.hipparchus.linear.RealMatrix;
import simbad.gap.fit.Evidence;
import simbad.gap.fit.Fitter;
import simbad.gap.fit.Fold;
import simbad.gap.fit.Hypothesis;
import simbad.sonar.effect.Parameter;

/** How well a log bounds fitted values: from the curvature of the likelihood at the fit. */
public final class Uncertainty {
  private static final double DROP_NATS = 0.5;
  private static final int HALVINGS = 12;

  private final Fitter fitter;
  private final double clumping;

  /** Creates for a log whose readings hang together by a factor, 1 for independent ones. */
  public Uncertainty(Evidence evidence, double clumping) {
    fitter = new Fitter(evidence, Fold.ALL);
    this.clumping = clumping;
  }

  /**
   * Returns the standard deviation of each value; infinite where the log does not bound it.
   *
   * @param fit whose values fit best
   */
  public double[] deviations(Hypothesis fit) {
    int size = fit.size();
    double[] step = new double[size];
    double here = fitter.logLikelihood(fit);
    for (int i = 0; i < size; i++) {
      step[i] = step(fit, i, here);
    }
    double[][] curve = new double[size][size];
    for (int i = 0; i < size; i++) {
      for (int j = 0; j <= i; j++) {
        curve[i][j] = -curvature(fit, step, here, i, j);
        curve[j][i] = curve[i][j];
      }
    }
    return inverted(curve, step);
  }

  /** Such a step that the likelihood falls by about half a nat. */
  private double step(Hypothesis fit, int i, double here) {
    Parameter parameter = fit.parameters().get(i);
    double step =
        0.25
            * Math.min(
                parameter.high() - parameter.low(), Math.max(0.05, Math.abs(fit.values()[i])));
    for (int k = 0; k < HALVINGS; k++) {
      if (here - at(fit, i, step) < 4 * DROP_NATS && here - at(fit, i, -step) < 4 * DROP_NATS) {
        break;
      }
      step /= 2;
    }
    return step;
  }

  private double at(Hypothesis fit, int i, double by) {
    double[] values = fit.values();
    values[i] = fit.parameters().get(i).clamp(values[i] + by);
    return fitter.logLikelihood(fit.with(values));
  }

  /** Second difference of the likelihood in two values, each moved by its step. */
  private double curvature(Hypothesis fit, double[] step, double here, int i, int j) {
    if (i == j) {
      return at(fit, i, step[i]) + at(fit, i, -step[i]) - 2 * here;
    }
    double sum = 0;
    for (int a = -1; a <= 1; a += 2) {
      for (int b = -1; b <= 1; b += 2) {
        double[] moved = fit.values();
        moved[i] += a * step[i];
        moved[j] += b * step[j];
        sum += a * b * fitter.logLikelihood(clamped(fit, moved));
      }
    }
    return sum / 4;
  }

  private static Hypothesis clamped(Hypothesis fit, double[] values) {
    List<Parameter> parameters = fit.parameters();
    for (int i = 0; i < values.length; i++) {
      values[i] = parameters.get(i).clamp(values[i]);
    }
    return fit.with(values);
  }

  /** In units of the steps, in which all are alike. */
  private double[] inverted(double[][] curve, double[] step) {
    double[] deviations = new double[step.length];
    RealMatrix inverse;
    try {
      inverse = new LUDecomposition(new Array2DRowRealMatrix(curve)).getSolver().getInverse();
    } catch (MathRuntimeException singular) {
      java.util.Arrays.fill(deviations, Double.POSITIVE_INFINITY);
      return deviations;
    }
    for (int i = 0; i < deviations.length; i++) {
      double variance = inverse.getEntry(i, i) * clumping;
      deviations[i] = variance > 0 ? step[i] * Math.sqrt(variance) : Double.POSITIVE_INFINITY;
    }
    return deviations;
  }
}
