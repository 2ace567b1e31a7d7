package simbad.blindworld.motionchange;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static simbad.blindworld.motionchange.MotionGround.BASE_M;
import static simbad.blindworld.motionchange.MotionGround.STEP_S;
import static simbad.blindworld.motionchange.MotionGround.acting;
import static simbad.blindworld.motionchange.MotionGround.effect;
import static simbad.blindworld.motionchange.MotionGround.next;
import static simbad.blindworld.motionchange.MotionGround.number;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import simbad.blindworld.motion.Acting;
import simbad.blindworld.motion.AnyStep;
import simbad.blindworld.motion.Commands.Speeds;
import simbad.blindworld.motion.MotionChange.Stage;
import simbad.blindworld.motion.Sight;
import simbad.blindworld.world.FixedChance;

/** Slip, motion-noise, capture-offset, with chance that is told what to say. */
class ChanceFormsTest {

  private static final double NEAR = 1e-12;

  /** A bout begins in a step below 0.12 * 0.02 = 0.0024. */
  private static final double JUST_BELOW = 0.0023;

  private static final double JUST_ABOVE = 0.0025;

  /** How many steps running are slower than told. */
  private static int slips(Acting acting, double v, int most) {
    int count = 0;
    while (count < most && next(acting, v, 0).vMPerS() < v) {
      count++;
    }
    return count;
  }

  @Test
  void bout_isOfThatSize() {
    MotionEffect effect = effect("slip", "bouts", 1);
    assertEquals(0.12, number(effect, "per_s"), NEAR);
    assertEquals(0.3, number(effect, "least_s"), NEAR);
    assertEquals(1.2, number(effect, "most_s"), NEAR);
    assertEquals(0.55, number(effect, "lost"), NEAR);
    assertEquals(Stage.CHANCE, effect.change().stage());
    MotionEffect twice = effect("slip", "bouts", 2);
    assertEquals(0.12 * Math.sqrt(2), number(twice, "per_s"), NEAR);
    assertEquals(0.55 * Math.sqrt(2), number(twice, "lost"), NEAR);
    assertEquals(0.95, number(effect("slip", "bouts", 4), "lost"), NEAR);
  }

  /** Of 0.3 to 1.2 s a quarter is 0.525 s: 26 steps of 0.02 s, in which 0.45 of both is left. */
  @Test
  void bouts_beginByChanceAndLastAWhile() {
    FixedChance chance = new FixedChance(JUST_ABOVE, JUST_BELOW, 0.25, 0.5, JUST_ABOVE);
    Acting acting = acting(effect("slip", "bouts", 1), chance);
    assertEquals(new Speeds(0.4, 0.2), next(acting, 0.4, 0.2));
    Speeds slipping = next(acting, 0.4, 0.2);
    assertEquals(0.18, slipping.vMPerS(), NEAR);
    assertEquals(0.09, slipping.wRadPerS(), NEAR);
    assertEquals(25, slips(acting, 0.4, 99));
    // The step after the bout's end is the first in which another one may begin.
    assertEquals(4, chance.asked());
    next(acting, 0.4, 0.2);
    assertEquals(5, chance.asked());
  }

  @Test
  void bout_beginsOnlyWhereItMoves() {
    FixedChance chance = new FixedChance(JUST_BELOW, 0.5, 0.5);
    Acting acting = acting(effect("slip", "bouts", 1), chance);
    next(acting, 0, 0);
    assertEquals(0, chance.asked());
    assertEquals(0.45, next(acting, 0, -1).wRadPerS() / -1, NEAR, "turning is moving");
    Acting other = acting(effect("slip", "bouts", 1), new FixedChance(JUST_BELOW, 0.5, 0.5));
    assertEquals(-0.45, next(other, -1, 0).vMPerS(), NEAR);
  }

