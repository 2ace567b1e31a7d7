package simbad.gap.unexplained;

import java.util.LinkedHashMap;
import java.util.Map;
import simbad.sonar.check.Checks;

/**
 * What speaks for something that has no name in a log, beside its best set of effects: the numbers
 * that a logistic regression weighs. All are 0 where nothing does.
 *
 * @param misfit by how much the mean of the greatest misfits is more than by chance, standard
 *     normals, at least 0
 * @param left natural logarithm of what is left of the gap over what the set expects of itself
 * @param leftLittle whether what is left does not matter
 * @param shareLeft share of the gap that is left where effects are named
 * @param soaks whether an effect is named that takes up a little of anything
 * @param many whether more than two are named
 * @param twoForLittle whether two or more take away little of the gap
 * @param standIn whether a value stands at its bound, or one fits nothing that there is
 */
public record Signs(
    double misfit,
    double left,
    boolean leftLittle,
    double shareLeft,
    boolean soaks,
    boolean many,
    boolean twoForLittle,
    boolean standIn) {
  /** Refuses what is no number. */
  public Signs {
    Checks.number("misfit", misfit);
    Checks.number("left", left);
    Checks.number("shareLeft", shareLeft);
  }

  /** Nothing speaks for it. */
  static final Signs NONE = new Signs(0, 0, false, 0, false, false, false, false);

  /** Returns the same where a part of the set fits nothing that there is. */
  Signs withStandIn() {
    return new Signs(misfit, left, leftLittle, shareLeft, soaks, many, twoForLittle, true);
  }

  /** Returns the numbers by the names that their weights have, in a fixed order. */
  public Map<String, Double> byName() {
    Map<String, Double> all = new LinkedHashMap<>();
    all.put("misfit", misfit);
    all.put("left", left);
    all.put("left_little", number(leftLittle));
    all.put("share_left", shareLeft);
    all.put("soaks", number(soaks));
    all.put("many", number(many));
    all.put("two_for_little", number(twoForLittle));
    all.put("stand_in", number(standIn));
    return all;
  }

  private static double number(boolean holds) {
    return holds ? 1 : 0;
  }
}
