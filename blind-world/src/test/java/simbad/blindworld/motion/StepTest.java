package simbad.blindworld.motion;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

/** What a step and a sight say of themselves, and what changes do to them. */
class StepTest {

  private static final double NEAR = 1e-12;

  private static Step told(double v, double w) {
    Step step = new Step(200);
    step.begin(3, 0.02, 50, new Commands.Speeds(v, w));
    step.place(1.5, -2.5, 0.6, 0.8);
    return step;
  }

  @Test
  void step_saysWhenAndWhereItBegins() {
    Step step = told(0.4, -0.3);
    assertEquals(3, step.timeS());
    assertEquals(0.02, step.durationS());
    assertEquals(0.25, step.logShare());
    assertEquals(200, step.logS());
    assertEquals(1.5, step.xM());
    assertEquals(-2.5, step.zM());
    assertEquals(0.6, step.directionX());
    // A heading is counter-clockwise as seen from above, and z is down the page.
    assertEquals(-0.8, step.directionZ());
  }

  @Test
  void speeds_areThoseToldUntilTheyAreChanged() {
    Step step = told(0.4, -0.3);
    assertEquals(0.4, step.v());
    assertEquals(-0.3, step.w());
    step.scale(2, 3);
    assertEquals(0.8, step.v(), NEAR);
    assertEquals(-0.9, step.w(), NEAR);
    step.addTurn(0.5);
    assertEquals(-0.4, step.w(), NEAR);
    step.set(7, 8);
    assertEquals(7, step.v());
    assertEquals(8, step.w());
    assertEquals(0.4, step.wantedV());
    assertEquals(-0.3, step.wantedW());
  }

  /** On a base of 0.2 m, 0.4 m/s and 0.5 rad/s are rims of 0.35 and 0.45 m/s. */
  @Test
  void wheels_areScaledEachByItsOwn() {
    Step step = told(0.4, 0.5);
    step.scaleWheels(2, 0.5, 0.2);
    assertEquals((0.7 + 0.225) / 2, step.v(), NEAR);
    assertEquals((0.225 - 0.7) / 0.2, step.w(), NEAR);
  }

  @Test
  void whatMovesItBesides_addsUp_untilTheNextStep() {
    Step step = told(0.4, 0);
    step.slideLeft(0.1);
    step.slideLeft(0.2);
    step.drift(1, 2);
    step.drift(0.5, -4);
    assertEquals(0.3, step.left(), NEAR);
    assertArrayEquals(new double[] {1.5, -2}, AnyStep.drift(step), NEAR);
    step.begin(3.02, 0.02, 50.02, new Commands.Speeds(0, 0));
    assertEquals(0, step.left());
    assertArrayEquals(new double[2], AnyStep.drift(step));
  }

  @Test
  void end_remembersTheSpeedsAndTheWay() {
    Step step = told(0.4, 0.1);
    step.set(0.5, 0.2);
    assertEquals(0, step.lastV());
    step.end();
    assertEquals(0.5, step.lastV());
    assertEquals(0.2, step.lastW());
    assertEquals(0.01, step.wayM(), NEAR);
    step.begin(3.02, 0.02, 50.02, new Commands.Speeds(-1, 0));
    assertEquals(0.5, step.lastV());
    step.end();
    assertEquals(0.03, step.wayM(), NEAR, "forth and back");
  }

  /** With a heading of 90 degrees forward is up the page and left is against x. */
  @Test
  void sight_isShiftedInItsOwnFrame() {
    Sight sight = AnyStep.seen(1, 2, Math.PI / 2);
    sight.shift(0.3, 0.1);
    assertEquals(0.9, sight.xM(), NEAR);
    assertEquals(1.7, sight.zM(), NEAR);
    assertEquals(Math.PI / 2, sight.headingRad());
    Sight along = AnyStep.seen(1, 2, 0);
    along.shift(0.3, 0.1);
    assertEquals(1.3, along.xM(), NEAR);
    assertEquals(1.9, along.zM(), NEAR);
  }

  @Test
  void sight_isTurnedAndMoved() {
    Sight sight = AnyStep.seen(1, 2, 3);
    sight.turn(0.5);
    sight.moveTo(-1, -2);
    assertEquals(3.5, sight.headingRad());
    assertEquals(-1, sight.xM());
    assertEquals(-2, sight.zM());
  }
}
