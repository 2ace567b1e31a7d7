package simbad.gap.score;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.Test;
import simbad.definition.Effect;
import simbad.gap.fit.Hypothesis;
import simbad.gap.fixture.Worlds;
import simbad.gap.score.HeldOut.Scored;

class ProbabilitiesTest {
  private static final Hypothesis GAIN = Worlds.effect(Effect.GAIN, "factor", 0.8);
  private static final Hypothesis ABSORPTION = Worlds.effect(Effect.ABSORPTION, "hyperbolic", 0.1);
  private static final Hypothesis BOTH = GAIN.and(ABSORPTION.forms().get(0), 0.1);

  private static Scored scored(Hypothesis set, double nats) {
    return new Scored(set, nats, nats);
  }

  /** One effect that gains just its cost, and half a nat for its value, is as probable as none. */
  @Test
  void anEffectCosts() {
    Probabilities even =
        new Probabilities(
            List.of(scored(Hypothesis.NONE, -100), scored(GAIN, -89.5)), 10, 2, Set.of());
    assertEquals(0.5, even.ofEffects().getOrDefault(Effect.GAIN, 0.0), 1e-12);
    Probabilities four =
        new Probabilities(
            List.of(scored(Hypothesis.NONE, -100), scored(GAIN, -85.5)), 10, 2, Set.of());
    assertEquals(1 / (1 + Math.exp(-2)), four.ofEffects().getOrDefault(Effect.GAIN, 0.0), 1e-12);
    assertEquals(GAIN, four.best().hypothesis());
    assertEquals(2, four.behind(scored(Hypothesis.NONE, -100)), 1e-12);
    assertEquals(0, four.behind(four.best()));
    assertTrue(Double.isInfinite(four.behind(scored(BOTH, -85.5))), "was not weighed");
    Probabilities clumped =
        new Probabilities(
            List.of(scored(Hypothesis.NONE, -100), scored(GAIN, -85.5)), 10, 4, Set.of());
    assertEquals(1 / (1 + Math.exp(-1)), clumped.ofEffects().getOrDefault(Effect.GAIN, 0.0), 1e-12);
  }

  /** A third effect costs four times as much as one of two, a fourth seven times. */
  @Test
  void aThirdAndAFourthEffectCostMore() {
    Hypothesis three = BOTH.and(Worlds.effect(Effect.LATENCY, "time", 0.1).forms().get(0), 0.1);
    Hypothesis four =
        three.and(Worlds.effect(Effect.SOUND_SPEED, "scale", 340).forms().get(0), 340);
    checkEven(BOTH, 10 * 2 + 0.5 * 2);
    checkEven(three, 10 * (1 + 1 + 4) + 0.5 * 3);
    checkEven(four, 10 * (1 + 1 + 4 + 7) + 0.5 * 4);
  }

  private static void checkEven(Hypothesis set, double nats) {
    Probabilities even =
        new Probabilities(
            List.of(scored(Hypothesis.NONE, -100), scored(set, -100 + nats)), 10, 2, Set.of());
    assertEquals(0.5, even.ofEffects().getOrDefault(Effect.GAIN, 0.0), 1e-12, set.toString());
  }

  /** What does not show in the gap costs five times as much. */
  @Test
  void anUnseenEffectCostsMore() {
    List<Scored> sets = List.of(scored(Hypothesis.NONE, -100), scored(GAIN, -59.5));
    assertEquals(GAIN, new Probabilities(sets, 10, 2, Set.of()).best().hypothesis());
    Probabilities unseen = new Probabilities(sets, 10, 2, Set.of(Effect.GAIN));
    assertEquals(1 / (1 + Math.exp(5)), unseen.ofEffects().getOrDefault(Effect.GAIN, 0.0), 1e-12);
  }

