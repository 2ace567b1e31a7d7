package simbad.gap.calibrate;

import java.util.Arrays;
import simbad.gap.calibrate.level.Along;
import simbad.gap.calibrate.level.EchoCurves;
import simbad.gap.calibrate.level.Leeway;
import simbad.gap.fit.CalibratedLog;
import simbad.gap.fit.Hypothesis;
import simbad.gap.unexplained.Openness;
import simbad.gap.unexplained.SetupScores;
import simbad.sonar.ping.Geometry;

/**
 * A level law that moves as far as its reference leaves open, beside a set of effects that stays as
 * it is. Levels move first: how far an echo reads depends on how strong it is.
 */
public final class SetupMove {
  private final Leeway open;
  private final CalibratedLog given;
  private final Hypothesis hypothesis;
  private final Geometry geometry;
  private final Leeway.Pulls pulls;
  private final EchoCurves echoes;

  /**
   * Asks a log.
   *
   * @param open how far the law may move
   * @param given of the log
   * @param hypothesis the set of effects
   */
  public SetupMove(Leeway open, CalibratedLog given, Hypothesis hypothesis) {
    this.open = open;
    this.given = given;
    this.hypothesis = hypothesis;
    geometry = given.geometry(given.model(hypothesis));
    pulls = Openness.pulls(geometry, hypothesis, open);
    echoes = SetupScores.echoes(hypothesis, changes -> given.logLikelihood(changes, geometry));
  }

  /** Returns the geometry of the log under the set of effects. */
  public Geometry geometry() {
    return geometry;
  }

  /** Returns the line of sight that a ping is most about; negative for none. */
  public int line(int ping) {
    return pulls.line(ping);
  }

  /** Returns where levels and log are likeliest together. */
  public Leeway.Moved levels() {
    return open.moved(pulls, echoes);
  }

  /**
   * Returns the same where levels may wander as well.
   *
   * @param along what
   * @param spreadDb how far, standard deviation, decibels
   */
  public Leeway.Wandered levels(Along along, double spreadDb) {
    return open.wandered(pulls, echoes, along, spreadDb);
  }

  /** Returns what the set-up's own values cost where nothing wanders, as a logarithm. */
  public double logShare() {
    return open.logShare(pulls, echoes);
  }

  /** Returns by how many nats the log is likelier where levels have moved, and ranges move too. */
  public double nats(Leeway.Moved levels) {
    LevelShift shift = new LevelShift(levels.shiftsDb());
    SetupScores.Slopes metres =
        SetupScores.metres(
            hypothesis, changes -> given.logLikelihood(shift.and(changes), geometry));
    double[] roomNats = Arrays.stream(metres.most()).map(most -> -most).toArray();
    return levels.nats() + open.rangeNats(pulls, metres.slope(), roomNats);
  }
}
