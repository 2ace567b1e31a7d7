package simbad.motion.effect;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.motion.Capture;
import simbad.motion.Command;
import simbad.motion.CommandUse;
import simbad.motion.Displacement;
import simbad.motion.MotionChain;
import simbad.motion.MotionChange;
import simbad.motion.MotionRun;
import simbad.motion.Response;
import simbad.motion.Robot;
import simbad.motion.Unicycle;
import simbad.motion.Way;

/** Each form beside what a hand computes. */
class MotionFormsTest {
  private static MotionChange change(String form, double... values) {
    return MotionForms.find(form).orElseThrow().change(values);
  }

  private static Displacement way(double speed, double turn, MotionChange change, double seconds) {
    MotionRun run = new MotionRun("a", List.of(new Command(0, speed, turn)), List.of());
    return Way.of(run, MotionChain.EXACT.with(change), 0, seconds + 1).between(0, seconds);
  }

  @Test
  void scales_multiplyWhatTheyName() {
    assertEquals(1.9, way(1, 0, change("speed-scale", 0.95), 2).alongM(), 1e-9);
    assertEquals(1.04, way(0, 0.5, change("turn-scale", 1.04), 2).turnRad(), 1e-9);
    assertEquals(0.9, way(1, 0, change("wheel-scale", 0.9), 1).alongM(), 1e-9);
    assertEquals(0.45, way(1, 0.5, change("wheel-scale", 0.9), 1).turnRad(), 1e-9);
  }

  @Test
  void scalesThatGrow_doSoWithWhatTheyScale() {
    MotionChange speed = change("speed-scale: growing with the speed", 0.9, 0.5);
    MotionChange turn = change("turn-scale: growing with the turn rate", 1.1, -0.2);

    assertEquals(0.2 * (0.9 + 0.5 * 0.2), speed.speed(0.2, 0), 1e-12);
    assertEquals(-0.4 * (0.9 + 0.5 * 0.4), speed.speed(-0.4, 0), 1e-12);
    assertEquals(3, speed.turn(3, 0.2), "turns are as they were");
    assertEquals(-1.5 * (1.1 - 0.2 * 1.5), turn.turn(-1.5, 0), 1e-12);
    assertEquals(0, turn.turn(7, 0), "no factor turns it round");
    assertEquals(0.2, turn.speed(0.2, 0));
  }

  @Test
  void veers_turnWithTime_orWithTheWay() {
    assertEquals(0.06, way(0, 0, change("turn-bias", 0.02), 3).turnRad(), 1e-9);
    assertEquals(0.3, way(0.5, 0, change("wheel-asymmetry", 0.2), 3).turnRad(), 1e-9);
    assertEquals(0, way(0, 0, change("wheel-asymmetry", 0.2), 3).turnRad());
  }

  @Test
  void deadBand_leavesOutSmallCommandsAlone() {
    MotionChange band = change("dead-band", 0.05, 0.1);

    assertEquals(0, band.commandedSpeed(0.049));
    assertEquals(-0.051, band.commandedSpeed(-0.051));
    assertEquals(0, band.commandedTurn(-0.09));
    assertEquals(0.1, band.commandedTurn(0.1));
  }

  @Test
  void deadBandOfFriction_isMissingFromEveryCommand() {
    MotionChange band = change("dead-band: less by it", 0.05, 0.1);

    assertEquals(0, band.commandedSpeed(0.049));
    assertEquals(-0.15, band.commandedSpeed(-0.2), 1e-12);
    assertEquals(0.4, band.commandedTurn(0.5), 1e-12);
  }

  @Test
  void saturation_cutsLargeCommandsOfEitherSign() {
    MotionChange speed = change("saturation: speed", 0.3);
    MotionChange turn = change("saturation: turning", 0.8);

    assertEquals(-0.3, speed.commandedSpeed(-2));
    assertEquals(0.2, speed.commandedSpeed(0.2));
    assertEquals(5, speed.commandedTurn(5));
    assertEquals(0.8, turn.commandedTurn(3));
    assertEquals(3, turn.commandedSpeed(3));
  }

  /** Two wheels 0.2 m apart whose rims reach 0.3 m/s, and a robot that must turn. */
  @Test
  void saturationWhileTurning_leavesForDrivingWhatTurningLeaves() {
    MotionChange first = change("saturation: speed while turning", 0.3, 0.1);

    assertEquals(0.3, way(1, 0, first, 1).alongM(), 1e-9);
    assertEquals(2, first.commanded(new Command(0, 1, 2)).turnRadPerS());
    assertEquals(0.1, first.commanded(new Command(0, 1, -2)).speedMPerS(), 1e-12);
    assertEquals(-0.1, first.commanded(new Command(0, -1, 2)).speedMPerS(), 1e-12);
    assertEquals(0, first.commanded(new Command(0, 1, 4)).speedMPerS());
    Command small = new Command(7, 0.05, -2);
    assertSame(small, first.commanded(small));
    double[] neutral =
        MotionForms.find("saturation: speed while turning").orElseThrow().neutralValues();
    assertEquals(
        9,
        change("saturation: speed while turning", neutral)
            .commanded(new Command(0, 9, 9))
            .speedMPerS());
  }

