package simbad.gap.joint;

import java.util.List;
import simbad.gap.diagnosis.Diagnosis;
import simbad.gap.diagnosis.Verdict;
import simbad.gap.motion.MotionDiagnosis;
import simbad.sonar.check.Checks;

/**
 * What a joint log says: of its readings, of its commands and track, and of both together.
 *
 * @param verdict of the whole
 * @param reason why, one sentence without its full stop
 * @param explanation names concluded to be at work, each cause once
 * @param unknownProbability that something without a name is at work in either half
 * @param shared causes that show in both halves or might
 * @param sensing the half of the readings; its model has the values of both halves in it
 * @param motion the half of commands and track, likewise
 * @param isHeard whether there were readings enough to say anything
 */
public record JointDiagnosis(
    Verdict verdict,
    String reason,
    List<String> explanation,
    double unknownProbability,
    List<Shared> shared,
    Diagnosis sensing,
    MotionDiagnosis motion,
    boolean isHeard) {
  /** Copies the lists. */
  public JointDiagnosis {
    Checks.number("unknownProbability", unknownProbability);
    explanation = List.copyOf(explanation);
    shared = List.copyOf(shared);
  }
}
