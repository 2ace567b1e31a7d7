package simbad.sonar.model;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import simbad.sonar.fixture.Scenes;
import simbad.sonar.fixture.Sonars;
import simbad.sonar.frame.Placement;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.scene.TableDetection;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.Readings;
import simbad.sonar.sensing.TransducerPoses;
import simbad.sonar.shape.ThresholdTable;

/** The rules in closed form: a box at (2, 0), its face at 1.875 m from a sensor at (0, 0). */
class DetectionRuleTest {
  private static final double NONE = Double.POSITIVE_INFINITY;
  private static final SonarSpec NARROW = Sonars.exact(10, 0.03, 6);

  /** The range that a rule reads at (0, 0), infinity for a no-echo. */
  private static double range(
      DetectionRule rule, SonarSpec sensor, Scene scene, double headingDeg) {
    double heading = Math.toRadians(headingDeg);
    TransducerPoses poses = new TransducerPoses(1);
    poses.setDirection(0, Math.cos(heading), 0, -Math.sin(heading));
    return range(rule, sensor, scene, poses);
  }

  private static double range(
      DetectionRule rule, SonarSpec sensor, Scene scene, TransducerPoses poses) {
    Readings readings = new Readings(1);
    rule.bind(sensor, scene, new Random(1)).ping(poses, 0, readings);
    return readings.isEcho(0) ? readings.rangeM(0) : NONE;
  }

  /** Threshold, heading, what SHADOW, OVERLAP and ORIGINAL read; 9 stands for no echo. */
  @ParameterizedTest
  @CsvSource({
    // In the shadow and ahead: all hear the face.
    "2.5, 0, 1.875, 1.875, 1.875",
    "2, 0, 1.875, 1.875, 1.875",
    // Outside the shadow, which the cone meets.
    "1.99, 0, 9, 1.875, 1.875",
    "1, 0, 9, 1.875, 1.875",
    // The shadow, a disc of 1 m, spans 30 degrees to either side: the cone's border grazes it.
    "1, 39, 9, 1.875, 9",
    "1, -39, 9, 1.875, 9",
    "1, 41, 9, 9, 9",
    "1, 180, 9, 9, 9",
    // In the shadow but looking away: cone and shadow overlap, the outline is not in the cone.
    "2.5, 180, 9, 1.875, 9",
    "2.5, 90, 9, 1.875, 9",
    // Without a threshold nothing is heard but by the original.
    "0, 0, 9, 9, 1.875",
    "0, 180, 9, 9, 9"
  })
  void rules_ofOneBox(
      double thresholdM, double headingDeg, double shadow, double overlap, double original) {
    Scene scene = Scenes.of(Scenes.box(2, 0, thresholdM));
    checkRange(shadow, range(DetectionRule.SHADOW, NARROW, scene, headingDeg));
    checkRange(overlap, range(DetectionRule.OVERLAP, NARROW, scene, headingDeg));
    checkRange(original, range(DetectionRule.ORIGINAL, NARROW, scene, headingDeg));
    // Without noise and with a sharp edge the noisy rule is the shadow rule.
    checkRange(shadow, range(DetectionRule.NOISY, NARROW, scene, headingDeg));
  }

  private static void checkRange(double expected, double found) {
    assertEquals(expected == 9 ? NONE : expected, found, 1e-12);
  }

  /** At the centre the distance 0 is not above the threshold 0; nothing is heard all the same. */
  @Test
  void threshold0_isNotHeardAtTheCentre() {
    checkRange(9, range(DetectionRule.SHADOW, NARROW, Scenes.of(Scenes.box(0, 0, 0)), 0));
    checkRange(9, range(DetectionRule.OVERLAP, NARROW, Scenes.of(Scenes.box(0, 0, 0)), 0));
    checkRange(9, range(DetectionRule.NOISY, NARROW, Scenes.of(Scenes.box(0, 0, 0)), 0));
    checkRange(0.125, range(DetectionRule.SHADOW, NARROW, Scenes.of(Scenes.box(0, 0, 0.01)), 0));
  }

  /**
   * Both ends of the sensor's reach belong to it; a nearer point is not read as the least range.
   */
  @ParameterizedTest
  @CsvSource({
    "1.875, 6, 1.875",
    "1.8751, 6, 9",
    "0.03, 1.875, 1.875",
    "0.03, 1.8749, 9",
    "1.9, 2.2, 9"
  })
  void shadow_readsWithinTheSensorsReach(double minRangeM, double maxRangeM, double expected) {
    Scene scene = Scenes.of(Scenes.box(2, 0, 3));
    SonarSpec sensor = Sonars.exact(10, minRangeM, maxRangeM);
    checkRange(expected, range(DetectionRule.SHADOW, sensor, scene, 0));
    checkRange(expected, range(DetectionRule.NOISY, sensor, scene, 0));
  }

