package simbad.benchmarks.constants;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.hipparchus.optim.InitialGuess;
import org.hipparchus.optim.MaxEval;
import org.hipparchus.optim.SimpleBounds;
import org.hipparchus.optim.nonlinear.scalar.GoalType;
import org.hipparchus.optim.nonlinear.scalar.ObjectiveFunction;
import org.hipparchus.optim.nonlinear.scalar.noderiv.BOBYQAOptimizer;
import org.hipparchus.optim.univariate.BrentOptimizer;
import org.hipparchus.optim.univariate.SearchInterval;
import org.hipparchus.optim.univariate.UnivariateObjectiveFunction;
import simbad.gap.unexplained.Constants;
import simbad.gap.unexplained.LawConstants;
import simbad.gap.unexplained.LevelConstants;
import simbad.gap.unexplained.ThresholdConstants;

/**
 * Most probable constants, given checked cases and the constants that were known before.
 *
 * <p>Each law has its own cases. Under the threshold rule the weights of the signs are those of a
 * logistic regression with a normal prior around the former ones, so that a few hundred cases move
 * what they speak of and leave the rest; the most that they may say has one around its former odds.
 * Under the level law they are those of one with a normal prior around 0. Each temperature makes
 * the accepted sets most probable among those that were weighed, with a log-normal prior around the
 * former one.
 */
final class ConstantsFit {
  /** A weight of 0 may well be 1; a large one came from hundreds of worlds: 6 may be 4.5. */
  private static final double LEAST_SPREAD = 1;

  private static final double SPREAD = 0.25;

  private static final double TEMPERATURE_SPREAD = 0.35;
  private static final double FURTHEST = 4;
  private static final int EVALUATIONS = 5000;

  /** What the former share of right names counts for, in cases. */
  private static final double FORMER_CASES = 100;

  /** Under the level law; a unit of any sign may well mean so much in log odds. */
  private static final double LEVEL_SPREAD = 1;

  private final Constants former;

  ConstantsFit(Constants former) {
    this.former = former;
  }

  /** Returns the constants that the cases make most probable. */
  Constants of(List<CheckedCase> cases) {
    return new Constants(
        threshold(cases.stream().filter(one -> !one.isLevel()).toList()),
        level(cases.stream().filter(CheckedCase::isLevel).toList()));
  }

  private ThresholdConstants threshold(List<CheckedCase> cases) {
    ThresholdConstants fitted = with(regression(cases));
    return new ThresholdConstants(
        fitted.least(),
        fitted.most(),
        fitted.weights(),
        temperature(cases, fitted.temperature()),
        namedRightly(cases, fitted.namedRightly()));
  }

  /** Without a case, those that were known before. */
  private LevelConstants level(List<CheckedCase> cases) {
    LevelConstants before = former.level();
    List<String> names = List.copyOf(before.weights().keySet());
    return cases.isEmpty()
        ? before
        : new LevelConstants(
            weights(
                names,
                Regression.fitted(
                    names.size(),
                    LEVEL_SPREAD,
                    values -> logScore(with(weights(names, values)), cases))),
            temperature(cases, before.temperature()),
            namedRightly(cases, before.namedRightly()));
  }

  private LevelConstants with(Map<String, Double> levelWeights) {
    return new LevelConstants(
        levelWeights, former.level().temperature(), former.level().namedRightly());
  }

  /** What has no name but may be called by names, and was, needs no other word. */
  static boolean isUnknown(CheckedCase one) {
    return one.hasNameless() && !one.isNamedRightly();
  }

  private double[] start() {
    ThresholdConstants before = former.threshold();
    List<Double> values = new ArrayList<>(before.weights().values());
    values.add(Math.log(before.most() / (1 - before.most())));
    return values.stream().mapToDouble(value -> value).toArray();
  }

  private static Map<String, Double> weights(Iterable<String> names, double... values) {
    Map<String, Double> weights = new LinkedHashMap<>();
    int at = 0;
    for (String name : names) {
      weights.put(name, values[at++]);
    }
    return weights;
  }

