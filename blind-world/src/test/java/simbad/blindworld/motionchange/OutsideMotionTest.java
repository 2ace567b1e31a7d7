package simbad.blindworld.motionchange;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static simbad.blindworld.motionchange.MotionGround.BASE_M;
import static simbad.blindworld.motionchange.MotionGround.STEP_S;
import static simbad.blindworld.motionchange.MotionGround.acting;
import static simbad.blindworld.motionchange.MotionGround.effect;
import static simbad.blindworld.motionchange.MotionGround.heard;
import static simbad.blindworld.motionchange.MotionGround.moved;
import static simbad.blindworld.motionchange.MotionGround.next;
import static simbad.blindworld.motionchange.MotionGround.number;

import org.junit.jupiter.api.Test;
import simbad.blindworld.motion.Acting;
import simbad.blindworld.motion.AnyStep;
import simbad.blindworld.motion.Commands;
import simbad.blindworld.motion.Commands.Speeds;
import simbad.blindworld.motion.MotionChange.Stage;
import simbad.blindworld.motion.Sight;
import simbad.blindworld.motion.Step;
import simbad.blindworld.world.FixedChance;

/** What the vocabulary has no name for. A direction by chance of 0.5 is x, of 0.75 it is z. */
class OutsideMotionTest {

  private static final double NEAR = 1e-12;

  private static FixedChance alongZ() {
    return new FixedChance(0.75);
  }

  private static FixedChance down(double share) {
    return new FixedChance(share).coins(false);
  }

  private static void assertMoves(MotionEffect effect, Step step, double v, double w) {
    Step moved = moved(effect, step);
    assertEquals(v, moved.v(), NEAR, "speed");
    assertEquals(w, moved.w(), NEAR, "turn rate");
  }

  @Test
  void slope_pullsDownhillByTheWay() {
    MotionEffect effect = effect("slope", "plane", 1, alongZ());
    assertEquals(0.12, number(effect, "share"), NEAR);
    assertEquals(0, number(effect, "down_x"), NEAR);
    assertEquals(1, number(effect, "down_z"), NEAR);
    double[] forth = AnyStep.drift(moved(effect, AnyStep.told(0.5, 0)));
    double[] back = AnyStep.drift(moved(effect, AnyStep.told(-0.5, 0)));
    assertArrayEquals(new double[] {0, 0.06}, forth, NEAR);
    assertArrayEquals(new double[] {0, 0.06}, back, NEAR);
    double[] along = AnyStep.drift(moved(effect("slope", "plane", 1), AnyStep.told(0.5, 0)));
    assertArrayEquals(new double[] {0.06, 0}, along, NEAR);
  }

  /** A post at (0, 1) m, one metre down the page, pulls by 0.125 in a metre. */
  @Test
  void cable_pullsTowardsItsPost() {
    FixedChance post = new FixedChance(0.5, 1 - 1e-15);
    MotionEffect effect = effect("dragging-cable", "from a post", 1, post);
    assertEquals(0.125, number(effect, "per_m"), NEAR);
    assertEquals(0, number(effect, "post_x"), NEAR);
    assertEquals(1, number(effect, "post_z"), NEAR);
    double towards = -Math.PI / 2;
    Step driven = moved(effect, AnyStep.at(0, 0, towards, 0.4));
    assertEquals(0.4 * 1.125, driven.v(), 1e-8);
    assertEquals(0, driven.w(), 1e-8);
    Step away = moved(effect, AnyStep.at(0, -1, -towards, 0.4));
    assertEquals(0.4 * 0.75, away.v(), 1e-8);
    // With the post to its right it is turned to the right, with the post to its left to the left.
    Step right = moved(effect, AnyStep.at(0, 0, 0, 0.4));
    assertEquals(-0.125 * 0.4 / BASE_M / 4, right.w(), 1e-8);
    assertEquals(0.4, right.v(), 1e-8);
    Step left = moved(effect, AnyStep.at(0, 3, 0, -0.4));
    assertEquals(0.25 * 0.4 / BASE_M / 4, left.w(), 1e-8);
    Step far = moved(effect, AnyStep.at(0, 99, 0, 0.4));
    assertEquals(0.5 * 0.4 / BASE_M / 4, far.w(), 1e-8, "no more than a half");
    Step beside = moved(effect, AnyStep.at(2, 1, 0, 0.4));
    assertEquals(0.4 * 0.75, beside.v(), 1e-8, "the post lies behind");
  }

