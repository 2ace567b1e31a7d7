package simbad.experiments.export;

import java.util.Map;
import java.util.Optional;
import java.util.function.DoubleUnaryOperator;
import simbad.obstacles.ObstacleType;
import simbad.sonar.frame.Angles;
import simbad.sonar.level.Curve;
import simbad.sonar.level.LevelLaw;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.shape.Outline;

/**
 * An obstacle before a sensor as one C99 header without allocation: the level model without its
 * scatter, in whole numbers and in floats.
 */
public final class LevelHeader {
  private static final String TEMPLATE = "level.h.txt";
  private static final int BEAM_PER_DEG = 4;
  private static final int BEAMS = 722;

  /**
   * A calibrated strength lacks nothing between two of its bearings. One of thresholds is bent
   * there: with 4 points ranges were off by up to 0.26 mm, with 12 by 0.05.
   */
  private static final int ROUND_PER_BEARING = 12;

  private final HeaderTarget target;
  private final String name;
  private final LevelHeaderFigures figures;
  private final Optional<FoldedDiagnosis> diagnosis;

  /**
   * Prepares a header.
   *
   * @param type the obstacle; thresholds up to 8.191 m, a reach up to 1 m
   * @param sensor its greatest range up to 8.191 m
   * @param name that all names in the header begin with: small letters, digits, underscores
   * @throws IllegalArgumentException for a figure that a header cannot hold, or no such name
   */
  public LevelHeader(ObstacleType type, SonarSpec sensor, String name) {
    this(HeaderTarget.of(type, sensor), name, Optional.empty());
  }

  /**
   * Prepares the header of a diagnosis.
   *
   * @param diagnosis before one obstacle, of a sensor that hears by the level law
   * @param name that all names in the header begin with
   * @throws IllegalArgumentException for a figure that a header cannot hold, or no such name
   */
  public LevelHeader(FoldedDiagnosis diagnosis, String name) {
    this(diagnosis.levelTarget(), name, Optional.of(diagnosis));
  }

  private LevelHeader(HeaderTarget target, String name, Optional<FoldedDiagnosis> diagnosis) {
    SonarHeader.requireName(name);
    this.target = target;
    this.name = name;
    this.diagnosis = diagnosis;
    figures = LevelHeaderFigures.of(target);
  }

  /** Returns the same model in whole numbers, bit for bit. */
  public IntegerLevel inIntegers() {
    return new IntegerLevel(figures);
  }

  /**
   * Returns the diagnosed sensor in whole numbers, bit for bit.
   *
   * @throws java.util.NoSuchElementException for a header without a diagnosis
   */
  public IntegerDiagnosis diagnosisInIntegers() {
    return new IntegerDiagnosis(inIntegers(), DiagnosisFigures.of(diagnosis.orElseThrow()));
  }

  /**
   * Returns the header.
   *
   * @param version of the program, for the comment
   */
  public String text(String version) {
    Map<String, String> values = SonarHeader.words(target.type(), target.sensor(), name, version);
    whole(values);
    inFloats(values);
    values.put("effects", "");
    values.put("diagnosis", "");
    values.put("diagnosis_m", "");
    target.calibrated().ifPresentOrElse(way -> calibrated(way, values), () -> asBelieved(values));
    diagnosis.ifPresent(folded -> diagnosed(folded, values));
    values.put("base", SonarHeader.filled(SonarHeader.BASE, values));
    return SonarHeader.filled(TEMPLATE, values);
  }

  private void asBelieved(Map<String, String> values) {
    double[] threshold = target.type().thresholds().table().valuesM();
    values.put("thresholds", Integer.toString(threshold.length));
    values.put(
        "thresholds_m", SonarHeader.lines(threshold.length, i -> SonarHeader.number(threshold[i])));
    values.put("echo", SonarHeader.filled("level-thresholds.h.txt", values));
    values.put("way", "");
    values.put("range_halves", "halves");
    values.put("range_m", "best");
  }

