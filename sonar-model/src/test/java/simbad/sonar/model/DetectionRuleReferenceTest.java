package simbad.sonar.model;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;
import simbad.sonar.fixture.Reference;
import simbad.sonar.fixture.Scenes;
import simbad.sonar.fixture.Sonars;
import simbad.sonar.frame.Point;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.scene.TableDetection;
import simbad.sonar.sensing.Readings;
import simbad.sonar.sensing.TransducerPoses;
import simbad.sonar.shape.Outline;

/**
 * The rules against a reference that samples outlines and cuts polygons. A reference by samples
 * knows each reading to an interval only: narrow where all is clear, up to infinity (no echo) where
 * a sample more or less decides.
 */
class DetectionRuleReferenceTest {
  private static final double NONE = Double.POSITIVE_INFINITY;
  private static final int CASES = 300;
  private static final SonarSpec SENSOR = Sonars.exact(27.5, 0.1, 3);

  private record Interval(double low, double high) {
    boolean isClear() {
      return low == NONE || high - low < 0.01;
    }
  }

  /** A scene with a sensor somewhere in it, which looks roughly at the first obstacle. */
  private record Case(Scene scene, Point tip, double headingRad) {
    static Case of(int seed) {
      Random random = new Random(seed);
      Scene scene = Scenes.any(random);
      Point tip = new Point(random.nextDouble(-3, 3), random.nextDouble(-3, 3));
      var at = scene.obstacles().get(0).worldFromObstacle();
      double towards = Math.atan2(tip.zM() - at.zM(), at.xM() - tip.xM());
      return new Case(scene, tip, towards + random.nextDouble(-1, 1));
    }

    double read(DetectionRule rule) {
      TransducerPoses poses = new TransducerPoses(1);
      poses.setPosition(0, tip.xM(), 0, tip.zM());
      poses.setDirection(0, Math.cos(headingRad), 0, -Math.sin(headingRad));
      Readings readings = new Readings(1);
      rule.bind(SENSOR, scene, new Random(1)).ping(poses, 0, readings);
      return readings.isEcho(0) ? readings.rangeM(0) : NONE;
    }

    double nearestM(Outline outline, double slackM) {
      return Reference.nearestM(outline, tip, headingRad, SENSOR.coneHalfAngleRad(), slackM);
    }

    /**
     * How deep the sensor stands in an obstacle's shadow; negative outside or where there is none.
     */
    double depthM(Obstacle obstacle) {
      Point own = obstacle.worldFromObstacle().obstacleFromWorld(tip);
      double threshold =
          obstacle.detection() instanceof TableDetection detection
              ? Reference.polygonRadiusM(
                  detection.table().valuesM(), Math.atan2(own.xM(), own.zM()))
              : obstacle.detection().greatestM();
      return threshold > 1e-9 ? threshold - Math.hypot(own.xM(), own.zM()) : -1;
    }

    Interval expected(Obstacle obstacle, double maxRangeM, boolean anyDepth) {
      Outline outline = obstacle.worldOutline();
      double step = Reference.stepM(outline);
      double low = nearestM(outline, step) - step;
      double high = nearestM(outline, -1e-9);
      double depth = anyDepth ? 1 : depthM(obstacle);
      boolean sure = depth > 1e-6 && low >= SENSOR.minRangeM() && high <= maxRangeM && high < NONE;
      boolean never = depth < -1e-6 || high < SENSOR.minRangeM() || low > maxRangeM;
      return new Interval(never ? NONE : low, sure ? high : NONE);
    }

    Interval expected(double maxRangeM, boolean anyDepth) {
      double low = NONE;
      double high = NONE;
      for (Obstacle obstacle : scene.obstacles()) {
        Interval one = expected(obstacle, maxRangeM, anyDepth);
        low = Math.min(low, one.low());
        high = Math.min(high, one.high());
      }
      return new Interval(low, high);
    }
  }

