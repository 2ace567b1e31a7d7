package simbad.gap.motion;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.TreeMap;

/**
 * By what it is judged how sure a diagnosis of motion is.
 *
 * @param isNamed whether an effect is concluded
 * @param strangerLogOdds log odds of something without a name, by what is left over alone
 * @param left share of the gap after that no scatter makes, in [0, 1]
 * @param worths of the effects of the most probable set, by name
 */
record MotionSigns(
    boolean isNamed, double strangerLogOdds, double left, Map<String, Double> worths) {
  /** Before the name of an effect: its worth. */
  static final String WORTH = "worth_";

  /** What regressions of what is left say more surely is not taken for surer. */
  private static final double SUREST = 0.001;

  /** Shares of the gap that are less are as good as none. */
  private static final double LEAST_SHARE = 1e-3;

  /** Copies the worths, in the order of their names. */
  MotionSigns {
    worths = new TreeMap<>(worths);
  }

  /**
   * Returns the worth of an effect: how many times what it takes away beside the others is what is
   * left that no scatter makes, as a natural logarithm.
   *
   * @param taken share of the gap
   * @param left share of the gap
   */
  static double worth(double taken, double left) {
    return Math.log(Math.max(LEAST_SHARE, taken) / Math.max(LEAST_SHARE, left));
  }

  /** Returns those of a conclusion. */
  static MotionSigns of(
      MotionConclusion conclusion, MotionDiagnosis.Gap gap, Map<String, Double> worths) {
    double unknown = Math.min(1 - SUREST, Math.max(SUREST, conclusion.unknown().probability()));
    return new MotionSigns(
        !conclusion.named().isEmpty(),
        Math.log(unknown / (1 - unknown)),
        gap.ratio() > 0 ? (gap.ratio() - gap.floor()) / gap.ratio() : 0,
        worths);
  }

  /** Returns them as numbers, each by its name. */
  Map<String, Double> byName() {
    Map<String, Double> signs = new LinkedHashMap<>();
    signs.put("named", isNamed ? 1.0 : 0);
    signs.put("stranger", strangerLogOdds);
    signs.put("stranger_beside", isNamed ? strangerLogOdds : 0);
    signs.put("left_beside", isNamed ? left : 0);
    signs.put("left_alone", isNamed ? 0 : left);
    worths.forEach((effect, worth) -> signs.put(WORTH + effect, worth));
    return signs;
  }
}
