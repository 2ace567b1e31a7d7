package simbad.gap.motion;

import java.util.List;
import simbad.gap.diagnosis.Interval;
import simbad.gap.diagnosis.Verdict;

/**
 * What a diagnosis of motion concludes.
 *
 * @param verdict of the whole
 * @param headline one sentence that says why
 * @param findings effects at work, the surest first
 * @param unknownProbability that something without a name is at work
 * @param before gap of the nominal model by horizon (0.5, 2, 5 s) and component (along m, across m,
 *     turn rad)
 * @param after of the diagnosed model, on blocks that were not fitted
 * @param shrink of the gap, a fraction
 * @param shrinkCi95 interval of it
 * @param filterShare what a linear filter of the commands takes of the nominal model's absolute
 *     errors over half a second on blocks that it was not fitted to: along, across, turn
 * @param modelShare the same of the diagnosed model
 * @param places where the gap is
 * @param windows of half a second that were scored
 */
@SuppressWarnings("ArrayRecordComponent") // Numbers by window, never compared.
public record MotionDiagnosis(
    Verdict verdict,
    String headline,
    List<MotionFinding> findings,
    double unknownProbability,
    double[][] before,
    double[][] after,
    double shrink,
    Interval shrinkCi95,
    double[] filterShare,
    double[] modelShare,
    List<MotionPlace> places,
    int windows) {
  /** Copies the lists. */
  public MotionDiagnosis {
    findings = List.copyOf(findings);
    places = List.copyOf(places);
  }
}
