package simbad.gap.score;

import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.function.DoubleBinaryOperator;
import java.util.stream.IntStream;
import org.hipparchus.linear.Array2DRowRealMatrix;
import org.hipparchus.linear.EigenDecompositionSymmetric;
import simbad.definition.Parameter;
import simbad.gap.fit.CalibratedLog;
import simbad.gap.fit.Fitter;
import simbad.gap.fit.Fold;
import simbad.gap.fit.Hypothesis;
import simbad.sonar.check.Checks;
import simbad.sonar.effect.Form;

/** How well a log bounds fitted values: from the curvature of the likelihood at the fit. */
public final class Uncertainty {
  private static final double DROP_NATS = 0.5;
  private static final int HALVINGS = 12;

  /** What a step changes by less than this, it does not change. */
  private static final double FLAT_NATS = 1e-3;

  private static final double APART = 0.05;

  /**
   * Where the likelihood jumps to one side, as where the border of a cone passes a ping, a fit
   * stands at the wall: how near it is says nothing of how well the value is known.
   */
  private static final double WALL = 4;

  /** A fit that is not quite at the top may rise to one side. */
  private static final double LEAST_FALL_NATS = 0.1;

  private final Fitter fitter;
  private final double clumping;

  /** Creates for a log whose readings hang together by a factor, 1 for independent ones. */
  public Uncertainty(CalibratedLog given, double clumping) {
    fitter = new Fitter(given, Fold.ALL);
    this.clumping = Checks.positive("clumping", clumping);
  }

  /**
   * Returns the standard deviation of each value; infinite where the log does not bound it. The
   * values of a table are held as they are while the others vary, and their own are infinite.
   *
   * @param fit whose values fit best
   */
  public double[] deviations(Hypothesis fit) {
    int[] free = withoutTables(fit);
    double here = fitter.logLikelihood(fit);
    double[] step = new double[fit.size()];
    boolean[] wall = new boolean[fit.size()];
    for (int i : free) {
      step[i] = step(fit, i, here, Math::max);
      double lesser = step(fit, i, here, Math::min);
      wall[i] = lesser > WALL * step[i] && both(fit, i, lesser, here, Math::min) > LEAST_FALL_NATS;
      step[i] = wall[i] ? lesser : step[i];
    }
    double[][] curve = new double[free.length][free.length];
    for (int i = 0; i < free.length; i++) {
      int one = free[i];
      curve[i][i] =
          wall[one]
              ? 2 * both(fit, one, step[one], here, Math::min)
              : -curvature(fit, step, here, one, one);
      for (int j = 0; j < i; j++) {
        boolean isSmooth = !wall[one] && !wall[free[j]];
        curve[i][j] = isSmooth ? -curvature(fit, step, here, one, free[j]) : 0;
        curve[j][i] = curve[i][j];
      }
    }
    double[] steps = inSteps(curve);
    double[] deviations = new double[fit.size()];
    Arrays.fill(deviations, Double.POSITIVE_INFINITY);
    for (int i = 0; i < free.length; i++) {
      deviations[free[i]] = step[free[i]] * steps[i];
    }
    return deviations;
  }

  private static int[] withoutTables(Hypothesis fit) {
    List<Form> ofValues =
        fit.forms().stream()
            .flatMap(form -> Collections.nCopies(form.parameters().size(), form).stream())
            .toList();
    return IntStream.range(0, fit.size()).filter(i -> !ofValues.get(i).isTable()).toArray();
  }

  /** Such a step that the likelihood falls by about half a nat, to both sides or to the lesser. */
  private double step(Hypothesis fit, int i, double here, DoubleBinaryOperator which) {
    Parameter parameter = fit.parameters().get(i);
    double step =
        0.25
            * Math.min(
                parameter.high() - parameter.low(), Math.max(0.05, Math.abs(fit.values()[i])));
    for (int k = 0; k < HALVINGS; k++) {
      if (both(fit, i, step, here, which) < 4 * DROP_NATS) {
        break;
      }
      step /= 2;
    }
    return step;
  }

  /** By how much it falls, of the two sides; where the allowed ends there is one. */
  private double both(Hypothesis fit, int i, double step, double here, DoubleBinaryOperator which) {
    double up = here - at(fit, i, step);
    double down = here - at(fit, i, -step);
    return isOpen(fit, i, step) ? isOpen(fit, i, -step) ? which.applyAsDouble(up, down) : up : down;
  }

  private static boolean isOpen(Hypothesis fit, int i, double by) {
    double value = fit.values()[i];
    return Math.abs(fit.parameters().get(i).clamp(value + by) - value) > 0.5 * Math.abs(by);
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

  /**
   * The deviations in units of the steps, in which all are alike. A direction in which the
   * likelihood does not fall leaves only those values unbounded that have a part in it.
   */
  private double[] inSteps(double[][] curve) {
    double[] deviations = new double[curve.length];
    if (curve.length == 0) {
      return deviations;
    }
    EigenDecompositionSymmetric axes =
        new EigenDecompositionSymmetric(new Array2DRowRealMatrix(curve));
    for (int i = 0; i < deviations.length; i++) {
      double variance = 0;
      for (int axis = 0; axis < deviations.length; axis++) {
        double part = axes.getEigenvector(axis).getEntry(i);
        double fall = axes.getEigenvalue(axis);
        if (fall > FLAT_NATS) {
          variance += part * part / fall;
        } else if (Math.abs(part) > APART) {
          variance = Double.POSITIVE_INFINITY;
        }
      }
      deviations[i] = Math.sqrt(variance * clumping);
    }
    return deviations;
  }
}