  /**
   * Cann's limiter: at the limit itself half a power of two is left, far above all of the limit.
   */
  @Test
  void saturationThatIsSoft_bendsTowardsItsLimit() {
    MotionChange soft = change("saturation: soft", 0.4, Double.POSITIVE_INFINITY, 0.25);
    MotionChange hard = change("saturation: soft", 0.4, 1, 0);

    assertEquals(0.4 / Math.pow(2, 0.25), soft.commandedSpeed(0.4), 1e-12);
    assertEquals(-0.4, soft.commandedSpeed(-40), 1e-8);
    assertEquals(0.05, soft.commandedSpeed(0.05), 1e-5);
    assertEquals(7, soft.commandedTurn(7));
    assertEquals(0.3, hard.commandedSpeed(0.3));
    assertEquals(-0.4, hard.commandedSpeed(-0.5));
    assertEquals(1, hard.commandedTurn(3));
  }

  /** No turns were commanded, or nothing at all: there is nothing to try. */
  @Test
  void saturationWhileTurning_isTriedOnlyWhereTurnsWereCommanded() {
    MotionForm form = MotionForms.find("saturation: speed while turning").orElseThrow();
    CommandUse straight = new CommandUse(new double[] {0.2}, new double[0], new double[0]);
    CommandUse both = new CommandUse(new double[] {0.2}, new double[] {0.5}, new double[0]);

    assertEquals(0, form.parameters().get(1).tries().apply(straight).length);
    double[] tries = form.parameters().get(1).tries().apply(both);
    assertEquals(0.04, tries[0], 1e-12);
    assertEquals(0.4, tries[tries.length - 1], 1e-12);
  }

  private static double[] ways(String form, double... values) {
    MotionRun run =
        new MotionRun(
            "a",
            List.of(
                new Command(0, 0.05, 0),
                new Command(1, 0.2, 0),
                new Command(2, 0.05, 0),
                new Command(3, 0.02, 0),
                new Command(4, 0.05, 0)),
            List.of());
    Way way = Way.of(run, MotionChain.EXACT.with(change(form, values)), 0, 6);
    double[] ways = new double[5];
    Arrays.setAll(ways, i -> way.between(i, i + 1).alongM());
    return ways;
  }

  /** It starts at 0.1 m/s, goes on at 0.05, stops at 0.02, and does not start at 0.05. */
  @Test
  void deadBandThatSticks_needsMoreToStartThanToGoOn() {
    assertArrayEquals(
        new double[] {0, 0.2, 0.05, 0, 0}, ways("dead-band: sticks", 0.1, 0, 0.4), 1e-9);
    assertArrayEquals(new double[] {0, 0.2, 0, 0, 0}, ways("dead-band: sticks", 0.1, 0, 1), 1e-9);
    assertArrayEquals(new double[] {0, 0.2, 0, 0, 0}, ways("dead-band", 0.1, 0), 1e-9);
  }

  @Test
  void quantization_takesTheNearestStep() {
    MotionChange steps = change("command-quantization", 0.05, 0.25);

    assertEquals(0.15, steps.commandedSpeed(0.16), 1e-12);
    assertEquals(-0.25, steps.commandedTurn(-0.3), 1e-12);
    assertEquals(0.16, change("command-quantization", 0, 0.25).commandedSpeed(0.16));
  }

  @Test
  void quantizationThatCuts_takesTheStepTowardsRest() {
    MotionChange steps = change("command-quantization: cut", 0.05, 0.25);

    assertEquals(0.15, steps.commandedSpeed(0.199), 1e-12);
    assertEquals(-0.15, steps.commandedSpeed(-0.15), 1e-12, "a whole step stays one");
    assertEquals(0, steps.commandedTurn(-0.2), 1e-12);
    assertEquals(0.199, change("command-quantization: cut", 0, 0).commandedSpeed(0.199));
  }

  /** To 1 m/s at 0.5 m/s2 takes 2 s and 1 m. */
  @Test
  void acceleration_isTheGreatest() {
    MotionChange limit = change("actuation-lag: greatest acceleration", 0.5, 1000);

    assertEquals(1 + 1, way(1, 0, limit, 3).alongM(), 1e-9);
  }

