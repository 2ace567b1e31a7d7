package simbad.gap.unexplained;

import org.hipparchus.special.Erf;
import simbad.gap.fit.CalibratedLog;
import simbad.gap.fit.Fold;
import simbad.gap.fit.Hypothesis;
import simbad.sonar.ping.Geometry;
import simbad.sonar.ping.PingLog;
import simbad.sonar.predict.ChangedModel;
import simbad.sonar.predict.Expectation;

/**
 * What a hypothesis got wrong, ping by ping, given all readings before: whether there was an echo,
 * and where in its expected distribution the range lay. If the hypothesis is right, neither hangs
 * on anything.
 */
public final class Surprise {
  private static final double SURE = 1e-4;
  private static final double FARTHEST = 5;

  final PingLog log;
  final Geometry geometry;
  final double[] expected;
  final double[] score;

  /**
   * Returns how probable it was which pings had an echo, wherever: natural logarithm.
   *
   * @param fold the pings that count
   */
  public double echoNats(Fold fold) {
    double sum = 0;
    for (int ping = 0; ping < expected.length; ping++) {
      if (fold.holds(ping)) {
        sum += Math.log(log.echo(ping) ? expected[ping] : 1 - expected[ping]);
      }
    }
    return sum;
  }

  /** Takes what another got wrong of a ping. */
  public void take(Surprise other, int ping) {
    expected[ping] = other.expected[ping];
    score[ping] = other.score[ping];
  }

  /**
   * Asks what a hypothesis got wrong.
   *
   * @param given the log
   * @param hypothesis of it
   */
  public Surprise(CalibratedLog given, Hypothesis hypothesis) {
    this(given, given.model(hypothesis));
  }

  Surprise(CalibratedLog given, ChangedModel model) {
    geometry = given.geometry(model);
    log = given.log();
    Expectation expectation = model.expectation(geometry);
    expected = new double[log.size()];
    score = new double[log.size()];
    for (int i = 0; i < expected.length; i++) {
      // As in the likelihood, nothing is held for certain.
      expected[i] = Math.max(SURE, Math.min(1 - SURE, expectation.echo()[i]));
      if (log.echo(i)) {
        score[i] = score(expectation, i);
      }
    }
  }

  /**
   * The normal score of a place in the step that was read, among all echoes. The place is drawn, so
   * that scores are standard normal however coarse the steps are (Dunn and Smyth 1996).
   */
  private double score(Expectation expectation, int i) {
    double echo = expectation.echo()[i];
    if (!(echo > SURE)) {
      return 0;
    }
    double share = (expectation.below()[i] + expectation.reading()[i] * place(i)) / echo;
    double level = Math.max(1e-7, Math.min(1 - 1e-7, share));
    double quantile = -Math.sqrt(2) * Erf.erfcInv(2 * level);
    return Math.max(-FARTHEST, Math.min(FARTHEST, quantile));
  }

  /** Even in (0, 1), the same for the same ping at any time: a multiplicative hash of its index. */
  private static double place(int ping) {
    long mixed = (ping + 1) * 0x9E3779B97F4A7C15L;
    mixed = (mixed ^ (mixed >>> 32)) * 0xD6E8FEB86659FD93L;
    return ((mixed >>> 11) + 0.5) * 0x1.0p-53;
  }
}
