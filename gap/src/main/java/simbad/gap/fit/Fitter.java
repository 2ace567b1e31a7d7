package simbad.gap.fit;

import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.hipparchus.analysis.MultivariateFunction;
import org.hipparchus.exception.MathIllegalStateException;
import org.hipparchus.optim.InitialGuess;
import org.hipparchus.optim.MaxEval;
import org.hipparchus.optim.PointValuePair;
import org.hipparchus.optim.nonlinear.scalar.GoalType;
import org.hipparchus.optim.nonlinear.scalar.ObjectiveFunction;
import org.hipparchus.optim.nonlinear.scalar.noderiv.NelderMeadSimplex;
import org.hipparchus.optim.nonlinear.scalar.noderiv.SimplexOptimizer;
import simbad.definition.Parameter;
import simbad.sonar.predict.Answers;
import simbad.sonar.predict.ChangedModel;

/** Finds the values of a hypothesis that make the readings most probable. For one thread. */
public class Fitter {
  private static final double ENOUGH_NATS = 0.02;
  private static final double ROUGHLY_NATS = 0.2;
  private static final double SMALL = 0.03;
  private static final double FAR = 0.03;
  private static final double[] STRIDES = {-1, -0.5, -0.25, -0.1, -0.04, 0.04, 0.1, 0.25, 0.5, 1};

  private final CalibratedLog given;
  private final boolean[] counts;
  private final double[] row;

  /** A simplex asks again of where it began, and of the same end of an interval. */
  private final Map<Hypothesis, Double> known = new HashMap<>();

  private final Answers answers = new Answers();
  private final Geometries geometries;

  /** Of the pings that count alone. */
  private final Geometries counted;

  /**
   * Creates a fitter.
   *
   * @param given the log
   * @param fold the pings that count
   */
  public Fitter(CalibratedLog given, Fold fold) {
    this.given = given;
    row = new double[given.log().size()];
    counts = new boolean[row.length];
    for (int i = 0; i < counts.length; i++) {
      counts[i] = fold.holds(i);
    }
    geometries = given.geometries().ofFit(null);
    counted = fold == Fold.ALL ? geometries : given.geometries().ofFit(counts);
  }

  /** Returns the log likelihood of the pings that count. */
  public double logLikelihood(Hypothesis hypothesis) {
    Double before = known.get(hypothesis);
    if (before != null) {
      return before;
    }
    double now = computed(hypothesis);
    known.put(hypothesis, now);
    return now;
  }

  private double computed(Hypothesis hypothesis) {
    ChangedModel model = given.model(hypothesis);
    Geometries looked = model.looksBack() ? geometries : counted;
    given.logLikelihood(model, looked.of(model), row, counts, answers);
    double sum = 0;
    for (int i = 0; i < row.length; i++) {
      if (counts[i]) {
        sum += row[i];
      }
    }
    return sum;
  }

  /**
   * Refines all values of a start by the simplex method of Nelder and Mead (1965).
   *
   * @param start whose values all parameters are moved from
   * @param most number of evaluations
   */
  public Fit refine(Hypothesis start, int most) {
    return refine(start, 0, most);
  }

  /**
   * Refines the values of a start from one on; those before it stay.
   *
   * @param start whose values the parameters are moved from
   * @param from index of the first value that is moved
   * @param most number of evaluations
   */
  public Fit refine(Hypothesis start, int from, int most) {
    return climb(start, from, most, 1, ENOUGH_NATS);
  }

  /**
   * Refines the values of a start from one on, only as far as a choice among many starts needs.
   *
   * @param start whose values the parameters are moved from
   * @param from index of the first value that is moved
   * @param most number of evaluations
   */
  Fit approach(Hypothesis start, int from, int most) {
    return climb(start, from, most, 1, ROUGHLY_NATS);
  }

  /**
   * Refines all values of a fit that is good already, by small steps.
   *
   * @param start whose values all parameters are moved from
   * @param most number of evaluations
   */
  public Fit polish(Hypothesis start, int most) {
    return climb(start, 0, most, SMALL, ENOUGH_NATS);
  }

