package simbad.blindworld.motionchange;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static simbad.blindworld.motionchange.MotionGround.BASE_M;
import static simbad.blindworld.motionchange.MotionGround.STEP_S;
import static simbad.blindworld.motionchange.MotionGround.acting;
import static simbad.blindworld.motionchange.MotionGround.effect;
import static simbad.blindworld.motionchange.MotionGround.heard;
import static simbad.blindworld.motionchange.MotionGround.next;
import static simbad.blindworld.motionchange.MotionGround.number;

import java.util.random.RandomGenerator;
import org.junit.jupiter.api.Test;
import simbad.blindworld.motion.Acting;
import simbad.blindworld.motion.Commands;
import simbad.blindworld.motion.Commands.Speeds;
import simbad.blindworld.motion.MotionChange.Stage;
import simbad.blindworld.world.FixedChance;

/** Actuation-latency, actuation-lag, time-offset: when commands act, and how speeds follow. */
class TimeFormsTest {

  private static final double NEAR = 1e-12;
  private static final double[] TIMES = {0, 0.3, 1};

  /** By how much each of three commands is late. */
  private static double[] late(MotionEffect effect, RandomGenerator chance, double... speeds) {
    double[][] told = new double[TIMES.length][2];
    for (int i = 0; i < speeds.length; i++) {
      told[i][0] = speeds[i];
    }
    Commands heard = heard(effect, chance, TIMES, told);
    double[] late = new double[TIMES.length];
    for (int i = 0; i < late.length; i++) {
      late[i] = heard.timeS(i) - TIMES[i];
    }
    return late;
  }

  private static void assertLate(double[] found, double... expected) {
    org.junit.jupiter.api.Assertions.assertArrayEquals(expected, found, NEAR);
  }

  @Test
  void fixedLatency_isTheSameForAll() {
    MotionEffect effect = effect("actuation-latency", "fixed", 2);
    assertEquals(0.3, number(effect, "s"), NEAR);
    assertEquals(Stage.TIME, effect.change().stage());
    assertLate(late(effect, new FixedChance(0.5)), 0.3, 0.3, 0.3);
  }

  /** 0.8 to 1.2 times 0.15 s. */
  @Test
  void unsteadyLatency_isEachItsOwn() {
    MotionEffect effect = effect("actuation-latency", "unsteady", 1);
    assertEquals(0.15, number(effect, "s"), NEAR);
    assertLate(late(effect, new FixedChance(0.25, 0.5, 0)), 0.135, 0.15, 0.12);
  }

  /**
   * Looks every 0.12 s, a quarter of it before the log: the next look after 0.3 s, which are 2.75
   * of them, is 0.03 s later; after 0 it is 0.09 s and after 1 s, 8 7/12, it is 0.05 s.
   */
  @Test
  void sampledLoop_waitsForItsNextLook() {
    MotionEffect effect = effect("actuation-latency", "sampled loop", 1, new FixedChance(0.25));
    assertEquals(0.12, number(effect, "period_s"), NEAR);
    assertEquals(0.09, number(effect, "s"), NEAR);
    assertLate(late(effect, new FixedChance(0.5)), 0.09 + 0.09, 0.09 + 0.03, 0.09 + 0.05);
    MotionEffect none = effect("actuation-latency", "sampled loop", 0);
    assertLate(late(none, new FixedChance(0.5)), 0, 0, 0);
  }

  /** Half as long again at the greatest speed, which is 0.5 m/s. */
  @Test
  void latencyBySpeed_isLongerWhenFast() {
    MotionEffect effect = effect("actuation-latency", "longer when fast", 1);
    assertEquals(0.12, number(effect, "s"), NEAR);
    assertEquals(0.06, number(effect, "s_more_at_most"), NEAR);
    assertLate(late(effect, new FixedChance(0.5), 0, -0.25, 0.5), 0.12, 0.15, 0.18);
  }

  /** 0.2 s times 0.7 and 1.4. */
  @Test
  void timeConstants_areOfEachSpeed() {
    MotionEffect effect =
        effect("actuation-lag", "time constant", 1, new FixedChance(0, 1 - 1e-15));
    assertEquals(0.14, number(effect, "speed_s"), NEAR);
    assertEquals(0.28, number(effect, "turn_s"), NEAR);
    Speeds first = next(acting(effect), 1, 1);
    assertEquals((1 - Math.exp(-STEP_S / 0.14)) / 2, first.vMPerS(), NEAR);
    assertEquals((1 - Math.exp(-STEP_S / 0.28)) / 2, first.wRadPerS(), NEAR);
  }

  /** The common ones, 0.4 m/s and 0.8 rad/s, take half a second: 0.016 m/s in a step. */
  @Test
  void greatestAcceleration_takesHalfASecondForACommonCommand() {
    MotionEffect effect = effect("actuation-lag", "greatest acceleration", 1);
    assertEquals(0.8, number(effect, "m_s2"), NEAR);
    assertEquals(1.6, number(effect, "rad_s2"), NEAR);
    Acting acting = acting(effect);
    assertEquals(0.008, next(acting, 0.4, -0.8).vMPerS(), NEAR);
    assertEquals(-0.048, next(acting, 0.4, -0.8).wRadPerS(), NEAR);
    MotionEffect none = effect("actuation-lag", "greatest acceleration", 0);
    assertEquals(1e6, number(none, "m_s2"));
    assertEquals(1e6, number(none, "rad_s2"));
    assertEquals(new Speeds(9, 9), next(acting(none), 9, 9));
  }

