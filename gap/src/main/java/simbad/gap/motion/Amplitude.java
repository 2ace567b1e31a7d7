package simbad.gap.motion;

import java.util.Arrays;

/**
 * How exactly an effect does what it says. What acts on each command in a way of its own, as steps
 * do, can be bent to anything that is left over: steps of some size round these commands up and
 * those down. Real ones change each command by just so much.
 */
final class Amplitude {
  private Amplitude() {}

  /**
   * Returns the standard error of the factor by which all that an effect changes would be larger,
   * from how far blocks pull apart; 1 is all of it.
   *
   * @param given the steps
   * @param set that has the effect
   * @param effect its name
   */
  static double standardError(MotionSteps given, ScoredMotion set, String effect) {
    double[][] without = given.residuals(set.hypothesis().without(effect).chain());
    double[][] with = set.fit().residuals();
    Whitening[] white = set.slopes().white();
    double[][] column = new double[with.length][];
    for (int c = 0; c < column.length; c++) {
      double[] change = new double[with[c].length];
      for (int i = 0; i < change.length; i++) {
        change[i] = MotionSteps.wrapped(without[c][i] - with[c][i]);
      }
      column[c] = white[c].of(change);
    }
    double[][][] own = set.slopes().columns();
    double[][][] all = Arrays.copyOf(own, own.length + 1);
    all[own.length] = column;
    return new Linear(given, white, all).standardErrors()[own.length];
  }
}
