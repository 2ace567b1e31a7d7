package simbad.gap.motion;

import java.util.LinkedHashMap;
import java.util.Map;

/**
 * By what it is judged how sure a diagnosis of motion is.
 *
 * @param isNamed whether an effect is concluded
 * @param strangerLogOdds log odds of something without a name, by what is left over alone
 * @param left share of the gap after that no scatter makes, in [0, 1]
 */
record MotionSigns(boolean isNamed, double strangerLogOdds, double left) {
  /** What regressions of what is left say more surely is not taken for surer. */
  private static final double SUREST = 0.001;

  /** Returns those of a conclusion. */
  static MotionSigns of(MotionConclusion conclusion, MotionDiagnosis.Gap gap) {
    double unknown = Math.min(1 - SUREST, Math.max(SUREST, conclusion.unknown().probability()));
    return new MotionSigns(
        !conclusion.named().isEmpty(),
        Math.log(unknown / (1 - unknown)),
        gap.ratio() > 0 ? (gap.ratio() - gap.floor()) / gap.ratio() : 0);
  }

  /** Returns them as numbers, each by its name. */
  Map<String, Double> byName() {
    Map<String, Double> signs = new LinkedHashMap<>();
    signs.put("named", isNamed ? 1.0 : 0);
    signs.put("stranger", strangerLogOdds);
    signs.put("stranger_beside", isNamed ? strangerLogOdds : 0);
    signs.put("left_beside", isNamed ? left : 0);
    signs.put("left_alone", isNamed ? 0 : left);
    return signs;
  }
}
