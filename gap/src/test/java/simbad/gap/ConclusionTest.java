package simbad.gap;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import simbad.definition.Effect;
import simbad.gap.diagnosis.GapKind;
import simbad.gap.diagnosis.Place;
import simbad.gap.diagnosis.Verdict;
import simbad.gap.fit.Hypothesis;
import simbad.gap.fixture.Worlds;
import simbad.gap.score.Blocks;
import simbad.gap.score.GapGain;
import simbad.gap.score.GapMeter;
import simbad.gap.score.HeldOut.Scored;
import simbad.gap.score.Probabilities;
import simbad.gap.search.Weighed;
import simbad.sonar.ping.PingLog;

/** What holds of a verdict whatever the probabilities say. */
class ConclusionTest {
  private static final Blocks BLOCKS = blocks(150);
  private static final double TIE_NATS = 3;
  private static final Hypothesis OFFSET = Worlds.effect(Effect.RANGE_OFFSET, "constant", 0.05);

  private static Blocks blocks(int rows) {
    return new Blocks(new PingLog(Worlds.poses(rows, 0.3, 1.3, 1)));
  }

  private static Weighed weighed(Hypothesis best, double gapM, double floorM, Scored... enlarging) {
    Scored only = new Scored(best, 0, 0);
    GapMeter.Gaps gaps = new GapMeter.Gaps(new double[] {gapM}, new double[] {floorM});
    return new Weighed(
        new Probabilities(List.of(only), 10, 2, Set.of()),
        only,
        new GapGain(gaps, gaps),
        List.of(enlarging));
  }

  private static Place place(double qValue) {
    return new Place(List.of(), 20, 0.58, 30, 30, GapKind.MISSED_ECHO, qValue);
  }

  private static Conclusion of(Weighed weighed, double unknown, Place... where) {
    return Conclusion.of(
        weighed, new Conclusion.Unnamed(unknown, Map.of(), ""), List.of(where), BLOCKS, TIE_NATS);
  }

  private static void isUndecided(String why, Conclusion conclusion) {
    assertEquals(Verdict.UNDECIDED, conclusion.verdict());
    assertTrue(conclusion.reason().contains(why), conclusion.reason());
  }

  @Test
  void smallGapWithoutAPlace_isNone() {
    Conclusion none = of(weighed(Hypothesis.NONE, 0.019, 0.01), 0.1, place(0.02));
    assertEquals(new Conclusion(Verdict.NONE, "", List.of()), none);
  }

  @Test
  void noneNeverStandsBesideAPlaceThatIsNoChance() {
    isUndecided(
        "one place of the log has 58 % of the gap, more than chance gives (q = 0.0004)",
        of(weighed(Hypothesis.NONE, 0.019, 0.01), 0.1, place(4e-4)));
  }

  /** A slice that holds all of the gap is no place. */
  @Test
  void noneNeverStandsBesideAGapThatIsLargerEverywhere() {
    Place some = place(4e-4);
    Place all =
        new Place(
            some.conditions(), 90, 1, some.beforeCm(), some.afterCm(), some.kind(), some.qValue());
    isUndecided(
        "but the gap is larger all over the log, more than chance gives (q = 0.0004)",
        of(weighed(Hypothesis.NONE, 0.019, 0.01), 0.1, all));
  }

  @Test
  void noneNeverStandsBesideAGapOfManyTimesTheFloor() {
    isUndecided(
        "the gap is 2.10 cm where the simulator expects 1.00 cm",
        of(weighed(Hypothesis.NONE, 0.021, 0.01), 0.1));
  }

  @Test
  void noneIsNotSaidWhereWhatIsLikelierEnlargesTheGap() {
    Scored enlarging = new Scored(OFFSET, 100, 100);
    isUndecided(
        "what makes these readings likelier (range-offset) makes the gap larger",
        of(weighed(Hypothesis.NONE, 0.01, 0.01, enlarging), 0.1));
  }

  @Test
  void whatMakesReadingsPlainlyLikelier_isNeitherNothingNorExplained() {
    Weighed.Unseen more = new Weighed.Unseen(Effect.CROSSTALK, 47.4);
    isUndecided(
        "off as by crosstalk (47 nats likelier with it)",
        of(weighed(Hypothesis.NONE, 0.01, 0.01), 0.1).beside(more));
    Conclusion named = of(weighed(OFFSET, 0.01, 0.01), 0.1).beside(more);
    assertEquals(Verdict.PARTLY, named.verdict());
    assertTrue(named.reason().contains("too many for chance"), named.reason());
    Conclusion unexplained = of(weighed(OFFSET, 0.01, 0.01), 0.9);
    assertEquals(unexplained, unexplained.beside(more));
  }

  @Test
  void oneBlock_isUndecidedWhateverFits() {
    Conclusion few =
        Conclusion.of(
            weighed(OFFSET, 0.01, 0.01),
            new Conclusion.Unnamed(0.9, Map.of(), ""),
            List.of(place(1e-9)),
            blocks(49),
            TIE_NATS);
    isUndecided("too few readings: 1, where 50 are needed", few);
  }

