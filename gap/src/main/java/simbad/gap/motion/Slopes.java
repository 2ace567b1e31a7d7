package simbad.gap.motion;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import simbad.motion.effect.MotionParameter;

/**
 * A fit to first order: how white residuals change with the values. Fits that leave blocks out, and
 * how values vary from block to block, are read off this without driving the model again.
 */
final class Slopes {
  private static final int MOST_HALVED = 6;

  /** Half a practical change, so many times: 30 of them, far more than logs leave open. */
  private static final double BELIEVED = 60;

  private final MotionSteps given;
  private final MotionFit fit;
  private final Whitening[] white;

  /** Indices of the values that may move: motion depends smoothly on them. */
  private final List<Integer> free;

  /** By free value, component and step: by how much the white residual falls per unit. */
  private final double[][][] columns;

  /** The same of the residuals as they are. */
  private final double[][][] raw;

  private final Linear linear;

  Slopes(MotionSteps given, MotionFit fit) {
    this(given, fit, Optional.empty());
  }

  /**
   * Computes the slopes.
   *
   * @param given the steps
   * @param fit whose values are moved
   * @param before slopes of a fit whose forms come first in this one; what is the same is taken
   */
  Slopes(MotionSteps given, MotionFit fit, Optional<Slopes> before) {
    this(given, fit, raw(given, fit, before));
  }

  private Slopes(MotionSteps given, MotionFit fit, double[][][] raw) {
    this.given = given;
    this.fit = fit;
    this.raw = raw;
    white = fit.white(given);
    free = free(fit.hypothesis());
    columns = Arrays.stream(raw).map(this::whitened).toArray(double[][][]::new);
    linear = new Linear(given, white, columns, belief());
  }

  /**
   * Values are believed to lie within some practical changes of where they change nothing: so much
   * that it matters only where blocks say nothing.
   */
  private Linear.Belief belief() {
    double[] precisions = new double[free.size()];
    double[] moves = new double[free.size()];
    for (int p = 0; p < precisions.length; p++) {
      MotionParameter parameter = fit.hypothesis().parameters().get(free.get(p));
      if (Double.isFinite(parameter.neutral())) {
        double deviation = BELIEVED * parameter.probe();
        precisions[p] = 1 / (deviation * deviation);
        moves[p] = parameter.neutral() - fit.hypothesis().values()[free.get(p)];
      }
    }
    return new Linear.Belief(precisions, moves);
  }

  /** Returns the steps that it is of. */
  MotionSteps given() {
    return given;
  }

  private static double[][][] raw(MotionSteps given, MotionFit fit, Optional<Slopes> before) {
    // Only where the further forms change nothing are residuals the very same.
    Optional<Slopes> same = before.filter(one -> one.fit.residuals() == fit.residuals());
    return free(fit.hypothesis()).parallelStream()
        .map(index -> same.flatMap(s -> s.rawOf(index)).orElseGet(() -> column(given, fit, index)))
        .toArray(double[][][]::new);
  }

  /**
   * Returns the slopes of a fit of the same forms.
   *
   * @param near whose values are so near that motion changes with them as it did
   */
  Slopes of(MotionFit near) {
    return new Slopes(given, near, raw);
  }

  /** Returns the slopes of another fit. */
  Slopes anew(MotionFit other) {
    return new Slopes(given, other);
  }

  private static List<Integer> free(MotionHypothesis at) {
    List<MotionParameter> parameters = at.parameters();
    List<Integer> free = new ArrayList<>();
    for (int i = 0; i < parameters.size(); i++) {
      if (!parameters.get(i).stepped() && Double.isFinite(at.values()[i])) {
        free.add(i);
      }
    }
    return free;
  }

  private Optional<double[][]> rawOf(int index) {
    int at = free.indexOf(index);
    return at < 0 ? Optional.empty() : Optional.of(raw[at]);
  }

  private static double[][] column(MotionSteps given, MotionFit fit, int index) {
    MotionHypothesis at = fit.hypothesis();
    MotionParameter parameter = at.parameters().get(index);
    double value = at.values()[index];
    double step = parameter.probe();
    double other = value + step > parameter.high() ? value - step : value + step;
    double[][] moved = given.residuals(at.withValue(index, other).chain());
    double[][] slopes = new double[moved.length][];
    for (int c = 0; c < slopes.length; c++) {
      double[] own = new double[moved[c].length];
      for (int i = 0; i < own.length; i++) {
        double by = fit.residuals()[c][i] - moved[c][i];
        own[i] = (c == 2 ? MotionSteps.wrapped(by) : by) / (other - value);
      }
      slopes[c] = own;
    }
    return slopes;
  }

  private double[][] whitened(double[][] column) {
    double[][] result = new double[column.length][];
    Arrays.setAll(result, c -> white[c].of(column[c]));
    return result;
  }

  MotionFit fit() {
    return fit;
  }

  Whitening[] white() {
    return white;
  }

  /** Returns by how much residuals fall per unit of each free value. */
  double[][][] raw() {
    return raw;
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
  MotionHypothesis stepped(double damping) {
    return moved(linear.move(block -> true, damping));
  }

  /**
   * Returns the hypothesis with the values that all blocks but those of a fold say. A step that
   * makes these blocks no likelier is halved: where a value hardly shows, first order goes far.
   */
  MotionHypothesis withoutFold(int fold) {
    double[] step = linear.withoutFold(fold);
    double before = withoutFold(fold, fit.hypothesis());
    for (int halved = 0; halved < MOST_HALVED; halved++) {
      MotionHypothesis moved = moved(step);
      if (withoutFold(fold, moved) >= before) {
        return moved;
      }
      step = Arrays.stream(step).map(by -> by / 2).toArray();
    }
    return fit.hypothesis();
  }

  /** Returns the log density of all blocks but those of a fold. */
  private double withoutFold(int fold, MotionHypothesis hypothesis) {
    double[][] residuals = given.residuals(hypothesis.chain());
    double sum = 0;
    for (int c = 0; c < residuals.length; c++) {
      Whitening own = new Whitening(given, fit.noises()[c], residuals[c]);
      for (int i = 0; i < given.size(); i++) {
        sum += given.foldOf(given.block(i)) == fold ? 0 : own.logDensity(i, own.white[i]);
      }
    }
    return sum;
  }

  private MotionHypothesis moved(double[] by) {
    MotionHypothesis moved = fit.hypothesis();
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
