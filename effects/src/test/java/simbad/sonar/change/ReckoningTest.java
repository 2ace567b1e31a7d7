package simbad.sonar.change;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;

import java.util.Map;
import org.junit.jupiter.api.Test;
import simbad.sonar.frame.Placement;
import simbad.sonar.ping.PoseChange;
import simbad.sonar.ping.TruePose;

class ReckoningTest {
  private static final double V = 0.2;
  private static final double W = 0.5;
  private static final double PERIOD_S = 0.01;
  private static final int STEPS = 1500;
  private static final Placement MOUNT = new Placement(0.1, -0.05, 1.2);

  /** On a circle from the origin, heading along x at first; z is down the page. */
  private static TruePose circle(double v, double w, double t) {
    TruePose pose = new TruePose();
    pose.set(v / w * Math.sin(w * t), -v / w * (1 - Math.cos(w * t)), w * t);
    return pose;
  }

  private static TruePose mounted(TruePose robot, Placement mount) {
    double a = robot.headingRad();
    TruePose pose = new TruePose();
    pose.set(
        robot.xM() + mount.xM() * Math.cos(a) + mount.zM() * Math.sin(a),
        robot.zM() + mount.zM() * Math.cos(a) - mount.xM() * Math.sin(a),
        a + mount.turnRad());
    return pose;
  }

  /** What a sensor's track makes of a believed circle is where the true circle has it. */
  private static void checkCircle(Reckoning reckoning, double trueV, double trueW) {
    PoseChange.Track track = reckoning.start("s", 0);
    Placement mount = reckoning.robotFromSensor().getOrDefault("s", Placement.IDENTITY);
    for (int i = 0; i <= STEPS; i++) {
      double t = i * PERIOD_S;
      TruePose pose = mounted(circle(V, W, t), mount);
      track.next(t, pose);
      TruePose expected = mounted(circle(trueV, trueW, t), mount);
      assertEquals(expected.xM(), pose.xM(), 1e-4, "x at " + t);
      assertEquals(expected.zM(), pose.zM(), 1e-4, "z at " + t);
      // A piece of an arc is believed as its chord, which is shorter by a millionth.
      assertEquals(expected.headingRad(), pose.headingRad(), 1e-6, "heading at " + t);
    }
  }

  @Test
  void largerWheels_goAndTurnFurther() {
    checkCircle(new Reckoning(1.05, 1.05, 0, 0, Map.of("s", MOUNT)), 1.05 * V, 1.05 * W);
  }

  @Test
  void longerWays_turnNoFurther() {
    checkCircle(new Reckoning(1.1, 1, 0, 0, Map.of()), 1.1 * V, W);
  }

  @Test
  void turnsBesides_areAddedByTimeAndByWay() {
    checkCircle(new Reckoning(1, 0.9, 0.02, 0, Map.of("s", MOUNT)), V, 0.9 * W + 0.02);
    checkCircle(new Reckoning(1.05, 1, 0, 0.1, Map.of("s", MOUNT)), 1.05 * V, W + 0.1 * 1.05 * V);
  }

  /** A heading in a file wraps at half a turn. */
  @Test
  void aHeadingThatWraps_isNoTurn() {
    Reckoning reckoning = new Reckoning(1, 1.05, 0, 0, Map.of());
    PoseChange.Track track = reckoning.start("s", 0);
    TruePose pose = new TruePose();
    pose.set(0, 0, Math.PI - 0.01);
    track.next(0, pose);
    pose.set(0, 0, -Math.PI + 0.01);
    track.next(1, pose);
    assertEquals(Math.PI - 0.01 + 1.05 * 0.02, pose.headingRad(), 1e-12);
  }

  @Test
  void neutralFigures_leavePosesAsTheyAre() {
    Reckoning neutral = new Reckoning(1, 1, 0, 0, Map.of("s", MOUNT));
    assertSame(PoseChange.Track.STILL, neutral.start("s", 0));
  }
}
