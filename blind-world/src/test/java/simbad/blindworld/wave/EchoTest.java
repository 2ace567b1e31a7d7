package simbad.blindworld.wave;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.blindworld.world.Point;
import simbad.blindworld.world.Pose;

/** Echoes against closed forms. The sonar is at the origin and looks along +x. */
class EchoTest {

  private static final Air AIR = new Air(20, 0, 101.325);
  private static final Pose ORIGIN = new Pose(0, 0, 0);

  /** Cycles enough that an echo reaches its full height, and resonances that are over at once. */
  private static Gear gear(double pistonM, int cycles) {
    Burst.Resonance wide = new Burst.Resonance(40_000, 3);
    return new Gear(
        new Burst(40_000, cycles, wide, wide, 0),
        new Gear.Pistons(pistonM, pistonM, 0, 0),
        new Gear.Receiver(1, 1, 1, 0, 0.03, 0.01),
        0);
  }

  private static double level(Target target, Pose pose, double pistonM) {
    return level(target, pose, gear(pistonM, 120));
  }

  private static double level(Target target, Pose pose, Gear gear) {
    Medium medium = new Medium(gear, AIR);
    Trace trace = medium.drawn(target.arrivals(pose, medium, 0));
    double way = 2 * Math.hypot(target.place().xM() - pose.xM(), target.place().zM() - pose.zM());
    return trace.most() / medium.leftAfter(way);
  }

  private static Target wall(double distanceM, double halfM) {
    List<Point> corners =
        List.of(
            new Point(0, -halfM),
            new Point(0, halfM),
            new Point(0.05, halfM),
            new Point(0.05, -halfM));
    return new Target(Outline.of(corners), Upright.ENDLESS, new Point(distanceM, 0), 0);
  }

  /**
   * A wall sends back its mirror image: 1 / (2 d). The pistons' taper and the wall's own ends leave
   * some per cent.
   */
  @ParameterizedTest
  @ValueSource(doubles = {0.5, 1, 2})
  void wall_isItsMirrorImage(double distanceM) {
    assertEquals(1, level(wall(distanceM, 1.2), ORIGIN, 0.004) * 2 * distanceM, 0.05);
  }

  /** An upright cylinder spreads by sqrt(a / (a + d)) / (2 d), with d to its nearest line. */
  @ParameterizedTest
  @CsvSource({"0.1, 0.5", "0.1, 2", "0.3, 1", "0.05, 1.5"})
  void largeCylinder_spreadsByItsCurvature(double radiusM, double distanceM) {
    Target cylinder =
        new Target(Outline.round(radiusM), Upright.ENDLESS, new Point(distanceM + radiusM, 0), 0.7);
    double expected = Math.sqrt(radiusM / (radiusM + distanceM)) / (2 * distanceM);
    Medium medium = new Medium(gear(0.004, 120), AIR);
    Trace trace = medium.drawn(cylinder.arrivals(ORIGIN, medium, 0));
    double level = trace.most() / medium.leftAfter(2 * distanceM);
    assertEquals(expected, level, 0.05 * expected);
  }

  /**
   * An inside corner of right angles sends back as much as a wall at its vertex, from any side. The
   * burst is short, so that the legs' outer ends answer after it.
   */
  @ParameterizedTest
  @ValueSource(doubles = {-20, 0, 20})
  void insideCorner_isAWallFromAnySide(double turnDeg) {
    double leg = 0.5;
    double thick = 0.01;
    List<Point> corners =
        List.of(
            new Point(0, 0),
            new Point(-leg, -leg),
            new Point(-leg, -leg - thick),
            new Point(thick, 0),
            new Point(-leg, leg + thick),
            new Point(-leg, leg));
    Target corner =
        new Target(
            Outline.of(corners), Upright.ENDLESS, new Point(1.5, 0), Math.toRadians(turnDeg));
    assertEquals(1, 3 * level(corner, ORIGIN, gear(0.004, 8)), 0.05);
  }

  /** A plate's first null is where its ends are half a wave apart, out and back: w sin(a) = l/2. */
  @Test
  void plate_hasLobesOfItsWidth() {
    double width = 0.1;
    double wave = AIR.soundSpeedMPerS() / 40_000;
    double away = 6;
    Point place = new Point(away, 0);
    Target plate = new Target(wall(0, width / 2).outline(), Upright.ENDLESS, place, 0);
    double whole = level(plate, ORIGIN, 0.004);
    double atNull = level(plate.turned(Math.asin(wave / 2 / width)), ORIGIN, 0.004);
    double atSide = level(plate.turned(Math.asin(0.75 * wave / width)), ORIGIN, 0.004);
    assertTrue(atNull < 0.1 * whole, "null " + atNull / whole);
    assertEquals(2 / (3 * Math.PI), atSide / whole, 0.03);
  }

