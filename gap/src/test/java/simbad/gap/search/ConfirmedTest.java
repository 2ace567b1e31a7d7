package simbad.gap.search;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import simbad.definition.Effect;
import simbad.gap.fit.Hypothesis;
import simbad.gap.fixture.Worlds;
import simbad.gap.score.HeldOut.Scored;

/** Sets with scores by hand, where a further effect has to gain ten nats and a sure one fifty. */
class ConfirmedTest {
  private static final double WORTH = 10;
  private static final Hypothesis GAIN = Worlds.effect(Effect.GAIN, "factor", 0.8);
  private static final Hypothesis ABSORPTION = Worlds.effect(Effect.ABSORPTION, "hyperbolic", 0.1);
  private static final Hypothesis DROPOUT = Worlds.effect(Effect.DROPOUT, "single", 0.3);
  private static final Hypothesis CLAMP = Worlds.effect(Effect.NEAR_CLAMP, "clamp", 0.3);
  private static final Hypothesis STALE = Worlds.effect(Effect.STALE_READING, "count", 3);
  private static final Hypothesis HOLD = Worlds.effect(Effect.HYSTERESIS, "hold", 0.1);
  private static final Scored NONE = scored(0);

  private static Scored scored(double nats, Hypothesis... some) {
    Hypothesis all = Hypothesis.NONE;
    for (Hypothesis one : some) {
      all = all.and(one.forms().get(0), one.values());
    }
    return new Scored(all, nats, nats);
  }

  private static List<Effect> sure(
      Set<Effect> doubtful, boolean isPlaced, boolean isDone, Scored... sets) {
    return new Confirmed(List.of(sets), doubtful, set -> Set.of(), WORTH, isPlaced, isDone)
        .best()
        .map(set -> set.hypothesis().effects())
        .orElse(List.of());
  }

  private static List<Effect> sure(Scored... sets) {
    return sure(Set.of(), false, true, sets);
  }

  /** Five times what a further effect must gain, as where it does not show in the gap. */
  @Test
  void sureIsWhatCostsFiveTimesItsWorthToLeaveOut() {
    assertEquals(List.of(), sure(NONE, scored(50, GAIN)));
    assertEquals(List.of(Effect.GAIN), sure(NONE, scored(50.1, GAIN)));
    assertEquals(List.of(), sure(scored(99, GAIN)), "without it nothing was fitted");
  }

  /**
   * What is to be expected needs no more than it is worth, and may take up a little of anything.
   */
  @Test
  void whatIsInvited_isSureWhereItIsWorthIt() {
    for (double nats : new double[] {WORTH, WORTH + 0.1}) {
      List<Effect> sure =
          new Confirmed(
                  List.of(NONE, scored(nats, GAIN)),
                  Set.of(Effect.GAIN),
                  set -> Set.of(Effect.GAIN),
                  WORTH,
                  false,
                  true)
              .best()
              .map(set -> set.hypothesis().effects())
              .orElse(List.of());
      assertEquals(nats > WORTH ? List.of(Effect.GAIN) : List.of(), sure);
    }
  }

  @Test
  void whatIsDoubtful_orAtAnEndOfTheSearch_isNeverSure() {
    assertEquals(List.of(), sure(Set.of(Effect.GAIN), false, true, NONE, scored(99, GAIN)));
    Hypothesis far = Worlds.effect(Effect.RANGE_OFFSET, "constant", 1);
    assertEquals(List.of(), sure(NONE, scored(99, far)));
    assertEquals(List.of(Effect.RANGE_OFFSET), sure(NONE, scored(99, far.with(0.5))), "is no end");
  }

  /** The end at which another effect stands does not count. */
  @Test
  void endOfTheSearch_isTheEffectsOwn() {
    Hypothesis far = Worlds.effect(Effect.RANGE_OFFSET, "constant", 1);
    Scored alone = scored(60, GAIN);
    assertEquals(
        Optional.of(alone),
        new Confirmed(
                List.of(NONE, scored(125, GAIN, far), alone, scored(60, far)),
                Set.of(),
                set -> Set.of(),
                WORTH,
                false,
                false)
            .best());
  }

  /** A speed beside an offset that wants to be larger than any: it is what the offset leaves. */
  @Test
  void whatMovesRanges_isNotSureBesideAnotherThatStandsAtAnEnd() {
    Hypothesis far = Worlds.effect(Effect.RANGE_OFFSET, "constant", 1);
    Hypothesis near = Worlds.effect(Effect.RANGE_OFFSET, "constant", 0.1);
    Hypothesis speed = Worlds.effect(Effect.SOUND_SPEED, "scale", 340);
    assertEquals(
        List.of(), sure(NONE, scored(150, speed, far), scored(60, speed), scored(60, far)));
    assertEquals(
        List.of(Effect.SOUND_SPEED, Effect.RANGE_OFFSET),
        sure(NONE, scored(150, speed, near), scored(60, speed), scored(60, near)));
  }

  /** Beside what is sure something takes up the rest: it is not named. */
  @Test
  void whatIsNotSureBesideIt_isLeftOut() {
    Scored gain = scored(95, GAIN);
    Scored[] sets = {NONE, scored(100, GAIN, ABSORPTION), gain, scored(40, ABSORPTION)};
    assertEquals(List.of(Effect.GAIN), sure(sets));
    assertEquals(
        List.of(),
        sure(NONE, scored(100, GAIN, ABSORPTION), scored(40, ABSORPTION)),
        "it was not fitted alone");
    assertEquals(
        List.of(Effect.GAIN, Effect.ABSORPTION),
        sure(NONE, scored(110, GAIN, ABSORPTION), scored(55, GAIN), scored(55, ABSORPTION)));
  }

