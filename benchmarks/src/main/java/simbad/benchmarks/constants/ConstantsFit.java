package simbad.benchmarks.constants;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;
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

  private static final String MOST = "most";

  /** Under the level law; a unit of any sign may well mean so much in log odds. */
  private static final double LEVEL_SPREAD = 1;

  private final Constants former;

  ConstantsFit(Constants former) {
    this.former = former;
  }

  /** Returns the constants that the cases make most probable. */
  Constants of(List<CheckedCase> cases) {
    double[] fitted = regression(cases.stream().filter(one -> !one.isLevel()).toList());
    return new Constants(
        former.least(),
        most(fitted),
        fitted[0],
        weights(fitted),
        levelWeights(cases.stream().filter(CheckedCase::isLevel).toList()),
        temperature(cases, one -> !one.isLevel(), former.thresholdTemperature()),
        temperature(cases, CheckedCase::isLevel, former.levelTemperature()),
        namedRightly(cases, one -> !one.isLevel(), former.thresholdNamedRightly()),
        namedRightly(cases, CheckedCase::isLevel, former.levelNamedRightly()));
  }

  /**
   * Returns the probability that something without a name is at work.
   *
   * @param constants by which signs count
   * @param one case
   */
  static double unknown(Constants constants, CheckedCase one) {
    return one.isLevel() ? constants.unknownByLevels(one.signs()) : constants.unknown(one.signs());
  }

  /** What has no name but may be called by names, and was, needs no other word. */
  static boolean isUnknown(CheckedCase one) {
    return one.hasNameless() && !one.isNamedRightly();
  }

  private double[] start() {
    List<Double> values = new ArrayList<>(List.of(former.base()));
    values.addAll(former.weights().values());
    values.add(Math.log(former.most() / (1 - former.most())));
    return values.stream().mapToDouble(value -> value).toArray();
  }

  private static double most(double[] values) {
    return 1 / (1 + Math.exp(-values[values.length - 1]));
  }

  private Map<String, Double> weights(double[] values) {
    Map<String, Double> weights = new LinkedHashMap<>();
    int at = 1;
    for (String name : former.weights().keySet()) {
      weights.put(name, values[at++]);
    }
    return weights;
  }

  private Constants with(double[] values) {
    return new Constants(
        former.least(),
        most(values),
        values[0],
        weights(values),
        former.levelWeights(),
        former.thresholdTemperature(),
        former.levelTemperature(),
        former.thresholdNamedRightly(),
        former.levelNamedRightly());
  }

  /** Without a case, those that were known before. */
  private Map<String, Double> levelWeights(List<CheckedCase> cases) {
    if (cases.isEmpty()) {
      return former.levelWeights();
    }
    return levelWeights(
        Regression.fitted(
            Constants.LEVEL_SIGNS.size(),
            LEVEL_SPREAD,
            values -> logScore(withLevel(levelWeights(values)), cases)));
  }

  private static Map<String, Double> levelWeights(double... values) {
    Map<String, Double> weights = new LinkedHashMap<>();
    for (int i = 0; i < values.length; i++) {
      weights.put(Constants.LEVEL_SIGNS.get(i), values[i]);
    }
    return weights;
  }

  private Constants withLevel(Map<String, Double> weights) {
    return new Constants(
        former.least(),
        former.most(),
        former.base(),
        former.weights(),
        weights,
        former.thresholdTemperature(),
        former.levelTemperature(),
        former.thresholdNamedRightly(),
        former.levelNamedRightly());
  }

  private double[] regression(List<CheckedCase> cases) {
    double[] start = start();
    double[] spread =
        Arrays.stream(start).map(v -> Math.max(LEAST_SPREAD, SPREAD * Math.abs(v))).toArray();
    double[] low = new double[start.length];
    double[] high = new double[start.length];
    List<String> names = new ArrayList<>(List.of("base"));
    names.addAll(former.weights().keySet());
    names.add(MOST);
    for (int i = 0; i < start.length; i++) {
      // All others keep the sense that their name says.
      boolean isFree = i == 0 || names.get(i).equals(MOST);
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
  static double logScore(Constants constants, List<CheckedCase> cases) {
    double sum = 0;
    for (CheckedCase one : cases) {
      double unknown = unknown(constants, one);
      sum += Math.log(isUnknown(one) ? unknown : 1 - unknown);
    }
    return sum;
  }

  private static double temperature(
      List<CheckedCase> all, Predicate<CheckedCase> law, double before) {
    List<CheckedCase> cases = all.stream().filter(law).filter(one -> !one.hasNameless()).toList();
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

  private static double namedRightly(
      List<CheckedCase> all, Predicate<CheckedCase> law, double before) {
    List<CheckedCase> explained =
        all.stream().filter(law).filter(CheckedCase::isExplained).toList();
    long rightly = explained.stream().filter(CheckedCase::isNamedRightly).count();
    return (rightly + FORMER_CASES * before) / (explained.size() + FORMER_CASES);
  }
}
