package simbad.gap.search;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import simbad.definition.Effect;
import simbad.gap.fit.CalibratedLog;
import simbad.gap.fit.Hypothesis;
import simbad.gap.fixture.Worlds;
import simbad.gap.score.GapGain;
import simbad.gap.score.GapGains;
import simbad.gap.score.GapMeter;
import simbad.gap.score.HeldOut.Scored;
import simbad.gap.score.Probabilities;
import simbad.sonar.sensing.ReadingRow;

class WeighedTest {
  private static final int BLOCK = 25;

  private static Hypothesis offset(double metres) {
    return Worlds.effect(Effect.RANGE_OFFSET, "constant", metres);
  }

  /** Six blocks of 25 rows; the ranges of every other block are shifted otherwise. */
  private static CalibratedLog shifted(double evenM, double oddM) {
    List<ReadingRow> poses = Worlds.poses(6 * BLOCK, 0.3, 1.3, 5);
    List<ReadingRow> even = Worlds.read(poses, offset(evenM), 6);
    List<ReadingRow> odd = Worlds.read(poses, offset(oddM), 6);
    List<ReadingRow> rows = new ArrayList<>();
    for (int i = 0; i < poses.size(); i++) {
      rows.add((i / BLOCK % 2 == 0 ? even : odd).get(i));
    }
    return Worlds.given(rows);
  }

  private static Weighed weighed(CalibratedLog given, Scored likelier) {
    List<Scored> sets = List.of(likelier, new Scored(Hypothesis.NONE, 0, 0));
    return Weighed.of(new GapGains(given), sets, Probabilities.COST_NATS, 1);
  }

  /** What was fitted on one half is wrong by 4 cm on the other, however likely it is said to be. */
  @Test
  void setThatEnlargesTheGap_givesWayToTheNext() {
    Scored set = new Scored(offset(0.02), 500, 500);
    Weighed weighed = weighed(shifted(0.02, -0.02), set);
    assertEquals(List.of(set), weighed.enlarging());
    assertEquals(Hypothesis.NONE, weighed.probabilities().best().hypothesis());
    assertEquals(weighed.gain().beforeM(), weighed.gain().afterM());
  }

  /**
   * Where nothing is shifted an offset of nothing takes nothing away, said to be however likely.
   */
  @Test
  void setThatLeavesTheGapAsItIs_isNotTaken() {
    Weighed weighed = weighed(shifted(0, 0), new Scored(offset(0), 500, 500));
    assertEquals(Hypothesis.NONE, weighed.taken().hypothesis());
  }

  /** Of what befalls readings wherever they are; an object depends on the place. */
  @Test
  void unseen_isWhatGainsTwiceItsCost() {
    CalibratedLog given = shifted(0, 0);
    Hypothesis crosstalk = Worlds.effect(Effect.CROSSTALK, "any", 0.02, 0, 4);
    Hypothesis post = Worlds.effect(Effect.UNMODELLED_OBJECT, "mirror", 1, 1, 0, 1, 1);
    for (double nats : new double[] {19.9, 20.1}) {
      List<Scored> sets =
          List.of(
              new Scored(Hypothesis.NONE, 0, 0),
              new Scored(crosstalk, nats, nats),
              new Scored(post, 30, 30));
      Weighed weighed = Weighed.of(new GapGains(given), sets, Probabilities.COST_NATS, 1);
      assertEquals(Hypothesis.NONE, weighed.taken().hypothesis());
      assertEquals(
          nats > 20 ? Optional.of(new Weighed.Unseen(Effect.CROSSTALK, nats)) : Optional.empty(),
          weighed.unseen(given, sets, Probabilities.COST_NATS, 1));
    }
  }

  @Test
  void worthNaming_isAHundredthOfTheGap() {
    GapMeter.Gaps before = new GapMeter.Gaps(new double[] {1}, new double[1]);
    GapMeter.Gaps less = new GapMeter.Gaps(new double[] {0.991}, new double[1]);
    GapMeter.Gaps worth = new GapMeter.Gaps(new double[] {0.989}, new double[1]);
    assertTrue(
        !new GapGain(before, less).isWorthNaming() && new GapGain(before, worth).isWorthNaming());
  }

  /** Before a set-up that has moved less is seen, or more expected. */
  @Test
  void whatASetupThatMovesTakesUp_isNotLeft() {
    GapMeter.Gaps far = new GapMeter.Gaps(new double[] {0.05}, new double[] {0.02});
    assertTrue(new GapGain(far, far).leavesMuch());
    GapMeter.Gaps moved = new GapMeter.Gaps(new double[] {0.05}, new double[] {0.03});
    GapGain open = new GapGain(far, far).beside(moved);
    assertTrue(!open.leavesMuch());
    assertEquals(0.03, open.floorM());
  }

