package simbad.blindworld.effect;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static simbad.blindworld.effect.EffectGround.BOX;
import static simbad.blindworld.effect.EffectGround.POST;
import static simbad.blindworld.effect.EffectGround.down;
import static simbad.blindworld.effect.EffectGround.draw;
import static simbad.blindworld.effect.EffectGround.hearing;
import static simbad.blindworld.effect.EffectGround.number;
import static simbad.blindworld.effect.EffectGround.sight;

import java.util.List;
import org.junit.jupiter.api.Test;
import simbad.blindworld.world.AnyPing;
import simbad.blindworld.world.Body;
import simbad.blindworld.world.FixedChance;
import simbad.blindworld.world.Hearing;
import simbad.blindworld.world.Ping;
import simbad.blindworld.world.Pose;

/** What no name of the vocabulary covers. The recording is 4 s long. */
class OutsideFormsTest {

  private static final double NONE = Double.POSITIVE_INFINITY;
  private static final double NEAR = 1e-9;
  private static final double HEARD = 1e-6;
  private static final FixedChance MIDDLE = new FixedChance(0.5);

  private static double threshold(Effect effect, Ping ping) {
    return hearing(effect).thresholdM(3, sight(0, 1, 0), ping);
  }

  private static double range(Effect effect, double rangeM, Ping ping) {
    return hearing(effect).rangeM(rangeM, ping);
  }

  private static Ping at(double tS) {
    return AnyPing.at(MIDDLE, tS, 0);
  }

  private static Ping looking(double headingRad) {
    return AnyPing.from(MIDDLE, new Pose(0, 0, headingRad));
  }

  /** With a period of 0.725 of the log, begun at half of a wave. */
  @Test
  void gain_swingsOrFades() {
    Effect swing = draw("gain-swing", "sine", 1);
    assertEquals(2.9, number(swing, "period_s"), NEAR);
    assertEquals(3, threshold(swing, at(0)), NEAR);
    assertEquals(3 * 0.65, threshold(swing, at(2.9 / 4)), NEAR);
    assertEquals(3 * 1.35, threshold(swing, at(3 * 2.9 / 4)), NEAR);
    assertEquals(0.8, number(draw("gain-swing", "sine", 9), "swing"), NEAR);
    Effect fading = draw("gain-swing", "fading", 1);
    assertEquals(3 * (1 - 0.225), threshold(fading, at(2)), NEAR);
    assertEquals(3 * 0.55, threshold(fading, at(9)), NEAR);
    assertEquals(0.9, number(draw("gain-swing", "fading", 9), "loss"), NEAR);
  }

  @Test
  void rangesDriftOverTheLog() {
    Effect ramp = draw("temperature-ramp", "linear", 1, down());
    assertEquals(2 * 0.95, range(ramp, 2, at(2)), NEAR);
    assertEquals(2 * 0.88, range(ramp, 2, at(99)), NEAR);
    Effect warm = draw("warm-up", "exponential", 1);
    assertEquals(1.1, number(warm, "time_s"), NEAR);
    assertEquals(2.2, range(warm, 2, at(0)), NEAR);
    assertEquals(2 + 0.2 / Math.E, range(warm, 2, at(1.1)), NEAR);
  }

  private static final List<Body> BODIES = List.of(Body.of(POST), Body.of(BOX));

  /** After 0.475 of the log; by chance of a half it is the second one, that goes to the left. */
  @Test
  void obstacle_leavesOrMoves() {
    List<Body> left = draw("obstacle-leaves", "half time", 1).change().bodies(BODIES);
    assertTrue(left.get(1).isThereAt(1.89) && !left.get(1).isThereAt(1.91));
    assertTrue(left.get(0).isThereAt(9));
    assertTrue(draw("obstacle-leaves", "half time", 0).change().bodies(BODIES).get(1).isThereAt(9));
    Effect moves = draw("obstacle-moves", "half time", 2);
    assertEquals(1.9, number(moves, "at_s"), NEAR);
    List<Body> moved = moves.change().bodies(BODIES);
    assertEquals(3, moved.size());
    assertTrue(moved.get(1).isThereAt(1.89) && !moved.get(1).isThereAt(1.91));
    assertTrue(!moved.get(2).isThereAt(1.89) && moved.get(2).isThereAt(1.91));
    assertEquals(-0.6, moved.get(2).place().xM(), NEAR);
    assertEquals(50, moved.get(2).place().zM(), NEAR);
    assertEquals(BODIES, draw("obstacle-moves", "half time", 0).change().bodies(BODIES));
  }