  /** 0.12 of the middle speed; gusts hang together over 4 to 15 s. */
  @Test
  void wind_blowsWhileItDrives() {
    MotionEffect effect = effect("wind", "gusts", 1, alongZ());
    assertEquals(0.036, number(effect, "m_s"), NEAR);
    assertEquals(12.25, number(effect, "gust_s"), NEAR);
    double k = Math.exp(-STEP_S / 12.25);
    double gust = k + Math.sqrt(1 - k * k);
    Step driven = AnyStep.told(0.4, 0);
    acting(effect, new FixedChance(0.5).gaussian(1)).move(driven);
    assertArrayEquals(new double[] {0, 0.036 * (1 + gust)}, AnyStep.drift(driven), NEAR);
    Step still = AnyStep.told(0, 1);
    acting(effect, new FixedChance(0.5).gaussian(1)).move(still);
    assertArrayEquals(new double[2], AnyStep.drift(still), NEAR);
  }

  /** From 1.1 to 0.9 over the log, by a power of 1.35. */
  @Test
  void battery_sagsOverTheLog() {
    MotionEffect effect = effect("battery-sag", "over the log", 1);
    assertEquals(1.35, number(effect, "power"), NEAR);
    assertMoves(effect, AnyStep.told(0.4, 1, 0), 0.44, 1.1);
    assertMoves(effect, AnyStep.told(0.4, 1, 1), 0.36, 0.9);
    double half = 1.1 - 0.2 * Math.pow(0.5, 1.35);
    assertMoves(effect, AnyStep.told(0.4, 1, 0.5), 0.4 * half, half);
  }

  /** As much to one side at the begin as to the other at the end. */
  @Test
  void wear_changesSidesOverTheLog() {
    MotionEffect effect = effect("wheel-wear", "of one wheel", 1);
    assertEquals(0.2, number(effect, "rad_m"), NEAR);
    assertMoves(effect, AnyStep.told(0.5, 1, 0), 0.5, 1.1);
    assertMoves(effect, AnyStep.told(0.5, 1, 0.5), 0.5, 1);
    assertMoves(effect, AnyStep.told(0.5, 1, 1), 0.5, 0.9);
    assertEquals(-0.2, number(effect("wheel-wear", "of one wheel", 1, down(0.5)), "rad_m"), NEAR);
  }

  /** 0.15 rad over 0.4 s, which are 20 steps, each time that it turns back, to the way it goes. */
  @Test
  void casters_kickWhereItTurnsBack() {
    MotionEffect effect = effect("caster-kick", "at reversals", 1);
    assertEquals(0.15, number(effect, "rad"), NEAR);
    assertEquals(Stage.TURNING, effect.change().stage());
    Acting acting = acting(effect);
    assertEquals(0, next(acting, 0.3, 0).wRadPerS());
    assertEquals(0, next(acting, 0, 0).wRadPerS());
    assertEquals(-0.375, next(acting, -0.3, 0).wRadPerS(), NEAR, "after a rest, too");
    double turned = -0.375 * STEP_S;
    for (int i = 0; i < 40; i++) {
      turned += next(acting, -0.3, 0).wRadPerS() * STEP_S;
    }
    assertEquals(-0.15, turned, 0.375 * STEP_S + NEAR);
    assertEquals(0.375, next(acting, 0.1, 0).wRadPerS(), NEAR);
    acting.beginRun();
    assertEquals(0, next(acting, -0.3, 0).wRadPerS(), "a run begins at rest");
    Acting kept = acting(effect);
    next(kept, 0.3, 0);
    next(kept, -0.3, 0);
    kept.beginRun();
    assertEquals(0, next(kept, -0.3, 0).wRadPerS());
  }

  /** The greatest turn rate is 1 rad/s: quicker when straight, slower when turning. */
  @Test
  void slowInTurns_isByTheTurnRate() {
    MotionEffect effect = effect("slow-in-turns", "by turn rate", 1);
    assertEquals(0.25, number(effect, "share"), NEAR);
    assertMoves(effect, AnyStep.told(0.4, 0), 0.4 * 1.1, 0);
    assertMoves(effect, AnyStep.told(0.4, -0.4), 0.4, -0.4);
    assertMoves(effect, AnyStep.told(0.4, 1), 0.4 * 0.85, 1);
    assertMoves(effect, AnyStep.told(0.4, 5), 0.4 * 0.85, 5);
    assertEquals(0.8, number(effect("slow-in-turns", "by turn rate", 9), "share"), NEAR);
  }

  /** The greatest speed is 0.5 m/s: turns more when slow and less when fast. */
  @Test
  void understeer_isByTheSpeed() {
    MotionEffect effect = effect("understeer", "by speed", 1);
    assertEquals(0.25, number(effect, "share"), NEAR);
    assertMoves(effect, AnyStep.told(0, 1), 0, 1.125);
    assertMoves(effect, AnyStep.told(-0.25, 1), -0.25, 1);
    assertMoves(effect, AnyStep.told(0.5, 1), 0.5, 0.875);
    assertMoves(effect, AnyStep.told(2, 1), 2, 0.875);
    assertEquals(0.8, number(effect("understeer", "by speed", 9), "share"), NEAR);
  }

