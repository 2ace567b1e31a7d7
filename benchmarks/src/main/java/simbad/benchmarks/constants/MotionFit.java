package simbad.benchmarks.constants;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import simbad.gap.diagnosis.Verdict;
import simbad.gap.motion.MotionConstants;

/**
 * Most probable constants of motion, given checked cases: logistic regressions whose weights have a
 * normal prior around 0, and the factor that holds 19 of 20 other drives.
 */
final class MotionFit {
  /** Signs are log odds, shares and counts: a unit of any may well mean so much in log odds. */
  private static final double SPREAD = 3;

  private static final double HELD = 0.95;

  private MotionFit() {}

  /** Returns the constants that the cases make most probable. */
  static MotionConstants of(List<CheckedDrive> cases) {
    int size = MotionConstants.VERDICT_SIGNS.size() + 1;
    double[] verdicts =
        Regression.fitted(
            2 * size,
            SPREAD,
            values -> verdictScore(constants(values, size, new double[0], 1), cases));
    double[] names =
        Regression.fitted(
            MotionConstants.NAME_SIGNS.size() + 1,
            SPREAD,
            values -> nameScore(constants(verdicts, size, values, 1), cases));
    return constants(verdicts, size, names, otherDrive(cases));
  }

  private static MotionConstants constants(
      double[] verdicts, int size, double[] names, double otherDrive) {
    return new MotionConstants(
        weights(Arrays.copyOf(verdicts, size), MotionConstants.VERDICT_SIGNS),
        weights(Arrays.copyOfRange(verdicts, size, 2 * size), MotionConstants.VERDICT_SIGNS),
        names.length == 0 ? Map.of() : weights(names, MotionConstants.NAME_SIGNS),
        otherDrive);
  }

  private static Map<String, Double> weights(double[] values, List<String> signs) {
    Map<String, Double> weights = new LinkedHashMap<>();
    weights.put(MotionConstants.BASE, values[0]);
    for (int i = 0; i < signs.size(); i++) {
      weights.put(signs.get(i), values[i + 1]);
    }
    return weights;
  }

  /** Returns the sum of the log probabilities of what is so, natural. */
  static double verdictScore(MotionConstants constants, List<CheckedDrive> cases) {
    return cases.stream()
        .mapToDouble(one -> Math.log(constants.verdict(one.truth(), one.signs())))
        .sum();
  }

  /** Returns the sum of the log probabilities that each weighed effect is there, or is not. */
  static double nameScore(MotionConstants constants, List<CheckedDrive> cases) {
    double sum = 0;
    for (CheckedDrive one : cases) {
      for (Map.Entry<String, Boolean> name : one.names().entrySet()) {
        double rightly = constants.namedRightly(one.signs(), name.getKey());
        sum += Math.log(name.getValue() ? rightly : 1 - rightly);
      }
    }
    return sum;
  }

  /** Returns what 19 of 20 other drives stay within. */
  static double otherDrive(List<CheckedDrive> cases) {
    double[] apart =
        cases.stream()
            .filter(one -> one.verdict() == Verdict.EXPLAINED)
            .flatMapToDouble(one -> one.otherDrive().stream())
            .sorted()
            .toArray();
    if (apart.length == 0) {
      throw new IllegalArgumentException("no explained case with a gap and a sealed drive");
    }
    return apart[(int) Math.ceil(HELD * apart.length) - 1];
  }

  /**
   * Returns constants for each case that were fitted without it, a fifth left out at a time.
   *
   * @param cases in an order that has nothing to do with what they are
   */
  static List<MotionConstants> heldOut(List<CheckedDrive> cases, int folds) {
    List<MotionConstants> fits = new ArrayList<>();
    for (int fold = 0; fold < folds; fold++) {
      List<CheckedDrive> rest = new ArrayList<>();
      for (int i = 0; i < cases.size(); i++) {
        if (i % folds != fold) {
          rest.add(cases.get(i));
        }
      }
      fits.add(of(rest));
    }
    List<MotionConstants> each = new ArrayList<>();
    for (int i = 0; i < cases.size(); i++) {
      each.add(fits.get(i % folds));
    }
    return each;
  }
}