  /** Quick to brake or slow to brake. */
  @Test
  void brakes_haveAConstantOfTheirOwn() {
    MotionEffect quick = effect("actuation-lag", "brakes otherwise", 1);
    assertEquals(0.25, number(quick, "growing_s"), NEAR);
    assertEquals(0.075, number(quick, "braking_s"), NEAR);
    MotionEffect slow =
        effect("actuation-lag", "brakes otherwise", 1, new FixedChance(0.5).coins(false));
    assertEquals(0.55, number(slow, "braking_s"), NEAR);
    Acting acting = acting(quick);
    double v = 1 - Math.exp(-STEP_S / 0.25);
    assertEquals(v / 2, next(acting, 1, -1).vMPerS(), NEAR);
    double left = v * Math.exp(-STEP_S / 0.075);
    Speeds braking = next(acting, 0, 0);
    assertEquals((v + left) / 2, braking.vMPerS(), NEAR);
    assertEquals(-(v + left) / 2, braking.wRadPerS(), NEAR);
  }

  /** The second one, 0.6 times the first, follows what the first one makes. */
  @Test
  void twoTimeConstants_actInTurn() {
    MotionEffect effect = effect("actuation-lag", "two time constants", 1);
    assertEquals(0.15, number(effect, "first_s"), NEAR);
    assertEquals(0.09, number(effect, "second_s"), NEAR);
    Acting acting = acting(effect);
    double first = (1 - Math.exp(-STEP_S / 0.15)) / 2;
    double both = first * (1 - Math.exp(-STEP_S / 0.09)) / 2;
    assertEquals(both, next(acting, 1, -1).vMPerS(), NEAR);
    next(acting, 1, -1);
    acting.beginRun();
    assertEquals(-both, next(acting, 1, -1).wRadPerS(), NEAR, "a run begins at rest");
  }

  /** Every third step, 0.06 s, it takes 1 - exp(-0.06 / 0.2) of what is missing. */
  @Test
  void controller_actsAtItsTicks() {
    MotionEffect effect = effect("actuation-lag", "controller at a rate", 1, new FixedChance(0.4));
    double share = 1 - Math.exp(-0.3);
    assertEquals(0.06, number(effect, "period_s"), NEAR);
    assertEquals(share, number(effect, "share"), NEAR);
    Acting acting = acting(effect);
    for (int step = 0; step < 3; step++) {
      Speeds now = next(acting, step == 0 ? 1 : 7, -2);
      assertEquals(share, now.vMPerS(), NEAR);
      assertEquals(-2 * share, now.wRadPerS(), NEAR);
    }
    Speeds fourth = next(acting, 1, 1);
    assertEquals(share + share * (1 - share), fourth.vMPerS(), NEAR);
    assertEquals(-2 * share + share * (1 + 2 * share), fourth.wRadPerS(), NEAR);
    acting.beginRun();
    assertEquals(new Speeds(share, share), next(acting, 1, 1));
    Acting atOnce = acting(effect("actuation-lag", "controller at a rate", 0));
    assertEquals(new Speeds(1, 2), next(atOnce, 1, 2));
    assertEquals(new Speeds(3, 4), next(atOnce, 3, 4));
  }

  /** A common rim, 0.4 + 0.8 * 0.075 m/s, takes half a second: 0.0184 m/s in a step. */
  @Test
  void wheels_accelerateEachByItself() {
    MotionEffect effect = effect("actuation-lag", "of each wheel", 1);
    assertEquals(0.92, number(effect, "rim_m_s2"), NEAR);
    Acting acting = acting(effect);
    // Rims of 0.025 and 0.175 m/s are wanted.
    Speeds first = next(acting, 0.1, 1);
    assertEquals(0.0184, first.vMPerS(), NEAR);
    assertEquals(0, first.wRadPerS(), NEAR);
    Speeds second = next(acting, 0.1, 1);
    assertEquals((0.025 + 0.0368) / 2, second.vMPerS(), NEAR);
    assertEquals((0.0368 - 0.025) / BASE_M, second.wRadPerS(), NEAR);
    acting.beginRun();
    Speeds again = next(acting, 0, 1);
    assertEquals(0, again.vMPerS(), NEAR);
    assertEquals(2 * 0.0184 / BASE_M, again.wRadPerS(), NEAR);
  }

  /** With one clock a track can only be late. */
  @Test
  void offset_isEitherWayWithTwoClocks() {
    FixedChance down = new FixedChance(0.5).coins(false);
    MotionEffect early = effect("time-offset", "fixed", 1, down);
    assertEquals(-0.18, number(early, "s"), NEAR);
    assertEquals(Stage.TRACK, early.change().stage());
    assertEquals(-0.18, acting(early).agoS(3, 0.5), NEAR);
    MotionSite one =
        new MotionSite(
            MotionGround.robot(true, false),
            MotionGround.outing(new Commands(new double[1], new double[1], new double[1])),
            down,
            1);
    assertEquals(0.18, number(MotionVocabulary.draw("time-offset", one), "s"), NEAR);
  }
}
