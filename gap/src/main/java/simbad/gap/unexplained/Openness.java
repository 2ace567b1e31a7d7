package simbad.gap.unexplained;

import java.util.Arrays;
import java.util.List;
import simbad.gap.calibrate.level.Leeway;
import simbad.gap.fit.CalibratedLog;
import simbad.gap.fit.Hypothesis;
import simbad.sonar.check.Checks;
import simbad.sonar.ping.Change;
import simbad.sonar.ping.Geometry;

/**
 * How much of what a hypothesis got wrong the set-up leaves open: all pings of a slice see the same
 * set-up, and are off together where it is.
 */
@SuppressWarnings("ArrayRecordComponent") // one value for each ping; read only
public record Openness(
    Leeway leeway, Leeway.Pulls pulls, double[] chancePerDb, double[] scorePerMetre) {
  /** Refuses what is no number. */
  public Openness {
    Checks.numbers("chancePerDb", chancePerDb);
    Checks.numbers("scorePerMetre", scorePerMetre);
  }

  /**
   * Asks how echoes and ranges depend on the set-up.
   *
   * @param given the log
   * @param hypothesis of it
   * @param leeway of the set-up
   */
  public static Openness of(CalibratedLog given, Hypothesis hypothesis, Leeway leeway) {
    Geometry geometry = given.geometry(given.model(hypothesis));
    double[] chance =
        SetupScores.perDecibel(
            hypothesis, changes -> new Surprise(given, given.model(changes)).expected);
    double[] score =
        SetupScores.perMetre(
            hypothesis, changes -> new Surprise(given, given.model(changes)).score);
    return new Openness(leeway, pulls(geometry, hypothesis, leeway), chance, score);
  }

  /** Finds how a log under a hypothesis depends on the set-up. */
  public static Leeway.Pulls pulls(Geometry geometry, Hypothesis hypothesis, Leeway leeway) {
    List<Change> changes = hypothesis.changes();
    double[] added = new double[geometry.log().size() * geometry.obstacles()];
    Arrays.setAll(added, line -> geometry.addedDb(changes, line));
    return leeway.pulls(geometry, added);
  }

  /**
   * Returns the scores of ranges where the set-up's ranges have moved to where they and the log are
   * likeliest. What is left of them scatters, wherever the set-up stands.
   */
  double[] moved(double[] score) {
    double[] shiftM = leeway.rangeShiftsM(pulls, score, scorePerMetre);
    double[] moved = new double[score.length];
    Arrays.setAll(moved, i -> score[i] + scorePerMetre[i] * shiftM[i]);
    return moved;
  }

  /** Returns an empty slice. */
  public Leeway.Together slice() {
    return leeway.together(pulls);
  }
}