  private void calibrated(HeaderTarget.Way way, Map<String, String> values) {
    int round = ROUND_PER_BEARING * target.bearings();
    values.put("round", Integer.toString(round));
    values.put("level_db", byBearing(round, target.echoDb(), LevelHeaderFigures::least));
    values.put("added_m", byBearing(round, way.addedM(), DoubleUnaryOperator.identity()));
    values.put("echo", SonarHeader.filled("level-echo.h.txt", values));
    values.put("added_half", SonarHeader.lines(figures.wayHalf()));
    values.put("way_scale", Integer.toString(figures.scale()));
    values.put("way", SonarHeader.filled("level-way.h.txt", values));
    values.put("range_halves", name + "_way(at, halves)");
    values.put(
        "range_m",
        "best * "
            + SonarHeader.number(way.scale())
            + " + "
            + name
            + "_round("
            + name
            + "_added_m, x_m, z_m)");
  }

  private static String byBearing(
      int round, DoubleUnaryOperator value, DoubleUnaryOperator written) {
    return SonarHeader.lines(
        round + 1,
        i ->
            SonarHeader.number(
                written.applyAsDouble(value.applyAsDouble(i % round * Angles.TURN_RAD / round))));
  }

  private void diagnosed(FoldedDiagnosis folded, Map<String, String> values) {
    values.put("held", "");
    values.put("held_in_floats", "");
    values.put("hear", name + "_read(own)");
    values.put("hear_m", name + "_read_m(");
    DiagnosisWords.put(folded, name, values);
  }

  private void whole(Map<String, String> values) {
    values.put("bearings", Integer.toString(figures.strengthCdb().length - 1));
    values.put("corners", Integer.toString(target.type().outline().size()));
    values.put("strength_cdb", SonarHeader.lines(figures.strengthCdb()));
    values.put("beam_cdb", SonarHeader.lines(figures.beamCdb()));
    values.put("losses", Integer.toString(figures.lossCdb().length));
    values.put("loss_cdb", SonarHeader.lines(figures.lossCdb()));
    values.put("walks", Integer.toString(figures.walkHalf().length));
    values.put("walk_half", SonarHeader.lines(figures.walkHalf()));
    values.put("corners_half_mm", SonarHeader.lines(figures.cornerHalfMm()));
    values.put("too_near", SonarHeader.tooNear(figures.leastHalves()));
    values.put("most_halves", Integer.toString(figures.mostHalves()));
    values.put("least_mm", SonarHeader.millimetres(target.sensor().minRangeM()));
    values.put("most_mm", SonarHeader.millimetres(target.sensor().maxRangeM()));
  }

  private void inFloats(Map<String, String> values) {
    LevelLaw law = target.law();
    Outline outline = target.type().outline();
    values.put(
        "corners_m",
        SonarHeader.lines(
            2 * outline.size(),
            i -> SonarHeader.number(i % 2 == 0 ? outline.xM(i / 2) : outline.zM(i / 2))));
    values.put("beam_db", SonarHeader.lines(BEAMS, i -> SonarHeader.number(beamDb(i))));
    curve(values, "receiver", "receivers", law.receiverThresholdDb());
    curve(values, "walk_m", "walk_points", law.walkM());
    values.put("spreading", SonarHeader.number(20 * law.spreadingExponent()));
    values.put("absorption", SonarHeader.number(2 * law.absorptionDbPerM()));
    values.put("least_m", SonarHeader.number(target.sensor().minRangeM()));
    values.put("most_m", SonarHeader.number(target.sensor().maxRangeM()));
    values.put("cone_half_angle_rad", SonarHeader.number(target.sensor().coneHalfAngleRad()));
  }

  private double beamDb(int index) {
    double offAxis = Math.toRadians(Math.min(180, index / (double) BEAM_PER_DEG));
    // Thresholds have the axis in them already.
    double axis = target.calibrated().isPresent() ? 0 : target.law().beam().axisDb();
    return LevelHeaderFigures.least(target.beamDb().applyAsDouble(offAxis) - axis);
  }

  private static void curve(Map<String, String> values, String word, String size, Curve curve) {
    values.put(size, Integer.toString(curve.size()));
    values.put(
        word,
        SonarHeader.lines(
            2 * curve.size(),
            i -> SonarHeader.number(i % 2 == 0 ? curve.x(i / 2) : curve.y(i / 2))));
  }
}