  @Test
  void motion_losesEchoes() {
    Effect speed = draw("speed-loss", "linear", 1);
    assertEquals(3 * 0.64, threshold(speed, AnyPing.moving(0.3, 0)), NEAR);
    assertEquals(0.3, threshold(speed, AnyPing.moving(9, 0)), NEAR);
    Effect turning = draw("turning-loss", "linear", 1);
    assertEquals(2, threshold(turning, AnyPing.moving(0, -0.5 / 0.6)), NEAR);
  }

  /** A sector of 0.575 rad round half a turn. */
  @Test
  void thresholds_dependOnTheSide() {
    Effect sector = draw("sector-thresholds", "one sector", 1);
    Hearing hearing = hearing(sector);
    double times = Math.exp(0.5);
    assertEquals(3 * times, hearing.thresholdM(3, sight(Math.PI - 0.57, 1, 0), at(0)), NEAR);
    assertEquals(3 * times, hearing.thresholdM(3, sight(-Math.PI + 0.57, 1, 0), at(0)), NEAR);
    assertEquals(3, hearing.thresholdM(3, sight(Math.PI - 0.58, 1, 0), at(0)), NEAR);
    Effect noise = draw("noise-side", "one side", 1, new FixedChance(0.25));
    assertEquals(1.5, threshold(noise, looking(Math.PI / 2)), NEAR);
    assertEquals(3 * 0.75, threshold(noise, looking(Math.PI / 4)), NEAR);
    assertEquals(3, threshold(noise, looking(-Math.PI / 2)), NEAR);
    assertEquals(0.9, number(draw("noise-side", "one side", 9), "loss"), NEAR);
    Effect wind = draw("wind-shear", "cosine", 1, new FixedChance(0.25));
    assertEquals(2.14, range(wind, 2, looking(Math.PI / 2)), NEAR);
    assertEquals(1.86, range(wind, 2, looking(-Math.PI / 2)), NEAR);
    assertEquals(2, range(wind, 2, looking(0)), NEAR);
  }

  @Test
  void thresholdsAndPoses_scatter() {
    Effect blur = draw("edge-blur", "wide", 1);
    assertEquals(4.5, threshold(blur, AnyPing.at(new FixedChance(0).gaussian(2), 0, 0)), NEAR);
    assertEquals(0, threshold(blur, AnyPing.at(new FixedChance(0).gaussian(-9), 0, 0)), NEAR);
    Effect jitter = draw("pose-jitter", "gaussian", 1);
    assertTrue(jitter.change().restless());
    List<Pose> poses =
        jitter
            .change()
            .poses(
                EffectGround.ROWS,
                EffectGround.ROWS.rows().stream().map(r -> r.pose()).toList(),
                new FixedChance(0.5).gaussian(1, -2, 3));
    assertEquals(-1.02 + 0.04, poses.get(0).xM(), NEAR);
    assertEquals(-0.08, poses.get(0).zM(), NEAR);
    assertEquals(Math.toRadians(15), poses.get(0).headingRad(), NEAR);
  }

  private static Hearing hearing2(Effect effect) {
    return effect.change().hearing(EffectGround.ROWS, EffectGround.ROWS.tracks().get(1), 7);
  }

  @Test
  void oneTransducer_isOtherThanTheRest() {
    Effect gain = draw("one-gain", "factor", 1);
    assertEquals("t", gain.parameters().get("sensor"));
    assertEquals(3, threshold(gain, at(0)));
    assertEquals(3 * Math.exp(0.4), hearing2(gain).thresholdM(3, sight(0, 1, 0), at(0)), NEAR);
    Effect offset = draw("one-offset", "constant", 1, new FixedChance(0.1).coins(false));
    assertEquals(0.88, range(offset, 1, at(0)), NEAR);
    assertEquals(1, hearing2(offset).rangeM(1, at(0)));
  }

  private static double[] crossed(Effect effect) {
    List<Pose> believed = EffectGround.ROWS.rows().stream().map(r -> r.pose()).toList();
    return effect.change().poses(EffectGround.ROWS, believed, MIDDLE).stream()
        .mapToDouble(p -> Math.rint(-100 * p.xM()))
        .toArray();
  }

