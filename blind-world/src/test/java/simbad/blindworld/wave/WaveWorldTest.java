package simbad.blindworld.wave;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.blindworld.world.Chance;
import simbad.blindworld.world.Point;
import simbad.blindworld.world.Pose;
import simbad.blindworld.world.Recording;
import simbad.blindworld.world.Row;

/** What a receiver makes of echoes. The sonar is at the origin and looks along +x. */
class WaveWorldTest {

  private static final Air AIR = new Air(20, 40, 101.325);
  private static final Pose ORIGIN = new Pose(0, 0, 0);
  private static final double PERIOD_S = 1 / 40_000.0;
  private static final Burst.Resonance RESONANCE = new Burst.Resonance(40_000, 18);
  private static final Gear GEAR =
      new Gear(
          new Burst(40_000, 8, RESONANCE, RESONANCE, 0),
          new Gear.Pistons(0.008, 0.008, 0, 0),
          new Gear.Receiver(0.004, 0.04, 0.002, 0.0005, 0.02, 0.0003),
          0);

  private static Target pole(double distanceM) {
    return new Target(
        Outline.round(0.03), new Upright(-0.15, 1), new Point(distanceM + 0.03, 0), 0);
  }

  private static WaveWorld world(Gear gear, Reflector... reflectors) {
    Counter counter = new Counter(AIR.soundSpeedMPerS(), 0, 0, 0);
    return new WaveWorld(
        new WaveWorld.Parts(gear, AIR, counter, 0.3, List.of(reflectors)), List.of());
  }

  /** The echoes of some pings, in seconds, rising. */
  private static double[] arrivals(WaveWorld world, int pings) {
    WaveWorld.Standing standing = world.standing(ORIGIN);
    Chance random = new Chance(4);
    double[] arrivals = new double[pings];
    for (int i = 0; i < pings; i++) {
      arrivals[i] = standing.arrivalS(random);
    }
    return Arrays.stream(arrivals).filter(Double::isFinite).sorted().toArray();
  }

  private static double median(double[] sorted) {
    return sorted[sorted.length / 2];
  }

  /** An echo is found within its rise, never before it begins. */
  @ParameterizedTest
  @ValueSource(doubles = {0.3, 0.7, 1.2})
  void echo_isFoundWithinItsRise(double distanceM) {
    double[] arrivals = arrivals(world(GEAR, pole(distanceM)), 100);
    double begins = 2 * distanceM / AIR.soundSpeedMPerS();
    assertEquals(100, arrivals.length);
    assertTrue(arrivals[0] > begins - PERIOD_S / 2, arrivals[0] + " before " + begins);
    assertTrue(arrivals[99] < begins + 20 * PERIOD_S, arrivals[99] + " after " + begins);
  }

  /**
   * With the same echo at a higher threshold it is found later, by whole periods of the carrier.
   */
  @Test
  void fainterEcho_isFoundWholePeriodsLater() {
    Gear.Receiver r = GEAR.receiver();
    Gear quiet =
        GEAR.with(
            new Gear.Receiver(r.floor(), r.start(), r.decayS(), r.armS(), r.timeoutS(), 1e-7));
    double loud = median(arrivals(world(quiet.louder(12), pole(1)), 60));
    double faint = median(arrivals(world(quiet, pole(1)), 60));
    double periods = (faint - loud) / PERIOD_S;
    assertTrue(periods > 1, periods + " periods");
    // The flicker's own phase is 0.15 rad, a fortieth of a period.
    assertEquals(Math.rint(periods), periods, 0.1);
  }

  /** One way is 2 pi a wave: what is moved by a fiftieth of a wave is found as much later. */
  @Test
  void arrival_followsThePhase() {
    double near = median(arrivals(world(GEAR.louder(20), pole(1)), 301));
    double further = median(arrivals(world(GEAR.louder(20), pole(1.0005)), 301));
    assertEquals(2 * 0.0005 / AIR.soundSpeedMPerS(), further - near, 0.03 * PERIOD_S);
  }

  @Test
  void receiver_isDeafBeforeItListensAndAfterItGivesUp() {
    Gear late = GEAR.with(GEAR.receiver().armedAt(0.007));
    assertEquals(0, arrivals(world(late, pole(1)), 20).length);
    assertEquals(20, arrivals(world(late, pole(1.3)), 20).length);
    Gear early = GEAR.with(GEAR.receiver().withTimeout(0.005));
    assertEquals(0, arrivals(world(early, pole(1)), 20).length);
    assertEquals(20, arrivals(world(early, pole(0.7)), 20).length);
  }