  @Test
  void unequalWays_areByTheSign() {
    MotionEffect turns = effect("turns-unequal", "left and right", 1);
    assertEquals(0.1, number(turns, "share"), NEAR);
    assertMoves(turns, AnyStep.told(0.4, 0.5), 0.4, 0.55);
    assertMoves(turns, AnyStep.told(0.4, -0.5), 0.4, -0.45);
    MotionEffect ways = effect("reverse-unequal", "forth and back", 1, down(0.5));
    assertEquals(-0.1, number(ways, "share"), NEAR);
    assertMoves(ways, AnyStep.told(0.4, 0.5), 0.36, 0.5);
    assertMoves(ways, AnyStep.told(-0.4, 0.5), -0.44, 0.5);
  }

  /** Quick on one side of a line through the origin, slow on the other. */
  @Test
  void carpet_isOnOneSide() {
    MotionEffect across = effect("carpet", "half of the room", 1);
    MotionEffect down = effect("carpet", "half of the room", 1, alongZ());
    assertEquals(0.09, number(across, "share"), NEAR);
    assertEquals(0.4 * 1.09, moved(across, AnyStep.at(1, -5, 0, 0.4)).v(), NEAR);
    assertEquals(0.4 * 0.91, moved(across, AnyStep.at(-1, 5, 0, 0.4)).v(), NEAR);
    assertEquals(0.4 * 1.09, moved(down, AnyStep.at(-5, 1, 0, 0.4)).v(), NEAR);
    assertEquals(0.4 * 0.91, moved(down, AnyStep.at(5, -1, 0, 0.4)).v(), NEAR);
    Step turning = AnyStep.told(0, 1);
    assertEquals(0.91, moved(across, turning).w(), NEAR, "the line itself is slow");
  }

  /** Every 14 s, for 7 s, commands are 0.3 s late. */
  @Test
  void link_clogsNowAndThen() {
    MotionEffect effect = effect("link-clogs", "over the log", 1);
    assertEquals(14, number(effect, "every_s"), NEAR);
    assertEquals(0.3, number(effect, "s"), NEAR);
    assertEquals(Stage.TIME, effect.change().stage());
    double[] times = {0, 6.9, 7.1, 13.9, 14.1, 21.1};
    double[] late = {0.3, 0.3, 0.1, 0, 0.3, 0};
    Commands heard = heard(effect, new FixedChance(0.5), times, new double[6][2]);
    for (int i = 0; i < times.length; i++) {
      // The third one must not overtake the second.
      assertEquals(times[i] + late[i], heard.timeS(i), NEAR, "command " + i);
    }
  }

  /** A mast of 1.1 Hz and 0.12 m in 1 m/s^2. */
  @Test
  void mast_leansBackByTheAcceleration() {
    MotionEffect effect = effect("marker-sway", "a mast", 1);
    assertEquals(1.1, number(effect, "hz"), NEAR);
    assertEquals(0.12, number(effect, "m_per_m_s2"), NEAR);
    double rate = 2 * Math.PI * 1.1;
    Acting acting = acting(effect);
    // A jolt of 0.5 m/s, and what a damping of 0.1 takes off in the step.
    double jolt = -0.12 * rate * rate * 0.5 * (1 - 0.2 * rate * STEP_S);
    Speeds first = next(acting, 0.5, 0.7);
    assertEquals(0.5 + jolt, first.vMPerS(), NEAR);
    assertEquals(0.7, first.wRadPerS());
    // Then it swings back by how far it leans.
    double leans = jolt * STEP_S;
    double then = jolt - (rate * rate * leans + 0.2 * rate * jolt) * STEP_S;
    assertEquals(0.5 + then, next(acting, 0.5, 0.7).vMPerS(), NEAR);
    acting.beginRun();
    assertEquals(0.5 + jolt, next(acting, 0.5, 0).vMPerS(), NEAR, "a run begins upright");
  }

  /** Under a steady 0.2 m/s^2 it rests leaning by 0.12 * 0.2 m, less the damping of one step. */
  @Test
  void mast_leansAsFarAsTheAccelerationSays() {
    Acting acting = acting(effect("marker-sway", "a mast", 1));
    double leans = 0;
    for (int i = 1; i <= 1500; i++) {
      double told = 0.2 * STEP_S * i;
      leans += (next(acting, told, 0).vMPerS() - told) * STEP_S;
    }
    double damped = 1 - 0.2 * 2 * Math.PI * 1.1 * STEP_S;
    assertEquals(-0.12 * 0.2 * damped, leans, 1e-6);
  }