  @Test
  void braking_hasATimeConstantOfItsOwn() {
    MotionChange lag = change("actuation-lag: other in braking", 0.2, 0.1, 3);
    Response response = lag.response(Response.AT_ONCE);

    assertEquals(0.2, response.speedTimeConstantS());
    assertEquals(0.1, response.turnTimeConstantS());
    assertEquals(3, response.brakingFactor());
    double faster = response.over(0.02).speed().next(0, 1);
    double slower = 1 - response.over(0.02).speed().next(1, 0);
    assertTrue(faster > 2.5 * slower, faster + " and " + slower);
  }

  /** One form brakes down to rest before it turns back, the other speeds up at once. */
  @Test
  void braking_mayGoOnToRestAsItTurnsBack() {
    MotionChange back = change("actuation-lag: other in braking, also to turn back", 0.2, 0.1, 3);
    Response.Rate rate = back.response(Response.AT_ONCE).over(0.02).speed();
    MotionChange plain = change("actuation-lag: other in braking", 0.2, 0.1, 3);
    Response.Rate other = plain.response(Response.AT_ONCE).over(0.02).speed();
    double quick = 1 - Math.exp(-0.02 / 0.2);
    double slow = 1 - Math.exp(-0.02 / 0.6);

    assertEquals(1 - 2 * slow, rate.next(1, -1), 1e-12);
    assertEquals(1 - 4 * slow, rate.next(1, -3), 1e-12);
    assertEquals(-2 * quick, rate.next(0, -2), 1e-12);
    assertEquals(1 - 2 * quick, other.next(1, -1), 1e-12);
    assertEquals(1 - 0.5 * slow, other.next(1, 0.5), 1e-12);
  }

  /** Each rim speeds up by itself: in a curve the outer one needs longer. */
  @Test
  void accelerationOfAWheel_isThatOfItsRim() {
    Robot robot = new Robot(true, 0.2, false, 0, 0, MotionChain.EXACT);
    MotionChain chain = MotionChain.EXACT.with(wheel(robot, 0.5));
    // The right rim is told 0.4 m/s and needs 0.8 s; the left one stands, and is turned about.
    MotionRun run = new MotionRun("a", List.of(new Command(0, 0.2, 2)), List.of());
    double turn = (0.4 * 1 - 0.4 * 0.8 / 2) / 0.2;

    assertEquals(turn, Way.of(run, chain, 0, 3).between(0, 1).turnRad(), 1e-3);
    assertEquals(0.1 * Math.sin(turn), Way.of(run, chain, 0, 3).between(0, 1).alongM(), 1e-3);
    assertTrue(
        MotionChain.EXACT.with(wheel(robot, Double.POSITIVE_INFINITY)).responses().isEmpty());
  }

  private static MotionChange wheel(Robot robot, double acceleration) {
    return MotionForms.find("actuation-lag: greatest acceleration of a wheel", robot)
        .orElseThrow()
        .change(acceleration);
  }

  /** A step through two lags in series falls behind by the sum of their time constants. */
  @Test
  void secondLag_followsTheFirst() {
    MotionChain both =
        MotionChain.EXACT
            .with(change("actuation-lag: time constants", 0.2, 0.2))
            .with(change("actuation-lag: a second one", 0.1, 0.1, 1));
    MotionRun run = new MotionRun("a", List.of(new Command(0, 1, 0)), List.of());
    Way way = Way.of(run, both, 0, 6);

    assertEquals(2, both.responses().size());
    assertEquals(5 - 0.3, way.between(0, 5).alongM(), 1e-6);
    // t - T1 - T2 + (T1^2 exp(-t / T1) - T2^2 exp(-t / T2)) / (T1 - T2)
    double way300 = 0.3 - 0.3 + (0.04 * Math.exp(-1.5) - 0.01 * Math.exp(-3)) / 0.1;
    assertEquals(way300, way.between(0, 0.3).alongM(), 1e-3);
    assertTrue(MotionChain.EXACT.responses().isEmpty());
    assertEquals(
        List.of(new Response(0, 0, 1, 0.5, 3, false, 0)),
        MotionChain.EXACT
            .with(change("actuation-lag: a second one, greatest acceleration", 0.5, 3))
            .responses());
  }

  /** The rim of one wheel goes further, that of the other as far as before. */
  @ParameterizedTest
  @ValueSource(doubles = {0.3, -0.3})
  void oneWheel_leavesTheOtherAsItWas(double base) {
    MotionChange one = change("wheel-asymmetry: one wheel", 0.1, base);
    double speed = one.speed(0.4, 0.7);
    double turn = one.turn(0.7, speed);

    assertEquals(0.4 - 0.7 * base / 2, speed - turn * base / 2, 1e-12);
    assertEquals((1 + 0.1 * base) * (0.4 + 0.7 * base / 2), speed + turn * base / 2, 1e-12);
  }

