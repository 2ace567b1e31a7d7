package simbad.blindworld.effect;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static simbad.blindworld.effect.EffectGround.down;
import static simbad.blindworld.effect.EffectGround.draw;
import static simbad.blindworld.effect.EffectGround.hearing;
import static simbad.blindworld.effect.EffectGround.number;

import org.junit.jupiter.api.Test;
import simbad.blindworld.world.AnyPing;
import simbad.blindworld.world.FixedChance;
import simbad.blindworld.world.Hearing;
import simbad.blindworld.world.Ping;

/** Steps, clamps and held readings; speed of sound, offset and noise. */
class OutputAndRangeFormsTest {

  private static final double NONE = Double.POSITIVE_INFINITY;
  private static final double NEAR = 1e-9;

  /** What is heard is known to the corners of a post. */
  private static final double HEARD = 1e-6;

  private static double stepped(String form, double strength, double rangeM) {
    return hearing(draw("coarse-resolution", form, strength)).steppedM(9, rangeM, AnyPing.FIRST);
  }

  /** 4.5 cm times the size, in whole steps of a centimetre, and at least two of them. */
  @Test
  void coarseStep_isAMultipleOfTheFineOne() {
    assertEquals(0.09, number(draw("coarse-resolution", "start", 2), "m"), NEAR);
    assertEquals(0.02, number(draw("coarse-resolution", "start", 0.1), "m"), NEAR);
    assertEquals(0.01, number(draw("coarse-resolution", "start", 0), "m"), NEAR);
  }

  /** 1 m are 11.1 steps of 9 cm, 1.04 m are 11.56. */
  @Test
  void coarseSteps_areRoundedInTheirWay() {
    assertEquals(0.99, stepped("start", 2, 1), NEAR);
    assertEquals(0.99, stepped("start", 2, 1.04), NEAR);
    assertEquals(0.99 + 0.045, stepped("centre", 2, 1), NEAR);
    assertEquals(0.99, stepped("nearest", 2, 1), NEAR);
    assertEquals(1.08, stepped("nearest", 2, 1.04), NEAR);
    assertEquals(1.03, stepped("centre", 0, 1.0349), NEAR);
    assertEquals(1.03, stepped("nearest", 0, 1.0388), NEAR);
  }

  /** 1.25 times 9 cm: 9 such steps are 1.0125 m, which are printed in centimetres. */
  @Test
  void oddStep_isCutToTheFineOne() {
    assertEquals(0.1125, number(draw("coarse-resolution", "odd step", 2), "m"), NEAR);
    assertEquals(1.01, stepped("odd step", 2, 1.05), NEAR);
    assertEquals(0.9, stepped("odd step", 2, 1), NEAR);
    assertEquals(1.03, stepped("odd step", 0, 1.0388), NEAR);
  }

  /** A quarter of what is heard, 7 in 10 at most, are clamped: 1.2 m, 1.7 m. */
  @Test
  void clamp_isAQuantileOfWhatIsHeard() {
    Effect effect = draw("near-clamp", "after steps", 1);
    assertEquals(1.2, number(effect, "m"), HEARD);
    Hearing hearing = hearing(effect);
    assertEquals(1.2, hearing.reportedM(0.7, AnyPing.FIRST), HEARD);
    assertEquals(1.3, hearing.reportedM(1.3, AnyPing.FIRST));
    assertEquals(NONE, hearing.reportedM(NONE, AnyPing.FIRST));
    assertEquals(1.7, number(draw("near-clamp", "before steps", 9), "m"), HEARD);
    assertEquals(0, number(draw("near-clamp", "before steps", 0), "m"));
    Hearing before = hearing(draw("near-clamp", "before steps", 1));
    assertEquals(1.2, before.steppedM(9, 0.7, AnyPing.FIRST), 0.0101);
    assertEquals(1.33, before.steppedM(9, 1.337, AnyPing.FIRST), NEAR);
  }

  private static double[] reports(Effect effect, FixedChance chance, double... readings) {
    Hearing hearing = hearing(effect);
    double[] reported = new double[readings.length];
    for (int i = 0; i < reported.length; i++) {
      reported[i] = hearing.reportedM(readings[i], AnyPing.at(chance, i, i));
    }
    return reported;
  }

  @Test
  void staleReading_isHeldSoOften() {
    Effect effect = draw("stale-reading", "count", 0.5);
    assertEquals(2, number(effect, "n"));
    assertArrayEquals(
        new double[] {NONE, 1, 1, 1, NONE, NONE, 2, 2, 3, 3, 3, NONE},
        reports(
            effect,
            new FixedChance(0.5),
            NONE,
            1,
            NONE,
            NONE,
            NONE,
            NONE,
            2,
            NONE,
            3,
            NONE,
            NONE,
            NONE));
  }