  /** 2.5 m is the original's own reach, whatever the sensor's; the least range is the sensor's. */
  @ParameterizedTest
  @CsvSource({
    "2.625, 0.03, 6, 2.5",
    "2.626, 0.03, 6, 9",
    "2.625, 0.03, 1, 2.5",
    "2, 1.875, 6, 1.875",
    "2, 1.876, 6, 9"
  })
  void original_hearsUpTo2500Millimetres(
      double centreM, double minRangeM, double maxRangeM, double expected) {
    Scene scene = Scenes.of(Scenes.box(centreM, 0, 0));
    SonarSpec sensor = Sonars.exact(10, minRangeM, maxRangeM);
    checkRange(expected, range(DetectionRule.ORIGINAL, sensor, scene, 0));
  }

  /** The shadow of 0.5 m begins 1.5 m away: a cone must be so long. */
  @ParameterizedTest
  @CsvSource({"1.49, 9", "1.51, 1.875", "6, 1.875"})
  void overlap_needsAConeThatReachesTheShadow(double maxRangeM, double expected) {
    Scene scene = Scenes.of(Scenes.box(2, 0, 0.5));
    SonarSpec sensor = Sonars.exact(10, 0.03, maxRangeM);
    checkRange(expected, range(DetectionRule.OVERLAP, sensor, scene, 0));
  }

  @ParameterizedTest
  @EnumSource
  void nearest_ofSeveralIsRead(DetectionRule rule) {
    Scene scene = Scenes.of(Scenes.box(2.25, 0, 5), Scenes.box(2, 0, 5), Scenes.box(-1, 0, 0.5));
    checkRange(1.875, range(rule, NARROW, scene, 0));
  }

  /** The nearer box is not in earshot: the further one answers. */
  @Test
  void nearest_thatAnswersIsRead() {
    Scene scene = Scenes.of(Scenes.box(1, 0, 0.5), Scenes.box(2, 0, 5));
    checkRange(1.875, range(DetectionRule.SHADOW, NARROW, scene, 0));
    checkRange(0.875, range(DetectionRule.ORIGINAL, NARROW, scene, 0));
  }

  @ParameterizedTest
  @EnumSource
  void emptyScene_isSilent(DetectionRule rule) {
    checkRange(9, range(rule, NARROW, Scenes.of(), 0));
  }

  /**
   * Heard from +z only, up to 3 m. The box is turned by a; the sensor sees it from its -x side,
   * that is at bearing 270 - a.
   */
  @ParameterizedTest
  @CsvSource({"0, 9", "-90, 1.875", "90, 9", "180, 9", "270, 1.875", "-85, 1.87", "-60, 9"})
  void shadow_turnsWithTheObstacle(double turnDeg, double expected) {
    double[] thresholds = new double[36];
    thresholds[35] = 3;
    thresholds[0] = 3;
    thresholds[1] = 3;
    Placement placement = new Placement(2, 0, Math.toRadians(turnDeg));
    Scene scene =
        Scenes.of(Scenes.box(placement, new TableDetection(ThresholdTable.of(thresholds))));
    double found = range(DetectionRule.SHADOW, NARROW, scene, 0);
    // Turned by 5 degrees a corner comes a little nearer than the face was.
    assertEquals(expected == 9 ? NONE : expected, found, expected == 1.87 ? 0.01 : 1e-12);
  }

  @ParameterizedTest
  @EnumSource
  void everyTransducer_hasItsOwnReading(DetectionRule rule) {
    TransducerPoses poses = new TransducerPoses(3);
    poses.setDirection(0, -1, 0, 0);
    poses.setPosition(1, 1, 0.05, 0);
    poses.setDirection(1, 1, 0, 0);
    poses.setPosition(2, 2, 0.05, 1);
    poses.setDirection(2, 0, 0, -1);
    Readings readings = new Readings(3);
    for (int i = 0; i < 3; i++) {
      readings.setEcho(i, 5);
    }
    rule.bind(NARROW, Scenes.of(Scenes.box(2, 0, 1.5)), new Random(1)).ping(poses, 0, readings);
    assertEquals(NoEcho.NO_ECHO, readings.reading(0), "what was read before is gone");
    assertEquals(new Echo(0.875), readings.reading(1));
    assertEquals(0.875, readings.rangeM(2), 1e-12);
  }

  /** Ranges are on the plane: a sensor that looks 60 degrees up reads what a level one reads. */
  @ParameterizedTest
  @EnumSource
  void tilt_doesNotShortenTheRange(DetectionRule rule) {
    TransducerPoses poses = new TransducerPoses(1);
    poses.setDirection(0, 0.5, Math.sqrt(0.75), 0);
    checkRange(1.875, range(rule, NARROW, Scenes.of(Scenes.box(2, 0, 3)), poses));
  }

  /** A sensor that looks straight up has no heading: its cone holds nothing of the plane. */
  @Test
  void straightUp_hearsNothing() {
    TransducerPoses poses = new TransducerPoses(1);
    poses.setDirection(0, 0, 1, 0);
    Scene scene = Scenes.of(Scenes.box(2, 0, 3));
    SonarSpec sensor = Sonars.exact(10, 0, 6);
    for (DetectionRule rule : new DetectionRule[] {DetectionRule.SHADOW, DetectionRule.ORIGINAL}) {
      checkRange(9, range(rule, sensor, scene, poses));
    }
  }
}
