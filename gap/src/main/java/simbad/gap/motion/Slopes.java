package simbad.gap.motion;

import java.util.ArrayList;
import java.util.List;
import simbad.motion.effect.MotionParameter;

/**
 * A fit to first order: how white residuals change with the values. Fits that leave blocks out, and
 * how values vary from block to block, are read off this without driving the model again.
 */
final class Slopes {
  private final Evidence evidence;
  private final Fit fit;
  private final Whitening[] white;

  /** Indices of the values that may move: motion depends smoothly on them. */
  private final List<Integer> free;

  /** By free value, component and step: by how much the white residual falls per unit. */
  private final double[][][] columns;

  private final Linear linear;

  Slopes(Evidence evidence, Fit fit) {
    this.evidence = evidence;
    this.fit = fit;
    white = fit.white(evidence);
    free = free(fit.hypothesis());
    columns = free.parallelStream().map(this::column).toArray(double[][][]::new);
    linear = new Linear(evidence, white, columns);
  }

  private static List<Integer> free(Hypothesis at) {
    List<MotionParameter> parameters = at.parameters();
    List<Integer> free = new ArrayList<>();
    for (int i = 0; i < parameters.size(); i++) {
      if (!parameters.get(i).stepped() && Double.isFinite(at.values()[i])) {
        free.add(i);
      }
    }
    return free;
  }

  private double[][] column(int index) {
    Hypothesis at = fit.hypothesis();
    MotionParameter parameter = at.parameters().get(index);
    double value = at.values()[index];
    double step = parameter.probe();
    double other = value + step > parameter.high() ? value - step : value + step;
    double[][] moved = evidence.residuals(at.withValue(index, other).chain());
    double[][] slopes = new double[moved.length][];
    for (int c = 0; c < slopes.length; c++) {
      double[] own = new double[moved[c].length];
      for (int i = 0; i < own.length; i++) {
        double by = fit.residuals()[c][i] - moved[c][i];
        own[i] = (c == 2 ? Evidence.wrapped(by) : by) / (other - value);
      }
      slopes[c] = white[c].of(own);
    }
    return slopes;
  }

  Whitening[] white() {
    return white;
  }

  /** Returns the columns of all free values. */
  double[][][] columns() {
    return columns;
  }

  Linear linear() {
    return linear;
  }

  boolean isEmpty() {
    return free.isEmpty();
  }

  /** Returns the fit's hypothesis after a damped step of Gauss and Newton on all blocks. */
  Hypothesis stepped(double damping) {
    return moved(linear.move(block -> true, damping));
  }

  /** Returns the hypothesis with the values that all blocks but those of a fold say. */
  Hypothesis withoutFold(int fold) {
    return moved(linear.withoutFold(fold));
  }

  private Hypothesis moved(double[] by) {
    Hypothesis moved = fit.hypothesis();
    List<MotionParameter> parameters = moved.parameters();
    for (int p = 0; p < by.length; p++) {
      int index = free.get(p);
      moved = moved.withValue(index, parameters.get(index).within(moved.values()[index] + by[p]));
    }
    return moved;
  }

  /** Returns standard errors of all values; 0 of those that are not free. */
  double[] standardErrors() {
    double[] errors = new double[fit.hypothesis().values().length];
    double[] own = linear.standardErrors();
    for (int p = 0; p < own.length; p++) {
      errors[free.get(p)] = own[p];
    }
    return errors;
  }
}
