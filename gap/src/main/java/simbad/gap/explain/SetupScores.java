package simbad.gap.explain;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import simbad.gap.fit.Evidence;
import simbad.gap.fit.Hypothesis;
import simbad.sonar.change.LevelGain;
import simbad.sonar.change.RangeOffset;
import simbad.sonar.ping.Change;
import simbad.sonar.ping.Geometry;
import simbad.sonar.predict.DiagnosedModel;

/**
 * By how much each reading of a log would be likelier if echoes were stronger, or read longer, by a
 * little: what a set-up that is off shows itself by.
 */
@SuppressWarnings("ArrayRecordComponent") // one value for each ping; read only
record SetupScores(Geometry geometry, double[] perDecibel, double[] perMetre) {
  private static final double STEP_DB = 0.25;
  private static final double STEP_M = 0.001;

  /**
   * Asks a hypothesis under the level law.
   *
   * @param evidence the log
   * @param hypothesis of it
   */
  static SetupScores of(Evidence evidence, Hypothesis hypothesis) {
    DiagnosedModel model = evidence.model(hypothesis);
    return new SetupScores(
        evidence.geometry(model),
        slope(evidence, hypothesis, new LevelGain(STEP_DB), new LevelGain(-STEP_DB), STEP_DB),
        perMetre(evidence, hypothesis));
  }

  /** Returns by how much the log probability of each reading rises with its range. */
  static double[] perMetre(Evidence evidence, Hypothesis hypothesis) {
    return slope(evidence, hypothesis, new RangeOffset(STEP_M), new RangeOffset(-STEP_M), STEP_M);
  }

  private static double[] slope(
      Evidence evidence, Hypothesis hypothesis, Change more, Change less, double step) {
    double[] up = evidence.logLikelihood(and(hypothesis, more));
    double[] down = evidence.logLikelihood(and(hypothesis, less));
    Arrays.setAll(up, i -> (up[i] - down[i]) / (2 * step));
    return up;
  }

  private static List<Change> and(Hypothesis hypothesis, Change change) {
    List<Change> changes = new ArrayList<>(hypothesis.changes());
    changes.add(change);
    return changes;
  }
}