  /** For 2.2 s, at a ping a second. */
  @Test
  void staleReading_isHeldSoLong() {
    Effect effect = draw("stale-reading", "duration", 0.5);
    assertEquals(2.2, number(effect, "s"), NEAR);
    assertArrayEquals(
        new double[] {NONE, 1, 1, 1, NONE, NONE},
        reports(effect, new FixedChance(0.5), NONE, 1, NONE, NONE, NONE, NONE));
  }

  /** Held with a chance of 7 in 8 each time, and let go for good. */
  @Test
  void staleReading_fades() {
    Effect effect = draw("stale-reading", "fading", 2);
    assertEquals(0.875, number(effect, "chance"), NEAR);
    assertArrayEquals(
        new double[] {1, 1, NONE, NONE, 2, 2},
        reports(effect, new FixedChance(0.87, 0.88, 0.1, 0.87), 1, NONE, NONE, NONE, 2, NONE));
    assertEquals(0, number(draw("stale-reading", "fading", 0), "chance"));
  }

  private static double range(Effect effect, double rangeM, FixedChance chance) {
    return hearing(effect).rangeM(rangeM, AnyPing.at(chance, 0, 0));
  }

  private static double range(Effect effect, double rangeM) {
    return range(effect, rangeM, new FixedChance(0.5));
  }

  @Test
  void fasterSound_shortensRanges() {
    Effect faster = draw("sound-speed", "speed", 2);
    assertEquals(343 * 1.06, number(faster, "c"), NEAR);
    assertEquals(1 / 1.06, range(faster, 1), NEAR);
    Effect slower = draw("sound-speed", "speed", 1, down());
    assertEquals(2 / 0.97, range(slower, 2), NEAR);
  }

  /** 331.3 m/s are at 0 degrees, and the square of the speed goes with the temperature. */
  @Test
  void warmerAir_shortensRanges() {
    Effect effect = draw("sound-speed", "temperature", 1);
    double believed = 273.15 * 343 * 343 / (331.3 * 331.3);
    double speed = 343 * Math.sqrt((believed + 19) / believed);
    assertEquals(believed + 19 - 273.15, number(effect, "temperature_c"), NEAR);
    assertEquals(speed, number(effect, "c"), NEAR);
    assertEquals(343 / speed, range(effect, 1), NEAR);
  }

  /** A time-out of 4 m is one of 4 / 1.03 = 3.88 m where ranges are 1.03 times as long. */
  @Test
  void timeoutInTime_goesWithTheSpeed() {
    Effect effect = draw("sound-speed", "time-out in time", 1);
    assertEquals(343 / 1.03, number(effect, "c"), NEAR);
    assertEquals(1.03, range(effect, 1), NEAR);
    assertEquals(3.88, hearing(effect).echoM(3.88, AnyPing.FIRST));
    assertEquals(NONE, hearing(effect).echoM(3.89, AnyPing.FIRST));
  }

  @Test
  void offset_isAddedWithItsJitter() {
    assertEquals(1.08, range(draw("range-offset", "constant", 2), 1), NEAR);
    assertEquals(0.96, range(draw("range-offset", "constant", 1, down()), 1), NEAR);
    Effect trigger = draw("range-offset", "trigger", 1, down());
    assertEquals(-0.045, number(trigger, "m"), NEAR);
    assertEquals(0.0054, number(trigger, "jitter_m"), NEAR);
    assertEquals(1 - 0.045 + 0.0027, range(trigger, 1, new FixedChance(0.75)), NEAR);
    assertEquals(1 - 0.045 - 0.0054, range(trigger, 1, new FixedChance(0)), NEAR);
  }

  @Test
  void noise_scattersInItsWay() {
    FixedChance two = new FixedChance(0.75).gaussian(2);
    assertEquals(1.5 + 0.07, range(draw("range-noise", "gaussian", 1), 1.5, two), NEAR);
    assertEquals(1.5 + 0.03 * 3, range(draw("range-noise", "growing", 1), 1.5, two), NEAR);
    assertEquals(1.5 + 0.03, range(draw("range-noise", "even", 1), 1.5, two), NEAR);
    // Three Gaussians of 2, 1 and 2 have a mean square of 3.
    FixedChance student = new FixedChance(0.5).gaussian(2, 1, 2, -1.5);
    assertEquals(
        1.5 - 0.022 * 1.5 / Math.sqrt(3),
        range(draw("range-noise", "tails", 1), 1.5, student),
        NEAR);
  }

  /** A state is on as often as it begins over as it begins and ends; then it goes on by itself. */
  @Test
  void chain_beginsAndEndsByChance() {
    Chain chain = new Chain(0.1, 0.3);
    FixedChance chance = new FixedChance(0.24, 0.31, 0.29, 0.11, 0.09);
    Ping ping = AnyPing.at(chance, 0, 0);
    boolean[] expected = {true, true, false, false, true};
    for (boolean on : expected) {
      assertEquals(on, chain.next(ping));
    }
    assertEquals(false, new Chain(0.1, 0.3).next(AnyPing.at(new FixedChance(0.26), 0, 0)));
    assertEquals(false, new Chain(0, 0).next(AnyPing.at(new FixedChance(0), 0, 0)));
  }
}