  /**
   * Two equal echoes half a wave of way apart take each other away; a whole wave apart they add.
   */
  @Test
  void echoesAddCoherently() {
    double wave = AIR.soundSpeedMPerS() / 40_000;
    double alone = world(GEAR, pole(1)).standing(ORIGIN).excessDb();
    double against = world(GEAR, pole(1), pole(1 + wave / 4)).standing(ORIGIN).excessDb();
    double together = world(GEAR, pole(1), pole(1 + wave / 2)).standing(ORIGIN).excessDb();
    assertTrue(against < alone - 15, against + " against " + alone);
    assertEquals(alone + 6, together, 0.7);
  }

  /** Noise of a third of the threshold is taken for an echo now and then, of a thirteenth never. */
  @Test
  void noise_crossesALowThreshold() {
    Gear hissing = GEAR.with(GEAR.receiver().noisier(4));
    int false4 = arrivals(world(hissing, pole(6)), 300).length;
    assertTrue(false4 > 10 && false4 < 290, false4 + " of 300");
    assertEquals(0, arrivals(world(GEAR, pole(6)), 300).length);
  }

  /** 6 dB over the threshold by itself, at its own distance, wherever the sonar looks. */
  @Test
  void fixedEcho_goesWithTheSonar() {
    FixedEcho floor = new FixedEcho(0.8, 6, 1);
    WaveWorld world = world(GEAR, floor);
    assertEquals(6, world.standing(ORIGIN).excessDb(), 0.5);
    assertEquals(6, world.standing(new Pose(3, -2, 1)).excessDb(), 0.5);
    double[] arrivals = arrivals(world, 50);
    assertEquals(50, arrivals.length);
    assertEquals(2 * 0.8 / AIR.soundSpeedMPerS(), median(arrivals), 15 * PERIOD_S);
  }

  /** By a board beside it the echo's way is half the direct one and half that to its image. */
  @Test
  void mirroredEcho_comesByTheLongerWay() {
    // The board lies along x, 0.5 below on the page; the pole's image is 1 m below the pole.
    Target pole = pole(1);
    Mirrored echo = new Mirrored(pole, new Point(0, 0.5), new Point(1, 0.5));
    Gear broad = GEAR.with(new Gear.Pistons(0.002, 0.002, 0, 0)).louder(20);
    double image = Math.hypot(1.03, 1) - 0.03;
    double expected = (1 + image) / AIR.soundSpeedMPerS();
    double[] arrivals = arrivals(world(broad, echo), 50);
    assertEquals(50, arrivals.length);
    assertEquals(expected, median(arrivals), 12 * PERIOD_S);
    Mirrored behind = new Mirrored(pole, new Point(2, 0.5), new Point(3, 0.5));
    assertEquals(0, arrivals(world(broad, behind), 50).length, "the way misses the board");
  }

  private static Recording rows() {
    return new Recording(
        List.of(
            new Row("a", "s", 0, ORIGIN),
            new Row("a", "s", 0.1, new Pose(0.4, 0, 0)),
            new Row("a", "t", 0.1, new Pose(0.4, 0, 2)),
            new Row("b", "s", 0, new Pose(0.2, 0.05, 0.1))));
  }

  @Test
  void sameSeed_givesTheSameReadings() {
    WaveWorld.Listening one = world(GEAR, pole(1)).at(rows());
    WaveWorld.Listening other = world(GEAR, pole(1)).at(rows());
    assertArrayEquals(one.read(7), other.read(7));
    assertEquals(0.6, one.read(7)[1], 0.06);
    assertEquals(Double.POSITIVE_INFINITY, one.read(7)[2], "it looks away");
  }

  /** A swing is over after half its period and back after a whole one. */
  @Test
  void swayingTarget_isWhereItsSwingIs() {
    Swaying swaying = new Swaying(pole(1), 0.2, 0, 0.4);
    Recording rows =
        new Recording(
            List.of(
                new Row("a", "s", 0, ORIGIN),
                new Row("a", "s", 0.1, ORIGIN),
                new Row("a", "s", 0.3, ORIGIN)));
    double[] readings = world(GEAR.louder(10), swaying).at(rows).read(1);
    assertEquals(0.2, readings[1] - readings[0], 0.01);
    assertEquals(-0.2, readings[2] - readings[0], 0.01);
  }

  @Test
  void counter_readsSteps() {
    Counter counter = new Counter(340, 0.0001, 1e-5, 0.01);
    assertEquals(0.17 * 5, counter.rangeM(0.0051001), 1e-9);
    assertEquals(0, counter.rangeM(0));
    assertEquals(0.85, counter.steppedM(0.8599), 1e-9);
    assertEquals(0.8599, new Counter(340, 0, 0, 0).steppedM(0.8599));
  }
}
