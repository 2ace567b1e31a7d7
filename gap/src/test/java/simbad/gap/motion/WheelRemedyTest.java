package simbad.gap.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import simbad.gap.diagnosis.Interval;
import simbad.motion.MotionChain;
import simbad.motion.Robot;

class WheelRemedyTest {
  private static final Robot WHEELS = new Robot(true, 0.2, false, 0, 0, MotionChain.EXACT);

  private static MotionFinding.Parameter parameter(String name, double value, double half) {
    Interval ci95 = new Interval(value - half, value + half);
    return new MotionFinding.Parameter(name, value, ci95, new Interval(-5, 5), false);
  }

  /** A turn for each metre, and the base that goes with it, if it is one wheel. */
  private static String remedy(Robot robot, double perMetre, double... baseAndHalf) {
    List<MotionFinding.Parameter> parameters = new ArrayList<>();
    parameters.add(parameter("turn_rad_per_m", perMetre, 0.002));
    if (baseAndHalf.length > 0) {
      parameters.add(parameter("signed_base_m", baseAndHalf[0], baseAndHalf[1]));
    }
    return WheelRemedy.of(
            new MotionFinding("wheel-asymmetry", "", 0.9, parameters, List.of(), "as it was"),
            robot)
        .remedy();
  }

  /** 4 % less of a wheel on 23 cm turn it by 0.04/0.23 rad for each metre. */
  @Test
  void oneWheel_isSaid_withItsSize() {
    String right = remedy(Robot.EXACT_UNICYCLE, -0.1739, 0.23, 0.006);
    assertTrue(right.startsWith("make the right wheel 4.0 % smaller, on a base of 0.230 m"), right);
    String left = remedy(Robot.EXACT_UNICYCLE, -0.1739, -0.23, 0.006);
    assertTrue(left.startsWith("make the left wheel 4.0 % larger"), left);
  }

  @Test
  void robotsOwnBase_isBetterThanTheFittedOne() {
    String own = remedy(WHEELS, 0.1, 0.3, 0.2);
    assertTrue(own.startsWith("make the right wheel 2.0 % larger, on a base of 0.200 m"), own);
    assertEquals(
        "as it was: on a base of 0.200 m the left wheel is 1.0 % larger than the other",
        remedy(WHEELS, -0.05));
  }

  @Test
  void unknownBase_orAnotherEffect_changesNothing() {
    assertEquals("as it was", remedy(Robot.EXACT_UNICYCLE, 0.1, 0.3, 0.2));
    assertEquals("as it was", remedy(WHEELS, 0.1, 0.3, 0.4));
    assertEquals("as it was", remedy(Robot.EXACT_UNICYCLE, 0.1));
    MotionFinding other = new MotionFinding("slip", "", 1, List.of(), List.of(), "");
    assertEquals(other, WheelRemedy.of(other, WHEELS));
  }
}