  @Test
  void capture_addsUp() {
    MotionChain chain =
        MotionChain.EXACT
            .with(change("capture-offset: heading", 0.1))
            .with(change("capture-offset: point", 0.02, -0.01));

    assertEquals(new Capture(0.02, -0.01, 0.1), chain.capture());
    // A tracker whose heading is turned by 0.1 sees a way straight on to its right.
    MotionChange turned = change("capture-offset: heading", 0.1);
    assertEquals(-Math.sin(0.1), way(1, 0, turned, 1).acrossM(), 1e-9);
  }

  @Test
  void clocks_shiftEitherWay() {
    assertEquals(-0.4, change("time-offset", -0.4).delayS(0));
    assertEquals(
        0.9,
        new MotionChain(List.of(change("time-offset", 0.4)))
            .with(change("actuation-latency", 0.5))
            .delayS(),
        1e-12);
  }

  @Test
  void whatIsNoValue_isRefused() {
    MotionForm scale = MotionForms.find("speed-scale").orElseThrow();

    assertTrue(MotionForms.find("no-such-form").isEmpty());
    assertThrows(IllegalArgumentException.class, () -> scale.change(7));
    assertThrows(IllegalArgumentException.class, () -> scale.change(Double.NaN));
    assertThrows(IllegalArgumentException.class, () -> scale.change(1, 1));
    assertThrows(IllegalArgumentException.class, () -> MotionParameter.smooth("a", 1, 1, 1, 1));
    assertThrows(IllegalArgumentException.class, () -> new Command(0, Double.NaN, 0));
    assertThrows(IllegalArgumentException.class, () -> Unicycle.turnOfWheels(1, 1, 0));
    assertThrows(
        IllegalArgumentException.class, () -> new Robot(true, 0, false, 0, 0, MotionChain.EXACT));
    assertEquals(0.2, scale.parameters().get(0).within(-3));
  }

  @Test
  void wheels_goAndTurnAsTheirRimsDo() {
    assertEquals(0.3, Unicycle.speedOfWheels(0.2, 0.4), 1e-12);
    assertEquals(1, Unicycle.turnOfWheels(0.2, 0.4, 0.2), 1e-12);
  }

  private static final Robot WHEELS = new Robot(true, 0.2, false, 0, 0, MotionChain.EXACT);

  private static Command rims(String form, double value, double left, double right) {
    double speed = Unicycle.speedOfWheels(left, right);
    Command command = new Command(0, speed, Unicycle.turnOfWheels(left, right, 0.2));
    return MotionForms.find(form, WHEELS).orElseThrow().change(value).commanded(command);
  }

  /** Rims at 0.02 and 0.3 m/s: what acts on a wheel leaves the other alone. */
  @Test
  void wheels_areChangedOneByOne() {
    assertEquals(0.15, rims("dead-band: wheels", 0.05, 0.02, 0.3).speedMPerS(), 1e-12);
    assertEquals(1.5, rims("dead-band: wheels", 0.05, 0.02, 0.3).turnRadPerS(), 1e-12);
    assertEquals(0.11, rims("saturation: wheels", 0.2, 0.02, 0.3).speedMPerS(), 1e-12);
    assertEquals(0.9, rims("saturation: wheels", 0.2, 0.02, 0.3).turnRadPerS(), 1e-12);
    assertEquals(0.15, rims("command-quantization: wheels", 0.1, 0.02, 0.3).speedMPerS(), 1e-12);
    assertTrue(MotionForms.find("saturation: wheels").isEmpty());
    Command slowed = rims("saturation: wheels, the curve kept", 0.2, 0.02, 0.3);
    assertEquals(0.2, slowed.speedMPerS() + slowed.turnRadPerS() * 0.1, 1e-12);
    assertEquals(0.16 / 1.4, slowed.speedMPerS() / slowed.turnRadPerS(), 1e-12);
  }

  @Test
  void whatSaysTheSameTwice_isKnown() {
    MotionForm wheels = MotionForms.find("wheel-scale").orElseThrow();
    MotionForm speed = MotionForms.find("speed-scale").orElseThrow();
    MotionForm bias = MotionForms.find("turn-bias").orElseThrow();

    assertTrue(wheels.doublesWith(speed) && speed.doublesWith(wheels));
    assertTrue(!wheels.doublesWith(bias));
    assertEquals(14, MotionForms.vocabulary().size());
  }
}