  /** The rims of 0.4 m/s and 2 rad/s are 0.25 and 0.55 m/s; one of them is left with 0.45. */
  @Test
  void oneWheel_slipsByItself() {
    MotionEffect effect = effect("slip", "one wheel", 1);
    Speeds left = next(acting(effect, new FixedChance(JUST_BELOW, 0.5, 0.4)), 0.4, 2);
    assertEquals((0.45 * 0.25 + 0.55) / 2, left.vMPerS(), NEAR);
    assertEquals((0.55 - 0.45 * 0.25) / BASE_M, left.wRadPerS(), NEAR);
    Speeds right = next(acting(effect, new FixedChance(JUST_BELOW, 0.5, 0.6)), 0.4, 2);
    assertEquals((0.25 + 0.45 * 0.55) / 2, right.vMPerS(), NEAR);
    assertEquals((0.45 * 0.55 - 0.25) / BASE_M, right.wRadPerS(), NEAR);
    assertEquals(new Speeds(0.4, 2), next(acting(effect, new FixedChance(JUST_ABOVE)), 0.4, 2));
  }

  private static Acting speedingUp(double chance) {
    return acting(effect("slip", "when it speeds up", 1), new FixedChance(chance, 0.5, 0.5));
  }

  /** Five times as apt, below 0.012, within half a second of speeding up; else 0.3 times. */
  @Test
  void whenItSpeedsUp_itSlipsMore() {
    assertEquals(0.45, next(speedingUp(0.0119), 1, 0).vMPerS(), NEAR);
    assertEquals(-0.45, next(speedingUp(0.0119), -1, 0).vMPerS(), NEAR);
    assertEquals(1, next(speedingUp(0.0121), 1, 0).vMPerS(), NEAR);
    // It turns on the spot, and no speed grows.
    assertEquals(0.45, next(speedingUp(0.00071), 0, 1).wRadPerS(), NEAR);
    assertEquals(1, next(speedingUp(0.00073), 0, 1).wRadPerS(), NEAR);
  }

  /** For 25 steps of 0.02 s; after that, and when it brakes, it is seldom. */
  @Test
  void speedingUp_isOverAfterHalfASecond() {
    List<Integer> slipped = new ArrayList<>();
    for (int steps : new int[] {24, 26}) {
      double[] numbers = new double[steps + 3];
      java.util.Arrays.fill(numbers, 0.9);
      numbers[steps] = 0.01;
      Acting acting = acting(effect("slip", "when it speeds up", 1), new FixedChance(numbers));
      for (int i = 0; i < steps; i++) {
        assertEquals(1, next(acting, 1, 0).vMPerS());
      }
      slipped.add(next(acting, 1, 0).vMPerS() < 1 ? 1 : 0);
    }
    assertEquals(List.of(1, 0), slipped);
    Acting braking = acting(effect("slip", "when it speeds up", 1), new FixedChance(0.9, 0.01));
    next(braking, 1, 0);
    braking.beginRun();
    assertEquals(1, next(braking, 0, 1).wRadPerS(), NEAR, "a run begins long after");
    Acting again =
        acting(effect("slip", "when it speeds up", 1), new FixedChance(0.9, 0.01, 0.5, 0.5));
    next(again, 1, 0);
    again.beginRun();
    assertTrue(next(again, 1, 0).vMPerS() < 1, "a run begins at rest");
  }

  /** Noise that says 1 goes on with k + sqrt(1 - k^2), k = exp(-0.02 / 0.6). */
  @Test
  void unsteadySpeeds_areMoreOrLessTogether() {
    MotionEffect effect = effect("motion-noise", "unsteady speeds", 1);
    assertEquals(0.12, number(effect, "share_of_v"), NEAR);
    assertEquals(0.12, number(effect, "share_of_w"), NEAR);
    assertEquals(0.6, number(effect, "constant_s"), NEAR);
    double k = Math.exp(-STEP_S / 0.6);
    double noise = k + Math.sqrt(1 - k * k);
    Acting acting = acting(effect, new FixedChance(0.5).gaussian(1));
    Speeds first = next(acting, 0.5, -2);
    assertEquals(0.5 * (1 + 0.12 * noise), first.vMPerS(), NEAR);
    // A share of the turn rate, and never of less than half of a common one, 0.8 rad/s.
    assertEquals(-2 + 0.12 * 2 * noise, first.wRadPerS(), NEAR);
    Acting straight = acting(effect, new FixedChance(0.5).gaussian(1));
    assertEquals(0.12 * 0.4 * noise, next(straight, -0.5, 0).wRadPerS(), NEAR);
    Acting slow = acting(effect, new FixedChance(0.5).gaussian(1));
    assertEquals(0.1 + 0.12 * 0.4 * noise, next(slow, 0, 0.1).wRadPerS(), NEAR);
    Acting still = acting(effect, new FixedChance(0.5).gaussian(1));
    assertEquals(new Speeds(0, 0), next(still, 0, 0));
  }

