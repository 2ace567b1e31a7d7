package simbad.experiments.export;

import java.util.Map;
import simbad.sonar.frame.Placement;

/** What the headers of all diagnoses share: what is done before and behind the hearing. */
final class DiagnosisWords {
  private static final String WHOLE = "diagnosis.h.txt";
  private static final String IN_FLOATS = "diagnosis-m.h.txt";

  private DiagnosisWords() {}

  /**
   * Fills the places of a diagnosis.
   *
   * @param folded the diagnosis
   * @param name that all names in the header begin with
   * @param values which know already how it hears: hear, hear_m, held and held_in_floats
   */
  static void put(FoldedDiagnosis folded, String name, Map<String, String> values) {
    values.putAll(DiagnosisFigures.of(folded).words(name));
    RangeFigures ranges = folded.ranges();
    values.put("scale_m", SonarHeader.number(ranges.scale()));
    values.put("offset_m", SonarHeader.number(ranges.offsetM()));
    values.put("clamp_m", SonarHeader.number(ranges.clampM()));
    values.put("step_m", SonarHeader.number(ranges.stepM()));
    values.put("from_share", SonarHeader.number(ranges.fromHalves() / 2.0));
    values.put("report_share", SonarHeader.number(ranges.reportHalves() / 2.0));
    values.put("code_m", SonarHeader.number(ranges.codeM()));
    Placement moved = folded.moved();
    values.put("at_x_m", SonarHeader.number(moved.xM()));
    values.put("at_z_m", SonarHeader.number(moved.zM()));
    values.put("turned_cos", SonarHeader.number(Math.cos(moved.turnRad())));
    values.put("turned_sin", SonarHeader.number(Math.sin(moved.turnRad())));
    values.put("turned_rad", SonarHeader.number(moved.turnRad()));
    values.put("turn_rad", SonarHeader.number(folded.turnRad()));
    values.put("effects", effects(folded, name));
    values.put("diagnosis", SonarHeader.filled(WHOLE, values));
    values.put("diagnosis_m", SonarHeader.filled(IN_FLOATS, values));
  }

  /** What a diagnosis found, for the comment. */
  private static String effects(FoldedDiagnosis folded, String name) {
    String in = folded.folded().isEmpty() ? "none" : String.join(", ", folded.folded());
    String out = folded.leftOut().isEmpty() ? "none" : String.join(", ", folded.leftOut());
    String near =
        folded.nearFields().isEmpty()
            ? ""
            : " Left out as well, so that near an obstacle levels may differ by up to 3 dB"
                + " and ranges by some centimetres: "
                + String.join(", ", folded.nearFields())
                + ".";
    return SonarHeader.line(
            " * From a diagnosis. Effects included: "
                + in
                + ". Left out, since they only scatter: "
                + out
                + "."
                + near)
        + "\n * "
        + name
        + "_read_next reads with all of them; what it remembers is in "
        + name
        + "_memory.\n *\n";
  }
}