  /** Of weights, and of the log odds of the most that they may say. */
  private ThresholdConstants with(double[] values) {
    ThresholdConstants before = former.threshold();
    return new ThresholdConstants(
        before.least(),
        1 / (1 + Math.exp(-values[values.length - 1])),
        weights(before.weights().keySet(), values),
        before.temperature(),
        before.namedRightly());
  }

  private double[] regression(List<CheckedCase> cases) {
    double[] start = start();
    double[] spread =
        Arrays.stream(start).map(v -> Math.max(LEAST_SPREAD, SPREAD * Math.abs(v))).toArray();
    double[] low = new double[start.length];
    double[] high = new double[start.length];
    for (int i = 0; i < start.length; i++) {
      // A sign keeps the sense that its name says; the constant and the most may have any.
      boolean isFree = i == 0 || i == start.length - 1;
      low[i] = start[i] - FURTHEST * spread[i];
      high[i] = start[i] + FURTHEST * spread[i];
      if (!isFree) {
        low[i] = start[i] < 0 ? low[i] : Math.max(0, low[i]);
        high[i] = start[i] < 0 ? Math.min(0, high[i]) : high[i];
      }
    }
    return new BOBYQAOptimizer(2 * start.length + 1)
        .optimize(
            new MaxEval(EVALUATIONS),
            new ObjectiveFunction(values -> cost(cases, values, start, spread)),
            GoalType.MINIMIZE,
            new InitialGuess(start),
            new SimpleBounds(low, high))
        .getPoint();
  }

  private double cost(List<CheckedCase> cases, double[] values, double[] start, double[] spread) {
    double cost = -logScore(with(values), cases);
    for (int i = 0; i < values.length; i++) {
      double away = (values[i] - start[i]) / spread[i];
      cost += away * away / 2;
    }
    return cost;
  }

  /** Returns the sum over cases of the log probability of what is so, natural. */
  static double logScore(LawConstants constants, List<CheckedCase> cases) {
    double sum = 0;
    for (CheckedCase one : cases) {
      double unknown = constants.unknown(one.signs());
      sum += Math.log(isUnknown(one) ? unknown : 1 - unknown);
    }
    return sum;
  }

  private static double temperature(List<CheckedCase> all, double before) {
    List<CheckedCase> cases = all.stream().filter(one -> !one.hasNameless()).toList();
    double log =
        new BrentOptimizer(1e-4, 1e-4)
            .optimize(
                new MaxEval(200),
                new UnivariateObjectiveFunction(
                    t -> {
                      double away = (t - Math.log(before)) / TEMPERATURE_SPREAD;
                      return away * away / 2 - setScore(cases, Math.exp(t));
                    }),
                GoalType.MINIMIZE,
                new SearchInterval(Math.log(before / 4), Math.log(before * 4), Math.log(before)))
            .getPoint();
    return Math.exp(log);
  }

  /**
   * Returns the sum of the log probabilities of the accepted sets, of cases in which one of them
   * was weighed.
   */
  static double setScore(List<CheckedCase> cases, double temperature) {
    double sum = 0;
    for (CheckedCase one : cases) {
      double accepted = 0;
      double all = 0;
      for (CheckedCase.Weighed set : one.tried()) {
        double weight = Math.exp(-set.behindNats() / temperature);
        all += weight;
        accepted += one.accepted().contains(set.effects()) ? weight : 0;
      }
      // Below that a search that went astray would decide alone.
      sum += accepted > 0 ? Math.log(Math.max(1e-3, accepted / all)) : 0;
    }
    return sum;
  }

  private static double namedRightly(List<CheckedCase> cases, double before) {
    List<CheckedCase> explained = cases.stream().filter(CheckedCase::isExplained).toList();
    long rightly = explained.stream().filter(CheckedCase::isNamedRightly).count();
    return (rightly + FORMER_CASES * before) / (explained.size() + FORMER_CASES);
  }
}