  @Test
  void whatIsNotKnown_decidesBetweenExplainedAndUnexplained() {
    assertEquals(Verdict.EXPLAINED, of(weighed(OFFSET, 0.01, 0.01), 0.2).verdict());
    isUndecided(
        "range-offset is likely (50 %), but not likely enough to be named (80 % is needed)",
        of(weighed(OFFSET, 0.01, 0.01), 0.5));
    assertEquals(Verdict.UNEXPLAINED, of(weighed(OFFSET, 0.01, 0.01), 0.51).verdict());
    assertEquals(Verdict.UNEXPLAINED, of(weighed(Hypothesis.NONE, 0.01, 0.01), 0.51).verdict());
  }

  @Test
  void withoutAnyEcho_nothingIsExplainedAndNothingCalledUnexplained() {
    String why = "no ping of this log has an echo";
    isUndecided(why, of(weighed(OFFSET, 0.01, 0.01), 0.1).ofSilence());
    isUndecided(why, of(weighed(OFFSET, 0.01, 0.01), 0.9).ofSilence());
    Conclusion nothing = of(weighed(Hypothesis.NONE, 0.01, 0.01), 0.1);
    assertEquals(nothing, nothing.ofSilence());
  }

  /** One of two effects is there as often as not: the other alone would be wrong as often. */
  @Test
  void whatIsHardlyLikely_isNotNamed() {
    Hypothesis gain = Worlds.effect(Effect.GAIN, "factor", 0.8);
    Hypothesis both = OFFSET.and(gain.forms().get(0), 0.8);
    isUndecided("gain is likely (", of(two(both, 13, OFFSET), 0.01));
    assertEquals(Verdict.EXPLAINED, of(two(both, 14, OFFSET), 0.01).verdict());
  }

  /** Either of two that do alike is named, with the other as its tie. */
  @Test
  void aTie_isAsLikelyAsBothOfIt() {
    Hypothesis gain = Worlds.effect(Effect.GAIN, "factor", 0.8);
    assertEquals(Verdict.EXPLAINED, of(two(OFFSET, 0.5, gain), 0.01).verdict());
  }

  private static Weighed two(Hypothesis best, double moreNats, Hypothesis other) {
    Scored first = new Scored(best, moreNats, moreNats);
    GapMeter.Gaps gaps = new GapMeter.Gaps(new double[] {0.01}, new double[] {0.01});
    return new Weighed(
        new Probabilities(List.of(first, new Scored(other, 0, 0)), 10, 2, Set.of()),
        first,
        new GapGain(gaps, gaps),
        List.of());
  }

  /** Twice what the model that is diagnosed expects of itself is a rest. */
  @Test
  void muchThatIsLeft_isNotExplained() {
    assertEquals(Verdict.EXPLAINED, of(weighed(OFFSET, 0.0199, 0.01), 0.1).verdict());
    Conclusion left = of(weighed(OFFSET, 0.021, 0.01), 0.1);
    assertEquals(Verdict.UNEXPLAINED, left.verdict());
    assertEquals(
        "a gap of 2.10 cm is left, but the diagnosed model expects only 1.00 cm from scatter",
        left.reason());
    assertEquals(
        Optional.of(new Conclusion(Verdict.PARTLY, left.reason(), List.of())),
        partly(left, weighed(OFFSET, 0.021, 0.01), 0.1));
  }

  private static Optional<Conclusion> partly(Conclusion whole, Weighed weighed, double unknown) {
    return whole.partly(
        Set.of(Effect.RANGE_OFFSET),
        weighed,
        new Conclusion.Unnamed(unknown, Map.of(), ""),
        TIE_NATS);
  }

  /** One in five is no "something else is too". */
  @Test
  void allOfTheSetIsSure_nothingIsKnownToStandBesideIt() {
    Weighed offset = weighed(OFFSET, 0.01, 0.01);
    Conclusion hardly = of(offset, 0.201);
    isUndecided("range-offset is likely (79 %), but not likely enough to be named", hardly);
    assertEquals(Optional.empty(), partly(hardly, offset, 0.201));
  }

  /** That the sure one is not sure would contradict the verdict. */
  @Test
  void whatIsNotSure_isSaidOfTheOthers() {
    Hypothesis both = OFFSET.and(Worlds.effect(Effect.GAIN, "factor", 0.8).forms().get(0), 0.8);
    Weighed weighed = weighed(both, 0.01, 0.01);
    Conclusion partly = partly(of(weighed, 0.3), weighed, 0.3).orElseThrow();
    assertEquals(Verdict.PARTLY, partly.verdict());
    assertEquals(
        "gain is likely (70 %), but not likely enough to be named (80 % is needed)",
        partly.reason());
  }

  @Test
  void valueAtTheEndOfTheSearch_explainsNothing() {
    Hypothesis far = Worlds.effect(Effect.RANGE_OFFSET, "constant", 1);
    Conclusion conclusion = of(weighed(far, 0.01, 0.01), 0.01);
    assertEquals(Verdict.UNEXPLAINED, conclusion.verdict());
    assertEquals("offset_m", conclusion.atBound().get(0).parameter());
    assertEquals(1, conclusion.atBound().get(0).allowed().high());
    assertTrue(
        conclusion
            .reason()
            .startsWith(
                "offset_m of range-offset is at the end of the range that was searched (1.000, "
                    + "from -1.000 to 1.000)"),
        conclusion.reason());
  }
}