  /** All cases agree; at least 9 of 10 are clear, and of these many echo and many do not. */
  private static void check(DetectionRule rule, double maxRangeM, boolean anyDepth) {
    int clear = 0;
    int echoes = 0;
    for (int seed = 0; seed < CASES; seed++) {
      Case one = Case.of(seed);
      Interval expected = one.expected(maxRangeM, anyDepth);
      double found = one.read(rule);
      assertTrue(
          found >= expected.low() - 1e-9 && found <= expected.high() + 1e-9,
          "case " + seed + ": " + found + " not in " + expected);
      clear += expected.isClear() ? 1 : 0;
      echoes += found < NONE ? 1 : 0;
    }
    assertTrue(clear > 0.9 * CASES, "clear: " + clear);
    assertTrue(echoes > 0.15 * CASES && echoes < 0.85 * CASES, "echoes: " + echoes);
  }

  @Test
  void shadow_agreesWithTheReference() {
    check(DetectionRule.SHADOW, SENSOR.maxRangeM(), false);
  }

  @Test
  void noisy_withoutNoise_agreesWithTheReference() {
    check(DetectionRule.NOISY, SENSOR.maxRangeM(), false);
  }

  @Test
  void original_agreesWithTheReference() {
    check(DetectionRule.ORIGINAL, 2.5, true);
  }

  @Test
  void shadow_readsWithinReach_andImpliesTheWeakerRules() {
    for (int seed = 0; seed < 5 * CASES; seed++) {
      Case one = Case.of(seed);
      double shadow = one.read(DetectionRule.SHADOW);
      if (shadow < NONE) {
        assertTrue(shadow >= 0.1 && shadow <= 3, "case " + seed + ": " + shadow);
        assertTrue(one.read(DetectionRule.OVERLAP) <= shadow + 1e-12, "overlap, case " + seed);
        assertTrue(
            shadow > 2.5 || one.read(DetectionRule.ORIGINAL) <= shadow + 1e-12,
            "original, case " + seed);
      }
    }
  }

  /**
   * A point of the plane that is well in cone and shadow means an echo; if neither the tip nor any
   * point of the shadow's edge is near enough, there is none. The reading is the outline's
   * distance.
   */
  @Test
  void overlap_agreesWithTheReference() {
    int some = 0;
    int none = 0;
    for (int seed = 0; seed < CASES; seed++) {
      Case one = Case.of(seed);
      Scene alone = Scenes.of(one.scene().obstacles().get(0));
      Case single = new Case(alone, one.tip(), one.headingRad());
      double found = single.read(DetectionRule.OVERLAP);
      boolean overlaps = overlapsOnAGrid(single);
      assertTrue(found < NONE || !overlaps, "case " + seed + " overlaps but is not heard");
      if (found < NONE) {
        Outline outline = alone.obstacles().get(0).worldOutline();
        double dense = Reference.nearestM(outline, one.tip(), 0, Math.PI, 0);
        assertTrue(Math.abs(dense - found) <= Reference.stepM(outline), "case " + seed);
      }
      some += overlaps ? 1 : 0;
      none += found == NONE ? 1 : 0;
    }
    assertTrue(some > 0.3 * CASES && none > 0.1 * CASES, some + " overlap, " + none + " silent");
    assertTrue(some + none > 0.85 * CASES, "undecided: " + (CASES - some - none));
  }

  private static boolean overlapsOnAGrid(Case one) {
    for (int i = 0; i < 40; i++) {
      for (int k = -15; k <= 15; k++) {
        double distance = SENSOR.maxRangeM() * i / 40;
        double angle = one.headingRad() + SENSOR.coneHalfAngleRad() * k / 15 * 0.999999;
        Point point =
            new Point(
                one.tip().xM() + distance * Math.cos(angle),
                one.tip().zM() - distance * Math.sin(angle));
        if (new Case(one.scene(), point, 0).depthM(one.scene().obstacles().get(0)) > 1e-6) {
          return true;
        }
      }
    }
    return false;
  }
}