  /** A factor of each speed for 0.5 to 1.5 s; of 0.61 s there are 31 steps. */
  @Test
  void byCommand_keepsItsFactorsForAWhile() {
    MotionEffect effect = effect("motion-noise", "by command", 1);
    assertEquals(0.12, number(effect, "share"), NEAR);
    FixedChance chance = new FixedChance(0.11, 0.9).gaussian(1, -1, 2, 0.5);
    Acting acting = acting(effect, chance);
    for (int i = 0; i < 31; i++) {
      Speeds now = next(acting, 0.5, 1);
      assertEquals(0.5 * 1.12, now.vMPerS(), NEAR, "step " + i);
      assertEquals(0.88, now.wRadPerS(), NEAR);
    }
    Speeds then = next(acting, 0.5, 1);
    assertEquals(0.5 * 1.24, then.vMPerS(), NEAR);
    assertEquals(1.06, then.wRadPerS(), NEAR);
    assertEquals(2, chance.asked());
  }

  /** A push aside turns by its share of the way over two bases; one in twenty is three times. */
  @Test
  void unevenFloor_pushesByTheWay() {
    MotionEffect effect = effect("motion-noise", "uneven floor", 1);
    assertEquals(0.35, number(effect, "share"), NEAR);
    Speeds soft = next(acting(effect, new FixedChance(0.06).gaussian(1, 2)), 0.5, 1);
    assertEquals(1 + 0.35 * 0.5 / (2 * BASE_M), soft.wRadPerS(), NEAR);
    assertEquals(0.5 * 1.7, soft.vMPerS(), NEAR);
    Speeds hard = next(acting(effect, new FixedChance(0.04).gaussian(1, 0.5)), 0.5, 1);
    assertEquals(1 + 3 * 0.35 * 0.5 / (2 * BASE_M), hard.wRadPerS(), NEAR);
    assertEquals(0.5 * (1 + 3 * 0.35 * 0.5), hard.vMPerS(), NEAR);
  }

  private static Sight seen(MotionEffect effect) {
    Sight sight = AnyStep.seen(1, 2, 0);
    acting(effect).see(sight);
    return sight;
  }

  /** In parts of the base, forward along x and left up the page. */
  @Test
  void captureOffset_isAPointOrAHeadingOrBoth() {
    MotionEffect point =
        effect("capture-offset", "point", 1, new FixedChance(0.5).coins(true, false));
    assertEquals(0.35 * BASE_M, number(point, "forward_m"), NEAR);
    assertEquals(-0.2 * BASE_M, number(point, "left_m"), NEAR);
    assertEquals(1 + 0.35 * BASE_M, seen(point).xM(), NEAR);
    assertEquals(2 + 0.2 * BASE_M, seen(point).zM(), NEAR);
    assertEquals(0, seen(point).headingRad());
    MotionEffect heading = effect("capture-offset", "heading", 2);
    assertEquals(8, number(heading, "deg"), NEAR);
    assertEquals(Math.toRadians(8), seen(heading).headingRad(), NEAR);
    assertEquals(1, seen(heading).xM());
    MotionEffect both =
        effect("capture-offset", "both", 1, new FixedChance(0.5).coins(true, true, false));
    assertEquals(0.3 * BASE_M, number(both, "forward_m"), NEAR);
    assertEquals(0.15 * BASE_M, number(both, "left_m"), NEAR);
    assertEquals(-3, number(both, "deg"), NEAR);
    // Shifted by the true heading and turned after that.
    assertEquals(1 + 0.3 * BASE_M, seen(both).xM(), NEAR);
    assertEquals(2 - 0.15 * BASE_M, seen(both).zM(), NEAR);
    assertEquals(Math.toRadians(-3), seen(both).headingRad(), NEAR);
  }
}
