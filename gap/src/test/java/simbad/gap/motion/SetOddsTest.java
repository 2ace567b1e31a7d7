package simbad.gap.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import simbad.motion.MotionChain;
import simbad.motion.effect.MotionForm;
import simbad.motion.effect.MotionForms;

/** Sets whose blocks are said by hand, of a log without values: nothing hangs together. */
class SetOddsTest {
  private static final MotionForm LATE = MotionForms.find("actuation-latency").orElseThrow();
  private static final MotionForm SCALE = MotionForms.find("speed-scale").orElseThrow();
  private static final MotionForm TURN = MotionForms.find("turn-scale").orElseThrow();
  private static final MotionHypothesis NONE =
      new MotionHypothesis(MotionChain.EXACT, List.of(), new double[0]);
  private static final MotionSteps GIVEN = given();
  private static final Noise[] NOISES = {
    Noise.believed(0.001), Noise.believed(0.001), Noise.believed(0.002)
  };
  private static final Slopes NO_VALUES =
      new Slopes(GIVEN, new MotionFit(NONE, GIVEN.residuals(MotionChain.EXACT), NOISES, 0));

  private static MotionSteps given() {
    Drives drives = new Drives(64);
    drives.seconds = 20;
    return new MotionSteps(drives.data().runs());
  }

  private static ScoredMotion set(double[] blocks, MotionForm... forms) {
    MotionHypothesis set = NONE;
    for (MotionForm form : forms) {
      set = set.with(form, form.neutralValues());
    }
    return new ScoredMotion(new MotionFit(set, new double[3][0], NOISES, 0), NO_VALUES, blocks);
  }

  private static double[] ten(double each) {
    double[] blocks = new double[10];
    Arrays.fill(blocks, each);
    return blocks;
  }

  /** Ten blocks that are worse by 10 nats, give or take some. */
  private static List<String> ties(double plusMinus) {
    double[] blocks = new double[10];
    Arrays.setAll(blocks, b -> 20 - 10 + (b % 2 == 0 ? plusMinus : -plusMinus));
    return new Odds(List.of(set(ten(0)), set(ten(20), LATE), set(blocks, SCALE)))
        .tiesOf(LATE.effect());
  }

  /** The mean's error is a third of what each is off by; two of these are clear. */
  @Test
  void aWinnerIsClearByTwoErrorsOfTheMean() {
    assertEquals(List.of(), ties(14.9));
    assertEquals(List.of(SCALE.effect()), ties(15.1));
  }

  /** Behind by 4.5 nats of blocks, over the temperature, is 3. */
  @Test
  void whatIsNearIsATieHoweverClear() {
    List<ScoredMotion> near = List.of(set(ten(0)), set(ten(3), LATE), set(ten(2.56), SCALE));
    List<ScoredMotion> far = List.of(set(ten(0)), set(ten(3), LATE), set(ten(2.54), SCALE));

    assertEquals(List.of(SCALE.effect()), new Odds(near).tiesOf(LATE.effect()));
    assertEquals(List.of(), new Odds(far).tiesOf(LATE.effect()));
  }

  /** The nearest comes first, and what stands beside the rest too. */
  @Test
  void tiesAreOrdered_andBesideTheRest() {
    Odds odds =
        new Odds(
            List.of(
                set(ten(0)),
                set(ten(5), LATE, TURN),
                set(ten(4.7), SCALE, TURN),
                set(ten(4.4), LATE, SCALE)));

    assertEquals(List.of(SCALE.effect()), odds.tiesOf(LATE.effect()));
    assertEquals(List.of(), new Odds(List.of(set(ten(5), LATE))).tiesOf(LATE.effect()));
    Odds three = new Odds(List.of(set(ten(5), LATE), set(ten(4.7), TURN), set(ten(4.8), SCALE)));
    assertEquals(List.of(SCALE.effect(), TURN.effect()), three.tiesOf(LATE.effect()));
  }

  /** Of the sets that have nothing but the rest, the likeliest on left-out blocks. */
  @Test
  void lackingIsTheLikeliestOfTheRest() {
    ScoredMotion none = set(ten(1));
    ScoredMotion late = set(ten(2), LATE);
    ScoredMotion both = set(ten(9), LATE, SCALE);
    ScoredMotion turn = set(ten(3), TURN);
    Odds odds = new Odds(List.of(both, none, late, turn));

    assertSame(late, odds.lacking(SCALE.effect()));
    assertSame(none, odds.lacking(LATE.effect()));
    assertSame(both, odds.bestWith(LATE.effect()));
    assertSame(turn, odds.bestWith(TURN.effect()));
    assertSame(none, odds.nominal());
    assertEquals(1, odds.clumping(), 0);
    assertSame(turn, odds.without(LATE.effect()).best());
  }

  @Test
  void whatGainsItsCostIsEven() {
    Odds odds = new Odds(List.of(set(ten(1))));

    assertEquals(0.5, odds.ofGain(6), 1e-12);
    assertEquals(1 / (1 + Math.exp(2)), odds.ofGain(3), 1e-12);
    assertEquals(1, odds.ofAny("none", List.of()) + 1, 0);
  }
}