  @Test
  void skew_stretchesOneAxis() {
    MotionEffect effect = effect("camera-skew", "unequal axes", 1);
    assertEquals(0.07, number(effect, "share"), NEAR);
    Sight sight = AnyStep.seen(2, 3, 0.5);
    acting(effect).see(sight);
    assertEquals(2.14, sight.xM(), NEAR);
    assertEquals(2.79, sight.zM(), NEAR);
    assertEquals(0.5, sight.headingRad());
  }

  /** Right at the middle of the log, and half of it off at the ends. */
  @Test
  void clockRate_isEarlyAndThenLate() {
    MotionEffect effect = effect("clock-rate", "stretched", 1);
    assertEquals(0.4, number(effect, "s"), NEAR);
    assertEquals(Stage.TRACK, effect.change().stage());
    assertEquals(-0.2, acting(effect).agoS(0, 0), NEAR);
    assertEquals(0, acting(effect).agoS(50, 0.5), NEAR);
    assertEquals(0.2, acting(effect).agoS(99, 1), NEAR);
  }

  /** A spring of 1.15 Hz: in the first step (2 pi f dt)^2 of what is told. */
  @Test
  void ringing_beginsLikeASpring() {
    MotionEffect effect = effect("ringing", "underdamped", 1);
    assertEquals(1.15, number(effect, "hz"), NEAR);
    assertEquals(0.22, number(effect, "damping"), NEAR);
    assertEquals(0.11, number(effect("ringing", "underdamped", 2), "damping"), NEAR);
    assertEquals(0.22 / 0.3, number(effect("ringing", "underdamped", 0), "damping"), NEAR);
    double rate = 2 * Math.PI * 1.15;
    double square = rate * rate * STEP_S * STEP_S;
    Acting acting = acting(effect);
    Speeds first = next(acting, 0.5, -2);
    assertEquals(0.5 * square, first.vMPerS(), NEAR);
    assertEquals(-2 * square, first.wRadPerS(), NEAR);
    // Speed and change go on: 0.5 (1 - q) missing, less the damping of the change.
    double second = 0.5 * square * (1 + 1 + (1 - square) - 2 * 0.22 * rate * STEP_S);
    assertEquals(second, next(acting, 0.5, -2).vMPerS(), NEAR);
    acting.beginRun();
    assertEquals(0.5 * square, next(acting, 0.5, 1).vMPerS(), NEAR);
  }

  /** An underdamped spring overshoots by exp(-pi z / sqrt(1 - z^2)) and settles at what is told. */
  @Test
  void ringing_overshootsAndSettles() {
    Acting acting = acting(effect("ringing", "underdamped", 1));
    double most = 0;
    double last = 0;
    for (int i = 0; i < 1000; i++) {
      last = next(acting, 1, 0).vMPerS();
      most = Math.max(most, last);
    }
    double over = Math.exp(-Math.PI * 0.22 / Math.sqrt(1 - 0.22 * 0.22));
    assertEquals(1 + over, most, 0.1 * over);
    assertEquals(1, last, 1e-6);
  }

  /** Over 100 s / 2.75 a whole wave, begun at half of one. */
  @Test
  void wanderingBias_isAWaveOverTheLog() {
    MotionEffect effect = effect("wandering-bias", "over minutes", 1);
    assertEquals(0.04, number(effect, "rad_s"), NEAR);
    double period = 100 / 2.75;
    assertEquals(period, number(effect, "period_s"), NEAR);
    assertMoves(effect, AnyStep.told(0.3, 1, 0), 0.3, 1);
    assertMoves(effect, AnyStep.told(0.3, 1, period / 400), 0.3, 0.96);
    assertMoves(effect, AnyStep.told(0.3, 1, 3 * period / 400), 0.3, 1.04);
  }

  /** With the pile lying to its left it turns left, towards it or from it nothing. */
  @Test
  void grain_turnsTowardsThePile() {
    MotionEffect effect = effect("floor-grain", "like a carpet's pile", 1, alongZ());
    assertEquals(0.25, number(effect, "rad_m"), NEAR);
    assertEquals(-0.25 * 0.4, moved(effect, AnyStep.at(0, 0, 0, 0.4)).w(), NEAR);
    assertEquals(-0.25 * 0.4, moved(effect, AnyStep.at(0, 0, 0, -0.4)).w(), NEAR);
    assertEquals(0.25 * 0.4, moved(effect, AnyStep.at(0, 0, Math.PI, 0.4)).w(), NEAR);
    assertEquals(0, moved(effect, AnyStep.at(0, 0, Math.PI / 2, 0.4)).w(), NEAR);
    MotionEffect across = effect("floor-grain", "like a carpet's pile", 1);
    // It looks up the page and the pile lies along x, to its right.
    double right = moved(across, AnyStep.at(0, 0, Math.PI / 2, 0.4)).w();
    assertEquals(-0.25 * 0.4, right, NEAR);
    assertTrue(right < 0);
  }
}