  /** Where something is at work for sure an effect has to outweigh other effects alone. */
  @Test
  void ofSome_takesWhatIsLikeliest_thoughNoneWouldBe() {
    CalibratedLog given = shifted(0.1, 0.1);
    List<Scored> sets = List.of(new Scored(offset(0.1), 8, 8), new Scored(Hypothesis.NONE, 0, 0));
    assertEquals(
        Hypothesis.NONE,
        Weighed.of(new GapGains(given), sets, Probabilities.COST_NATS, 1).taken().hypothesis());
    assertEquals(
        offset(0.1),
        Weighed.ofSome(new GapGains(given), sets, Probabilities.COST_NATS, 1)
            .orElseThrow()
            .taken()
            .hypothesis());
    List<Scored> weak = List.of(new Scored(offset(0.1), 4, 4), new Scored(Hypothesis.NONE, 0, 0));
    assertTrue(Weighed.ofSome(new GapGains(given), weak, Probabilities.COST_NATS, 1).isEmpty());
    assertTrue(
        Weighed.ofSome(new GapGains(shifted(0, 0)), sets, Probabilities.COST_NATS, 1).isEmpty(),
        "leaves the gap as it is");
  }

  /** What outdoes it says too little itself, so that neither is left. */
  @Test
  void ofSome_isEmpty_whereOnlyWhatIsOutdoneSaysEnough() {
    double worth = Probabilities.COST_NATS;
    List<Scored> sets =
        List.of(
            new Scored(offset(1), 0.6 * worth, 0.6 * worth),
            new Scored(offset(0.1), 0.4 * worth, 0.4 * worth),
            new Scored(Hypothesis.NONE, 0, 0));
    assertTrue(sets.get(0).hypothesis().isAtBound());
    assertTrue(Weighed.ofSome(new GapGains(shifted(0.1, 0.1)), sets, worth, 1).isEmpty());
  }

  @Test
  void setThatShrinksTheGap_isTaken() {
    Scored set = new Scored(offset(0.1), 500, 500);
    Weighed weighed = weighed(shifted(0.1, 0.1), set);
    assertEquals(List.of(), weighed.enlarging());
    assertEquals(set, weighed.probabilities().best());
    assertTrue(weighed.gain().afterM() < 0.5 * weighed.gain().beforeM());
  }

  private static Optional<Weighed> confirmed(CalibratedLog given, Scored... others) {
    List<Scored> sets = new ArrayList<>(List.of(others));
    sets.add(new Scored(Hypothesis.NONE, 0, 0));
    GapGains gains = new GapGains(given);
    return Weighed.of(gains, sets, Probabilities.COST_NATS, 1)
        .confirmed(gains, sets, Probabilities.COST_NATS);
  }

  @Test
  void whatIsSure_isConfirmedWithItsOwnGain() {
    Scored set = new Scored(offset(0.1), 500, 500);
    Weighed sure = confirmed(shifted(0.1, 0.1), set).orElseThrow();
    assertEquals(set, sure.taken());
    assertTrue(sure.gain().afterM() < 0.5 * sure.gain().beforeM());
    assertTrue(
        confirmed(shifted(0, 0), new Scored(offset(0), 500, 500)).isEmpty(),
        "it leaves the gap as it was");
    assertTrue(
        confirmed(shifted(0.1, 0.1), new Scored(offset(0.1), 49, 49)).isEmpty(),
        "five times its cost is asked");
  }

  /** What takes up a little of anything is never sure, however much of the gap it takes away. */
  @Test
  void noise_isNeverConfirmed() {
    Hypothesis noise = Worlds.effect(Effect.RANGE_NOISE, "constant", 0.1);
    CalibratedLog given = Worlds.given(Worlds.read(Worlds.poses(150, 0.3, 1.3, 5), noise, 6));
    Scored set = new Scored(noise, 500, 500);
    assertEquals(set, weighed(given, set).taken());
    assertTrue(confirmed(given, set).isEmpty());
  }

  /** A post that stands elsewhere is sure where that alone takes away half of the gap. */
  @Test
  void whatMovesThings_isConfirmed_whereItDoesMostAlone() {
    Hypothesis moved = Worlds.effect(Effect.OBSTACLE_OFFSET, "all", 0.2, 0);
    Scored set = new Scored(moved, 500, 500);
    List<ReadingRow> poses = Worlds.poses(150, 0.3, 1.3, 5);
    CalibratedLog alone = Worlds.given(Worlds.read(poses, moved, 6));
    assertTrue(new GapGains(alone).of(moved).shrinkage() > 0.5);
    assertEquals(set, confirmed(alone, set).orElseThrow().taken());
    Hypothesis lost = Worlds.effect(Effect.DROPOUT, "single", 0.5);
    Hypothesis both = moved.and(lost.forms().get(0), 0.5);
    CalibratedLog beside = Worlds.given(Worlds.read(poses, both, 6));
    GapGain gain = new GapGains(beside).of(moved);
    assertTrue(gain.isWorthNaming() && gain.shrinkage() < 0.5, () -> "" + gain.shrinkage());
    assertTrue(confirmed(beside, set).isEmpty());
  }

  /** Nothing is left beside the same set-up, and a moved one has its own gap. */
  @Test
  void beside_takesTheGapOfTheSetUpThatMoved() {
    CalibratedLog given = shifted(0.1, 0.1);
    Weighed weighed = weighed(given, new Scored(offset(0.1), 500, 500));
    assertSame(weighed, weighed.beside(given, given));
    CalibratedLog open = given.calibrated(offset(0.02).changes());
    Weighed moved = weighed.beside(given, open);
    assertEquals(weighed.gain().after(), moved.gain().after());
    double left = new GapGains(open).of(offset(0.1)).afterM();
    assertEquals(
        left, Arrays.stream(moved.gain().open().observedM()).average().orElseThrow(), 1e-12);
    assertEquals(weighed.taken(), moved.taken());
  }
}