  /** 2 J1(x) / x: tables of J1 (Abramowitz and Stegun, 9.8) and the first zero at 3.83171. */
  @Test
  void piston_isBesselsFunction() {
    assertEquals(1, Piston.directivity(0), 1e-12);
    assertEquals(0.8801011715, Piston.directivity(1), 1e-9);
    assertEquals(2 * 0.0434727462 / 10, Piston.directivity(10), 1e-9);
    assertEquals(0, Piston.directivity(3.8317059702), 1e-9);
  }

  /** A 12 mm face at 40 kHz and 343.2 m/s is 6 dB down at 30.3 degrees, out alone. */
  @Test
  void piston_is6DbDownWhereItShould() {
    double perM = 2 * Math.PI * 40_000 / AIR.soundSpeedMPerS();
    Piston piston = new Piston(0.006, perM);
    assertEquals(0.5012, piston.at(Math.sin(Math.toRadians(30.3))), 0.003);
  }

  /** Beside the axis a small target's echo falls by the directivity squared. */
  @Test
  void echo_fallsByBothPistons() {
    Target pin = new Target(Outline.round(0.004), Upright.ENDLESS, new Point(1, 0), 0);
    double ahead = level(pin, ORIGIN, 0.007);
    double aside = level(pin, ORIGIN.turned(Math.toRadians(20)), 0.007);
    double once =
        new Piston(0.007, 2 * Math.PI * 40_000 / AIR.soundSpeedMPerS())
            .at(Math.sin(Math.toRadians(20)));
    assertEquals(once * once, aside / ahead, 0.01);
  }

  @Test
  void turnedReceiver_hearsLessAhead() {
    Gear gear = gear(0.007, 120);
    Gear turned = gear.with(gear.pistons().receiverTurned(Math.toRadians(20)));
    Target pin = new Target(Outline.round(0.004), Upright.ENDLESS, new Point(1, 0), 0);
    Medium straight = new Medium(gear, AIR);
    Medium crooked = new Medium(turned, AIR);
    double ahead = pin.arrivals(ORIGIN, straight, 0).most();
    double once =
        new Piston(0.007, 2 * Math.PI * 40_000 / AIR.soundSpeedMPerS())
            .at(Math.sin(Math.toRadians(20)));
    assertEquals(once, pin.arrivals(ORIGIN, crooked, 0).most() / ahead, 0.02);
  }

  /**
   * One resonance far wider than the other: the envelope rises as 1 - exp(-pi f t / Q) and falls as
   * exp(-pi f t / Q) after the burst.
   */
  @Test
  void envelope_ringsUpAndDown() {
    Burst burst =
        new Burst(
            40_000, 400, new Burst.Resonance(40_000, 20), new Burst.Resonance(40_000, 0.01), 0);
    double rate = Math.PI * 40_000 / 20;
    for (double tS : new double[] {1e-4, 3e-4, 1e-3}) {
      assertEquals(1 - Math.exp(-rate * tS), burst.envelope(tS).size(), 2e-3);
      assertEquals(Math.exp(-rate * tS), burst.envelope(0.01 + tS).size(), 2e-3);
    }
    assertEquals(0, burst.envelope(-1e-6).size());
  }

  /** Off resonance a long burst settles at 1 / |1 + 2 i Q df / f| for each of the two. */
  @Test
  void envelope_isLessBesideTheResonance() {
    Burst.Resonance resonance = new Burst.Resonance(40_000, 20);
    Burst burst = new Burst(41_000, 1000, resonance, resonance, 0);
    double detuning = 2 * 20 * 1000 / 40_000.0;
    assertEquals(1 / (1 + detuning * detuning), burst.envelope(0.02).size(), 1e-3);
  }

  /** The vertical sum of an endless target is that of a line: sqrt(pi r / k). */
  @Test
  void verticalSum_isALines() {
    Medium medium = new Medium(gear(0.0005, 8), AIR);
    for (double distanceM : new double[] {0.3, 1, 3}) {
      Complex sum = medium.over(Upright.ENDLESS).at(distanceM);
      double expected = Math.sqrt(Math.PI * distanceM / medium.perM());
      assertEquals(expected, sum.size(), 0.02 * expected);
      assertEquals(-Math.PI / 4, Math.atan2(sum.im(), sum.re()), 0.03);
    }
    assertThrows(IllegalArgumentException.class, () -> new Upright(1, 1));
  }
}