  /**
   * Moves one value after the other, by long steps and by short ones, and keeps what is better. A
   * simplex shrinks where a likelihood is flat between jumps, as it is in a value at which
   * something begins or ends.
   *
   * @param start a fit of the pings that count
   * @param from index of the first value that is moved
   */
  Fit sweep(Fit start, int from) {
    Fit best = start;
    for (int i = from; i < start.hypothesis().size(); i++) {
      Parameter parameter = start.hypothesis().parameters().get(i);
      double value = best.hypothesis().values()[i];
      double range = parameter.high() - parameter.low();
      double scale = Math.max(Math.abs(scale(parameter, value)), FAR * range);
      for (double stride : STRIDES) {
        double[] moved = best.hypothesis().values();
        moved[i] = parameter.clamp(value + stride * scale);
        Hypothesis there = best.hypothesis().with(moved);
        double likelihood = logLikelihood(there);
        best = likelihood > best.logLikelihood() ? new Fit(there, likelihood) : best;
      }
    }
    return best;
  }

  /**
   * Refines all values of a start until nothing is gained any more: where the likelihood is smooth
   * by Newton's method, else by simplexes, first by long steps and then by short ones.
   *
   * @param start whose values all parameters are moved from
   * @param from index of the first value that is moved
   * @param far number of evaluations of long steps, if it takes a simplex
   * @param near number of evaluations of short steps
   */
  public Fit settle(Hypothesis start, int from, int far, int near) {
    Hypothesis best = start;
    if (given.hearsByLevels() && start.size() > from) {
      Ascent ascent = new Ascent(this::logLikelihood, start, from, scales(start, from));
      Fit top = ascent.climb(ENOUGH_NATS);
      if (ascent.isSmooth()) {
        return top;
      }
      best = top.hypothesis();
    }
    return climb(
        climb(best, from, far, 1, ENOUGH_NATS).hypothesis(), from, near, SMALL, ENOUGH_NATS);
  }

  private double[] scales(Hypothesis start, int from) {
    double[] scales = new double[start.size()];
    for (int i = from; i < scales.length; i++) {
      scales[i] = Math.abs(scale(start.parameters().get(i), start.values()[i]));
    }
    return scales;
  }

  private Fit climb(Hypothesis start, int from, int most, double stride, double enoughNats) {
    Climb climb = new Climb(start, from);
    if (start.size() == from || most <= 0) {
      return climb.best();
    }
    double[] steps = new double[start.size() - from];
    Arrays.fill(steps, stride);
    try {
      PointValuePair ignored =
          new SimplexOptimizer(0, enoughNats)
              .optimize(
                  new MaxEval(most),
                  new ObjectiveFunction(climb),
                  GoalType.MAXIMIZE,
                  new InitialGuess(new double[steps.length]),
                  new NelderMeadSimplex(steps));
    } catch (MathIllegalStateException outOfEvaluations) {
      // The best so far stands.
    }
    return climb.best();
  }

  /** A first step: a quarter of the way from neutral, or a thirtieth of the interval. */
  private static double scale(Parameter parameter, double value) {
    double away = Math.abs(value - parameter.neutral());
    double least = 1e-3 * (parameter.high() - parameter.low());
    double step =
        away > 0 && away < Double.POSITIVE_INFINITY
            ? 0.2 * away
            : 0.03 * Math.max(Math.abs(value), Math.min(1, parameter.high() - parameter.low()));
    step = Math.max(step, least);
    return value + step > parameter.high() ? -step : step;
  }

  /** The likelihood as a function of steps away from a start, and the best place so far. */
  private final class Climb implements MultivariateFunction {
    private final double[] origin;
    private final double[] scale;
    private final List<Parameter> parameters;
    private final int from;
    private Fit best;

    Climb(Hypothesis start, int from) {
      this.from = from;
      origin = start.values();
      parameters = start.parameters();
      scale = new double[origin.length];
      for (int i = from; i < scale.length; i++) {
        scale[i] = scale(parameters.get(i), origin[i]);
      }
      best = new Fit(start, logLikelihood(start));
    }

    Fit best() {
      return best;
    }

    @Override
    public double value(double[] moved) {
      double[] values = origin.clone();
      double outside = 0;
      for (int i = 0; i < moved.length; i++) {
        double free = origin[from + i] + scale[from + i] * moved[i];
        values[from + i] = parameters.get(from + i).clamp(free);
        double over = (free - values[from + i]) / scale[from + i];
        outside += over * over;
      }
      Hypothesis there = best.hypothesis().with(values);
      double likelihood = logLikelihood(there);
      if (likelihood > best.logLikelihood()) {
        best = new Fit(there, likelihood);
      }
      return likelihood - outside;
    }
  }
}