  /** The pings of one transducer are at 1.02 to 1.42 m, of the other at 1.52 to 1.92 m. */
  @Test
  void wires_areCrossed() {
    Effect effect = draw("crossed-wires", "two", 1);
    assertEquals("s", effect.parameters().get("first"));
    assertEquals("t", effect.parameters().get("second"));
    assertArrayEquals(
        new double[] {152, 162, 172, 182, 192, 102, 112, 122, 132, 142}, crossed(effect));
    double[] straight = {102, 112, 122, 132, 142, 152, 162, 172, 182, 192};
    assertArrayEquals(straight, crossed(draw("crossed-wires", "two", 0)));
    assertArrayEquals(straight, crossed(draw("swapped-readings", "now and then", 0)));
    // Two pings running of every four, with chance of a fifth.
    assertArrayEquals(
        new double[] {152, 162, 122, 132, 192, 102, 112, 172, 182, 142},
        crossed(draw("swapped-readings", "now and then", 1, new FixedChance(0.2))));
  }

  @Test
  void ranges_areBent() {
    assertEquals(2.2, range(draw("quadratic-range", "square", 1), 2, at(0)), NEAR);
    // The knee lies at the quantile 0.425, 1.4 m.
    Effect knee = draw("range-knee", "compressed", 1);
    assertEquals(1.4, number(knee, "m"), HEARD);
    assertEquals(1.3, range(knee, 1.3, at(0)), NEAR);
    assertEquals(1.4 + 0.65 * 0.6, range(knee, 2, at(0)), HEARD);
    assertEquals(0.2, number(draw("range-knee", "compressed", 9), "slope"), NEAR);
    Effect bump = draw("range-bump", "bell", 1, down());
    assertEquals(1.5, number(bump, "m"), HEARD);
    assertEquals(0.175, number(bump, "width_m"), NEAR);
    assertEquals(1.5 - 0.15, range(bump, 1.5, at(0)), HEARD);
    assertEquals(1.675 - 0.15 * Math.exp(-0.5), range(bump, 1.675, at(0)), 1e-5);
    Effect wave = draw("range-wave", "sine", 1);
    assertEquals(0.525, number(wave, "length_m"), NEAR);
    assertEquals(1.18125 + 0.06, range(wave, 2.25 * 0.525, at(0)), NEAR);
    assertEquals(0, range(draw("range-wave", "sine", 9), 0.75 * 0.525, at(0)), "never negative");
  }

  /** From the quantile 0.35, 1.3 m, to 0.65, 1.6 m, nothing is heard. */
  @Test
  void band_isLost() {
    Hearing hearing = hearing(draw("range-band-loss", "band", 1));
    assertEquals(1.29, hearing.echoM(1.29, at(0)));
    assertEquals(NONE, hearing.echoM(1.31, at(0)));
    assertEquals(NONE, hearing.echoM(1.59, at(0)));
    assertEquals(1.61, hearing.echoM(1.61, at(0)));
    assertEquals(1.31, hearing(draw("range-band-loss", "band", 0)).echoM(1.31, at(0)));
  }

  /** What is shown stays until it would change by 15 cm. */
  @Test
  void reading_sticks() {
    Hearing hearing = hearing(draw("sticky-reading", "deadband", 1));
    double[] read = {NONE, 1, 1.14, 0.86, 1.16, 1.02, NONE, 1.1};
    double[] shown = {NONE, 1, 1, 1, 1.16, 1.16, NONE, 1.1};
    for (int i = 0; i < read.length; i++) {
      assertEquals(shown[i], hearing.reportedM(read[i], at(0)), "reading " + i);
    }
  }

  @Test
  void secondEcho_isTakenByChance() {
    Hearing hearing = hearing(draw("second-echo", "two arrivals", 1));
    assertEquals(2, hearing.echoM(1, AnyPing.hearing(new FixedChance(0.69), 1, 2)));
    assertEquals(1, hearing.echoM(1, AnyPing.hearing(new FixedChance(0.71), 1, 2)));
    assertEquals(1, hearing.echoM(1, at(0)), "there is no second one");
    assertFalse(number(draw("second-echo", "two arrivals", 9), "p") > 1);
  }
}
