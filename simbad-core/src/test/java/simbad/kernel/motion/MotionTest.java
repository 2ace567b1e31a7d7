package simbad.kernel.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.stream.IntStream;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.junit.jupiter.api.Test;

class MotionTest {
  private static final double STEP_S = 0.05;
  private static final double EPSILON = 1e-12;

  private static List<Integer> updates(UpdateClock clock, int steps) {
    return IntStream.rangeClosed(1, steps).filter(i -> clock.tick(STEP_S)).boxed().toList();
  }

  @Test
  void clock_threePerSecond_isLateOnce() {
    UpdateClock clock = new UpdateClock();
    clock.setRate(3);
    assertEquals(List.of(1, 14, 21, 27, 34, 41, 47), updates(clock, 50));
    assertEquals(3, clock.ratePerS());
  }

  @Test
  void clock_eachStep_alwaysTicks() {
    UpdateClock clock = new UpdateClock();
    clock.setEachStep(true);
    assertEquals(10, updates(clock, 10).size());
  }

  @Test
  void clock_rateZero_ticksOnce() {
    UpdateClock clock = new UpdateClock();
    clock.setRate(0);
    assertEquals(List.of(1), updates(clock, 1000));
  }

  @Test
  void clock_badRate_isRefused() {
    assertThrows(IllegalArgumentException.class, () -> new UpdateClock().setRate(Double.NaN));
    assertThrows(IllegalArgumentException.class, () -> new UpdateClock().setRate(-1));
  }

  @Test
  void bodyDrive_goesAheadAndTurns() {
    BodyDrive drive = new BodyDrive();
    DriveStep step = new DriveStep();
    drive.setSpeed(2);
    drive.setTurn(-1);
    drive.advance(STEP_S, step);
    checkStep(step, 0.1, 0, -0.05);
    drive.stop();
    drive.advance(STEP_S, step);
    checkStep(step, 0, 0, 0);
    assertEquals(0, drive.speedMPerS());
    assertEquals(0, drive.turnRadPerS());
  }

  private static void checkStep(DriveStep step, double forwardM, double leftM, double turnRad) {
    assertEquals(forwardM, step.forwardM(), EPSILON);
    assertEquals(leftM, step.leftM(), EPSILON);
    assertEquals(turnRad, step.turnRad(), EPSILON);
  }

  @Test
  void differentialDrive_onOneWheel_circlesAboutTheOther() {
    // The right wheel drives a quarter circle about the left one, half the axle away from the
    // middle: the middle goes ahead by that and to the left by that.
    DifferentialDrive drive = new DifferentialDrive(0.4);
    DriveStep step = new DriveStep();
    drive.setRight(0.4 * Math.PI / 2);
    drive.advance(1, step);
    checkStep(step, 0.2, 0.2, Math.PI / 2);
  }

  @Test
  void differentialDrive_nearlyEqualWheels_goStraightAtTheLeftSpeed() {
    DifferentialDrive drive = new DifferentialDrive(0.4);
    DriveStep step = new DriveStep();
    drive.setLeft(0.3);
    drive.setRight(0.3005);
    drive.advance(1, step);
    checkStep(step, 0.3, 0, 0);
    assertEquals(0.3, drive.leftMPerS());
    assertEquals(0.3005, drive.rightMPerS());
    drive.stop();
    assertEquals(0, drive.leftMPerS());
  }

  @Property(seed = "20140914")
  void differentialDrive_arcHasTheMeanSpeed(
      @ForAll @DoubleRange(min = -1, max = 1) double left,
      @ForAll @DoubleRange(min = -1, max = 1) double right) {
    DifferentialDrive drive = new DifferentialDrive(0.3);
    DriveStep step = new DriveStep();
    drive.setLeft(left);
    drive.setRight(right);
    drive.advance(1e-4, step);
    double way = Math.hypot(step.forwardM(), step.leftM());
    double straightSlack = 1e-4 * 0.001;
    assertEquals(1e-4 * Math.abs(left + right) / 2, way, straightSlack);
  }

  @Test
  void differentialDrive_badAxle_isRefused() {
    assertThrows(IllegalArgumentException.class, () -> new DifferentialDrive(0));
    assertThrows(IllegalArgumentException.class, () -> new DifferentialDrive(Double.NaN));
  }

  @Test
  void plan_beforeReset_standsStill() {
    MotionPlan plan = new MotionPlan();
    plan.forward(1, 1);
    assertSame(WheelCommand.STOP, plan.next());
    assertFalse(plan.isRunning());
  }

  @Test
  void plan_goesThroughItsMotionsWithoutGap() {
    MotionPlan plan = new MotionPlan();
    plan.forward(1, 0.1);
    plan.turn(0.3, 0.15);
    plan.reset();
    checkNext(plan, 10, 0);
    checkNext(plan, 10, 0);
    // 0.15 * 20 is 3 in floating point, not a little less.
    checkNext(plan, 0, 2);
    checkNext(plan, 0, 2);
    checkNext(plan, 0, 2);
    assertSame(WheelCommand.STOP, plan.next());
  }

  private static void checkNext(MotionPlan plan, double speedMPerS, double turnRadPerS) {
    WheelCommand command = plan.next();
    assertEquals(speedMPerS, command.speedMPerS(), EPSILON);
    assertEquals(turnRadPerS, command.turnRadPerS(), EPSILON);
  }

  @Test
  void plan_loops() {
    MotionPlan plan = new MotionPlan();
    plan.forward(1, 0.05);
    plan.turn(1, 0.01);
    plan.loop();
    plan.reset();
    for (int i = 0; i < 10; i++) {
      checkNext(plan, 20, 0);
      assertTrue(plan.isRunning());
    }
  }
}
