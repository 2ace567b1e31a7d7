package simbad.experiments.export;

import java.util.Map;
import simbad.obstacles.ObstacleType;
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

  private final ObstacleType type;
  private final SonarSpec sensor;
  private final String name;
  private final LevelHeaderFigures figures;

  /**
   * Prepares a header.
   *
   * @param type the obstacle; thresholds up to 8.191 m, a reach up to 1 m
   * @param sensor its greatest range up to 8.191 m
   * @param name that all names in the header begin with: small letters, digits, underscores
   * @throws IllegalArgumentException for a figure that a header cannot hold, or no such name
   */
  public LevelHeader(ObstacleType type, SonarSpec sensor, String name) {
    SonarHeader.requireName(name);
    this.type = type;
    this.sensor = sensor;
    this.name = name;
    figures = LevelHeaderFigures.of(type, sensor);
  }

  /** Returns the same model in whole numbers, bit for bit. */
  public IntegerLevel inIntegers() {
    return new IntegerLevel(figures);
  }

  /**
   * Returns the header.
   *
   * @param version of the program, for the comment
   */
  public String text(String version) {
    Map<String, String> values = SonarHeader.words(type, sensor, name, version);
    whole(values);
    inFloats(values);
    values.put("base", SonarHeader.filled(SonarHeader.BASE, values));
    return SonarHeader.filled(TEMPLATE, values);
  }

  private void whole(Map<String, String> values) {
    values.put("bearings", Integer.toString(figures.strengthCdb().length - 1));
    values.put("corners", Integer.toString(type.outline().size()));
    values.put("strength_cdb", SonarHeader.lines(figures.strengthCdb()));
    values.put("beam_cdb", SonarHeader.lines(figures.beamCdb()));
    values.put("losses", Integer.toString(figures.lossCdb().length));
    values.put("loss_cdb", SonarHeader.lines(figures.lossCdb()));
    values.put("walks", Integer.toString(figures.walkHalf().length));
    values.put("walk_half", SonarHeader.lines(figures.walkHalf()));
    values.put("corners_half_mm", SonarHeader.lines(figures.cornerHalfMm()));
    values.put("least_halves", Integer.toString(figures.leastHalves()));
    values.put("most_halves", Integer.toString(figures.mostHalves()));
    values.put("least_mm", SonarHeader.millimetres(sensor.minRangeM()));
    values.put("most_mm", SonarHeader.millimetres(sensor.maxRangeM()));
  }

  private void inFloats(Map<String, String> values) {
    LevelLaw law = sensor.levelLaw();
    double[] threshold = type.thresholds().table().valuesM();
    Outline outline = type.outline();
    values.put("thresholds", Integer.toString(threshold.length));
    values.put(
        "thresholds_m", SonarHeader.lines(threshold.length, i -> SonarHeader.number(threshold[i])));
    values.put(
        "corners_m",
        SonarHeader.lines(
            2 * outline.size(),
            i -> SonarHeader.number(i % 2 == 0 ? outline.xM(i / 2) : outline.zM(i / 2))));
    values.put("beam_db", SonarHeader.lines(BEAMS, i -> SonarHeader.number(beamDb(law, i))));
    curve(values, "receiver", "receivers", law.receiverThresholdDb());
    curve(values, "walk_m", "walk_points", law.walkM());
    values.put("spreading", SonarHeader.number(20 * law.spreadingExponent()));
    values.put("absorption", SonarHeader.number(2 * law.absorptionDbPerM()));
    values.put("least_m", SonarHeader.number(sensor.minRangeM()));
    values.put("most_m", SonarHeader.number(sensor.maxRangeM()));
    values.put("cone_half_angle_rad", SonarHeader.number(sensor.coneHalfAngleRad()));
  }

  private static double beamDb(LevelLaw law, int index) {
    double offAxis = Math.toRadians(Math.min(180, index / (double) BEAM_PER_DEG));
    return LevelHeaderFigures.least(law.beam().twoWayDb(offAxis) - law.beam().axisDb());
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