  /** What the log was taken for costs nothing: only its one value is counted. */
  @Test
  void anInvitedEffectCostsNothing() {
    List<Scored> sets = List.of(scored(Hypothesis.NONE, -100), scored(GAIN, -99.5));
    Probabilities invited =
        new Probabilities(sets, 10, 2, Set.of(), set -> Set.copyOf(set.effects()), Map.of());
    assertEquals(0.5, invited.ofNone(), 1e-12);
    Probabilities unseen =
        new Probabilities(
            sets, 10, 2, Set.of(Effect.GAIN), set -> Set.copyOf(set.effects()), Map.of());
    assertEquals(0.5, unseen.ofNone(), 1e-12, "neither does it have to show");
  }

  /** A turn of all headings, as a misalignment or as a drift that settles at once. */
  @Test
  void ofSetsThatPredictAlike_theOneWithFewerValuesIsLikelier() {
    Hypothesis settling = Worlds.effect(Effect.HEADING_DRIFT, "settling", 5, 2);
    Hypothesis turn = Worlds.effect(Effect.BEAM_MISALIGNMENT, "all", 5);
    Probabilities alike =
        new Probabilities(List.of(scored(settling, -50), scored(turn, -50)), 10, 2, Set.of());
    assertEquals(turn, alike.best().hypothesis());
    assertEquals(
        1 / (1 + Math.exp(0.25)), alike.ofEffects().getOrDefault(Effect.HEADING_DRIFT, 0.0), 1e-12);
  }

  /** What is not of none is of one of them. */
  @Test
  void noneAndAny_areAllThereIs() {
    Probabilities four =
        new Probabilities(
            List.of(scored(Hypothesis.NONE, -100), scored(GAIN, -85.5)), 10, 2, Set.of());
    assertEquals(1 / (1 + Math.exp(2)), four.ofNone(), 1e-12);
    assertEquals(1, four.ofNone() + four.ofAny(Set.of(Effect.GAIN)), 1e-12);
    assertEquals(0, four.ofAny(Set.of(Effect.DROPOUT)), 1e-12);
  }

  @Test
  void tiesAreWhatCouldStandInItsPlace() {
    Probabilities close =
        new Probabilities(List.of(scored(GAIN, -50), scored(ABSORPTION, -52)), 10, 2, Set.of());
    assertEquals(List.of(Effect.ABSORPTION), close.tiesOf(Effect.GAIN, 3));
    assertEquals(List.of(), close.tiesOf(Effect.GAIN, 1));
  }

  /** What a log cannot tell apart because of how it was taken shares a probability. */
  @Test
  void twinsShareAProbability_andAreTied() {
    List<Scored> sets = List.of(scored(Hypothesis.NONE, -100), scored(GAIN, -85.5));
    Probabilities twins =
        new Probabilities(
            sets,
            10,
            2,
            Set.of(),
            set -> Set.of(),
            Map.of(Effect.GAIN, Set.of(Effect.PREVIOUS_PING)));
    double both = 1 / (1 + Math.exp(-2));
    assertEquals(both / 2, twins.ofEffects().getOrDefault(Effect.GAIN, 0.0), 1e-12);
    assertEquals(both / 2, twins.ofEffects().getOrDefault(Effect.PREVIOUS_PING, 0.0), 1e-12);
    assertEquals(List.of(Effect.PREVIOUS_PING), twins.tiesOf(Effect.GAIN, 3));
    assertEquals(both, twins.ofAny(Set.of(Effect.GAIN, Effect.PREVIOUS_PING)), 1e-12);
  }

  @Test
  void capped_aSetPredictsNoBetterThanItFits() {
    List<Scored> capped =
        HeldOut.capped(
            List.of(
                new Scored(Hypothesis.NONE, -100, -101),
                new Scored(GAIN, -60, -61),
                new Scored(BOTH, -59, -40)));
    double both =
        capped.stream()
            .filter(set -> set.hypothesis().equals(BOTH))
            .findFirst()
            .orElseThrow()
            .heldOut();
    assertEquals(-60, both, 1e-12);
  }
}
