package simbad.gap.calibrate;

import simbad.gap.calibrate.level.Along;
import simbad.gap.calibrate.level.EchoCurves;
import simbad.gap.calibrate.level.Leeway;
import simbad.gap.fit.Evidence;
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
  private final Evidence evidence;
  private final Hypothesis hypothesis;
  private final Geometry geometry;
  private final Leeway.Pulls pulls;
  private final EchoCurves echoes;

  /**
   * Asks a log.
   *
   * @param open how far the law may move
   * @param evidence of the log
   * @param hypothesis the set of effects
   */
  public SetupMove(Leeway open, Evidence evidence, Hypothesis hypothesis) {
    this.open = open;
    this.evidence = evidence;
    this.hypothesis = hypothesis;
    geometry = evidence.geometry(evidence.model(hypothesis));
    pulls = Openness.pulls(geometry, hypothesis, open);
    echoes = SetupScores.echoes(hypothesis, changes -> evidence.logLikelihood(changes, geometry));
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
    double[] perMetre =
        SetupScores.perMetre(
            hypothesis, changes -> evidence.logLikelihood(shift.and(changes), geometry));
    return levels.nats() + open.rangeNats(pulls, perMetre);
  }
}
