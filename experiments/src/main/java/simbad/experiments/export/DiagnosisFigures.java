package simbad.experiments.export;

import java.util.HashMap;
import java.util.Map;
import simbad.sonar.frame.Placement;

/** The figures of a folded diagnosis in whole numbers; what does not fit is refused by name. */
record DiagnosisFigures(
    int atXMm,
    int atZMm,
    int turnedCdeg,
    int turnCdeg,
    int scale,
    int offsetMm,
    int clampMm,
    int stepMm,
    int fromHalves,
    int reportHalves,
    int codeMm,
    int repeats) {
  private static final int MOST_MM = 16_000;
  private static final double MOST_SCALE = 2;

  static DiagnosisFigures of(FoldedDiagnosis folded) {
    Placement moved = folded.moved();
    RangeFigures ranges = folded.ranges();
    if (!(ranges.scale() <= MOST_SCALE)) {
      throw new IllegalArgumentException(
          "scale of ranges = " + ranges.scale() + ", expected at most 2 in a C99 header");
    }
    return new DiagnosisFigures(
        millimetres("offset of the obstacle", moved.xM()),
        millimetres("offset of the obstacle", moved.zM()),
        cdeg(moved.turnRad()),
        cdeg(folded.turnRad()),
        (int) Math.rint(IntegerSonar.ONE * ranges.scale()),
        millimetres("offset of ranges", ranges.offsetM()),
        millimetres("least range", ranges.clampM()),
        millimetres("step of ranges", ranges.stepM()),
        ranges.fromHalves(),
        ranges.reportHalves(),
        ranges.codeM() < 0 ? -1 : millimetres("code for no echo", ranges.codeM()),
        folded.repeats());
  }

  private static int millimetres(String name, double metres) {
    double mm = Math.rint(1000 * metres);
    if (!(Math.abs(mm) <= MOST_MM)) {
      throw new IllegalArgumentException(
          name + " = " + metres + " m, expected at most 16 in a C99 header");
    }
    return (int) mm;
  }

  private static int cdeg(double radians) {
    return (int) Math.rint(100 * Math.toDegrees(radians));
  }

  boolean isMoved() {
    return atXMm != 0 || atZMm != 0 || turnedCdeg != 0;
  }

  /** What is reported for a distance. */
  int reportedMm(int mm) {
    int range = ((mm * scale + IntegerSonar.ONE / 2) >> 14) + offsetMm;
    range = Math.max(range, clampMm);
    return stepMm == 0
        ? range
        : ((2 * range + fromHalves * stepMm) / (2 * stepMm) * 2 * stepMm + reportHalves * stepMm)
            / 2;
  }

  /** What a template needs of them. */
  Map<String, String> words(String name) {
    Map<String, String> words = new HashMap<>();
    words.put("scale", Integer.toString(scale));
    words.put("offset_mm", Integer.toString(offsetMm));
    words.put("clamp_mm", Integer.toString(clampMm));
    words.put("step_mm", Integer.toString(stepMm));
    words.put("from_halves", Integer.toString(fromHalves * stepMm));
    words.put("report_halves", Integer.toString(reportHalves * stepMm));
    words.put("code_mm", Integer.toString(codeMm));
    words.put("repeats", Integer.toString(repeats));
    words.put("turn_cdeg", Integer.toString(turnCdeg));
    words.put("moved", isMoved() ? moved(name) : "");
    return words;
  }

  private String moved(String name) {
    return "  {\n    const "
        + name
        + "_pose obstacle = {"
        + atXMm
        + ", "
        + atZMm
        + ", "
        + turnedCdeg
        + "};\n    own = "
        + name
        + "_place(at, obstacle);\n  }\n";
  }
}