  @Test
  void rival_doesNearlyAsWellInItsPlace() {
    assertEquals(List.of(Effect.GAIN), sure(NONE, scored(60, GAIN), scored(50, ABSORPTION)));
    assertEquals(List.of(), sure(NONE, scored(60, GAIN), scored(50.1, ABSORPTION)));
    assertEquals(
        List.of(Effect.GAIN),
        sure(NONE, scored(60, GAIN), scored(55, ABSORPTION, DROPOUT)),
        "two effects are no rival of one");
    assertEquals(
        List.of(Effect.GAIN, Effect.DROPOUT),
        sure(
            NONE,
            scored(120, GAIN, DROPOUT),
            scored(60, GAIN),
            scored(60, DROPOUT),
            scored(115, ABSORPTION, CLAMP)),
        "a rival has all the others");
    assertEquals(
        List.of(Effect.DROPOUT),
        sure(
            NONE,
            scored(120, GAIN, DROPOUT),
            scored(60, GAIN),
            scored(60, DROPOUT),
            scored(115, ABSORPTION, DROPOUT)),
        "one that has all the others");
  }

  /** What takes up a little of anything has to do better; of places it says nothing at all. */
  @Test
  void doubtfulRival_hasToDoBetter() {
    Set<Effect> doubtful = Set.of(Effect.ABSORPTION);
    Scored gain = scored(60, GAIN);
    assertEquals(
        List.of(Effect.GAIN), sure(doubtful, false, false, NONE, gain, scored(60, ABSORPTION)));
    assertEquals(List.of(), sure(doubtful, false, false, NONE, gain, scored(61, ABSORPTION)));
    assertEquals(
        List.of(Effect.GAIN), sure(doubtful, true, false, NONE, gain, scored(61, ABSORPTION)));
  }

  /** What is sure in a set that is far worse only does the work of what the best set has. */
  @Test
  void setFarBehind_countsWhereThingsWerePlaced() {
    Set<Effect> doubtful = Set.of(Effect.ABSORPTION, Effect.DROPOUT);
    Scored[] sets = {NONE, scored(70, ABSORPTION, DROPOUT), scored(60, GAIN)};
    assertEquals(List.of(), sure(doubtful, false, false, sets));
    assertEquals(List.of(Effect.GAIN), sure(doubtful, true, false, sets));
    sets[1] = scored(69.9, ABSORPTION, DROPOUT);
    assertEquals(List.of(Effect.GAIN), sure(doubtful, false, false, sets));
  }

  /** Of sets in which something is sure the best one counts. */
  @Test
  void bestOfTheSets_isTaken() {
    Scored gain = scored(60, GAIN);
    Scored dropout = scored(75, DROPOUT);
    assertEquals(List.of(Effect.DROPOUT), sure(NONE, gain, dropout));
    assertEquals(List.of(Effect.DROPOUT), sure(dropout, gain, NONE));
  }

  /** Placed, and most of the gap is gone: it must not be superfluous beside what does the work. */
  @Test
  void whereTheWorkIsDone_itIsSureInTheBestSetThatHasIt() {
    Set<Effect> doubtful = Set.of(Effect.ABSORPTION);
    Scored[] sets = {NONE, scored(60, GAIN), scored(95, ABSORPTION), scored(104, GAIN, ABSORPTION)};
    assertEquals(List.of(), sure(doubtful, true, true, sets));
    assertEquals(List.of(Effect.GAIN), sure(doubtful, true, false, sets), "not done");
    sets[3] = scored(105, GAIN, ABSORPTION);
    assertEquals(List.of(Effect.GAIN), sure(doubtful, true, true, sets));
    Scored[] rival = {
      NONE,
      scored(60, GAIN),
      scored(90, ABSORPTION),
      scored(105, GAIN, ABSORPTION),
      scored(96, DROPOUT, ABSORPTION)
    };
    assertEquals(List.of(), sure(doubtful, true, true, rival));
    rival[4] = scored(95, DROPOUT, ABSORPTION);
    assertEquals(List.of(Effect.GAIN), sure(doubtful, true, true, rival));
    rival[2] = scored(95.1, ABSORPTION, DROPOUT, CLAMP);
    assertEquals(
        List.of(Effect.GAIN), sure(doubtful, true, true, rival), "without it nothing was fitted");
  }

  /** A clamp of 30 cm is how some rangers are made: it is sure though superfluous in the best. */
  @Test
  void whatIsByDesign_needNotBeSureInTheBest() {
    Set<Effect> doubtful = Set.of(Effect.ABSORPTION);
    Scored both = scored(96, CLAMP, ABSORPTION);
    assertEquals(
        List.of(Effect.NEAR_CLAMP),
        sure(doubtful, true, true, NONE, scored(60, CLAMP), scored(95, ABSORPTION), both));
    Hypothesis wide = CLAMP.with(0.6);
    assertEquals(
        List.of(),
        sure(
            doubtful,
            true,
            true,
            NONE,
            scored(60, wide),
            scored(95, ABSORPTION),
            scored(96, wide, ABSORPTION)));
  }

  /** What remembers the reading before knows the placement: its sets judge nobody. */
  @Test
  void whatKnowsThePingBefore_isNoJudge() {
    Set<Effect> doubtful = Set.of(Effect.STALE_READING, Effect.HYSTERESIS);
    for (Hypothesis knows : List.of(STALE, HOLD)) {
      assertEquals(
          List.of(Effect.GAIN),
          sure(
              doubtful,
              true,
              true,
              NONE,
              scored(60, GAIN),
              scored(95, knows),
              scored(96, knows, GAIN)),
          knows.toString());
    }
  }
}
