package simbad.blindworld.score;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.junit.jupiter.api.Test;
import simbad.blindworld.score.Calibration.Claim;
import simbad.blindworld.score.Ranking.Scored;
import simbad.blindworld.world.Forecast;

class ScoresTest {

  private static Truth truth(String... effects) {
    Set<String> strange = new HashSet<>();
    Arrays.stream(effects).filter(e -> e.startsWith("odd")).forEach(strange::add);
    return new Truth(
        "c",
        List.of(effects),
        strange,
        false,
        List.of(1.0, 1.0),
        Optional.of(10.0),
        Optional.of(2.0));
  }

  static Answer answer(Verdict verdict, double unknown, String... names) {
    List<Answer.Named> effects =
        Arrays.stream(names).map(n -> new Answer.Named(n, 0.9, List.of())).toList();
    return new Answer(
        verdict,
        List.of(names),
        effects,
        unknown,
        Optional.empty(),
        Optional.empty(),
        Optional.empty());
  }

  private static Answer tied(String name, String... ties) {
    return new Answer(
        Verdict.EXPLAINED,
        List.of(name),
        List.of(new Answer.Named(name, 0.5, List.of(ties))),
        0,
        Optional.empty(),
        Optional.empty(),
        Optional.empty());
  }

  private static Graded graded(Truth truth, Answer answer) {
    return new Graded(truth, Optional.of(answer));
  }

  /** Wilson 1927: 8 of 10 gives 0.490 to 0.943, 0 of 10 gives 0 to 0.278. */
  @Test
  void wilsonInterval_isThePublishedOne() {
    assertEquals(0.490, new Proportion(8, 10).low(), 5e-4);
    assertEquals(0.943, new Proportion(8, 10).high(), 5e-4);
    assertEquals(0, new Proportion(0, 10).low(), 1e-12);
    assertEquals(0.278, new Proportion(0, 10).high(), 5e-4);
    assertEquals(1, new Proportion(0, 0).high());
    assertEquals("-", new Proportion(0, 0).toString());
    assertThrows(IllegalArgumentException.class, () -> new Proportion(3, 2));
  }

  @Test
  void tieOfTwo_countsWhenItHoldsTheTruth() {
    assertTrue(graded(truth("gain"), tied("gain")).named());
    assertTrue(graded(truth("gain"), tied("absorption", "gain")).named());
    assertFalse(graded(truth("gain"), tied("absorption", "gain", "latency")).named());
    assertFalse(graded(truth("gain"), tied("absorption", "gain")).namedExactly());
    assertFalse(graded(truth("gain"), tied("absorption")).named());
  }

  @Test
  void pair_needsBothAndNoMore() {
    Truth pair = truth("gain", "latency");
    assertTrue(graded(pair, answer(Verdict.EXPLAINED, 0, "latency", "gain")).named());
    assertFalse(graded(pair, answer(Verdict.EXPLAINED, 0, "latency")).named());
    assertTrue(graded(pair, answer(Verdict.EXPLAINED, 0, "latency")).namedSome());
    assertFalse(graded(pair, answer(Verdict.EXPLAINED, 0, "latency", "gain", "dropout")).named());
    // One tie cannot stand for both.
    assertFalse(
        graded(
                pair,
                new Answer(
                    Verdict.EXPLAINED,
                    List.of("gain", "dropout"),
                    List.of(new Answer.Named("gain", 1, List.of("latency"))),
                    0,
                    Optional.empty(),
                    Optional.empty(),
                    Optional.empty()))
            .named());
  }

  @Test
  void rightVerdict_followsFromTheTruth() {
    assertEquals(Verdict.NONE, truth().verdict());
    assertEquals(Verdict.EXPLAINED, truth("gain").verdict());
    assertEquals(Verdict.UNEXPLAINED, truth("gain", "odd").verdict());
    assertTrue(graded(truth("odd"), answer(Verdict.UNEXPLAINED, 1)).verdictRight());
    assertFalse(new Graded(truth(), Optional.empty()).verdictRight());
    assertEquals("(no answer)", new Graded(truth(), Optional.empty()).said());
    assertEquals(
        "gain+latency", graded(truth(), answer(Verdict.EXPLAINED, 0, "latency", "gain")).said());
  }

  /** "Partly" is right where something without a name is at work: that is what it is sure of. */
  @Test
  void partly_isAsSureAsTheUnknown() {
    assertEquals(0.7, answer(Verdict.PARTLY, 0.7, "gain").probabilityOf(Verdict.PARTLY), 1e-12);
    assertEquals(0, answer(Verdict.UNDECIDED, 0.7).probabilityOf(Verdict.UNDECIDED));
  }

  @Test
  void shares_countTheirOwnKinds() {
    Scores scores =
        new Scores(
            List.of(
                graded(truth(), answer(Verdict.NONE, 0.1)),
                graded(truth(), answer(Verdict.EXPLAINED, 0.1, "gain")),
                graded(truth("gain"), answer(Verdict.EXPLAINED, 0.1, "gain")),
                graded(truth("gain"), answer(Verdict.UNEXPLAINED, 0.8, "gain")),
                graded(truth("gain"), answer(Verdict.NONE, 0.2)),
                graded(truth("gain", "latency"), answer(Verdict.EXPLAINED, 0.1, "gain")),
                graded(truth("odd"), answer(Verdict.UNEXPLAINED, 0.9)),
                new Graded(truth("odd"), Optional.empty())));
    Map<String, Proportion> shares = scores.shares();
    assertEquals(new Proportion(7, 8), shares.get("answered"));
    assertEquals(new Proportion(1, 2), shares.get("none called none"));
    assertEquals(new Proportion(1, 3), shares.get("singles named and explained"));
    assertEquals(new Proportion(2, 3), shares.get("singles detected"));
    assertEquals(new Proportion(2, 2), shares.get("singles named exactly, of detected"));
    assertEquals(new Proportion(0, 1), shares.get("pairs both found"));
    assertEquals(new Proportion(1, 1), shares.get("pairs at least one found"));
    assertEquals(new Proportion(1, 2), shares.get("unknown called unexplained"));
    assertEquals(new Proportion(4, 8), shares.get("all verdicts right"));
    // 0.9 beats all six known cases, the missing answer's 0.5 all but the 0.8.
    assertEquals(11 / 12.0, scores.auroc(), 1e-12);
    assertEquals(8, scores.json().get("cases"));
  }

  private static Truth accepting(Truth truth, List<Set<String>> accept) {
    return new Truth(
        truth.id(),
        truth.effects(),
        truth.strange(),
        true,
        truth.countedM(),
        truth.nominalCm(),
        truth.oracleCm(),
        accept,
        truth.z());
  }

  private static void checkStanding(
      Graded.Standing expected, Truth truth, Verdict verdict, String... names) {
    assertEquals(expected, graded(truth, answer(verdict, 0.5, names)).standing());
  }

  /** The format's table, row by row. */
  @Test
  void standing_isThatOfTheTable() {
    checkStanding(Graded.Standing.RIGHT, truth(), Verdict.NONE);
    checkStanding(Graded.Standing.CAUTIOUS, truth(), Verdict.UNDECIDED);
    checkStanding(Graded.Standing.WRONG, truth(), Verdict.UNEXPLAINED);
    checkStanding(Graded.Standing.WRONG, truth(), Verdict.PARTLY, "gain");
    checkStanding(Graded.Standing.RIGHT, truth("gain"), Verdict.EXPLAINED, "gain");
    checkStanding(Graded.Standing.CAUTIOUS, truth("gain"), Verdict.PARTLY, "gain");
    checkStanding(Graded.Standing.CAUTIOUS, truth("gain"), Verdict.UNEXPLAINED, "gain", "wrap");
    checkStanding(Graded.Standing.CAUTIOUS, truth("gain"), Verdict.UNDECIDED);
    checkStanding(Graded.Standing.WRONG, truth("gain"), Verdict.UNEXPLAINED);
    checkStanding(Graded.Standing.WRONG, truth("gain"), Verdict.EXPLAINED, "latency");
    checkStanding(Graded.Standing.WRONG, truth("gain"), Verdict.NONE);
    checkStanding(Graded.Standing.RIGHT, truth("odd"), Verdict.UNEXPLAINED);
    checkStanding(Graded.Standing.RIGHT, truth("odd"), Verdict.PARTLY, "gain");
    checkStanding(Graded.Standing.CAUTIOUS, truth("odd"), Verdict.UNDECIDED);
    checkStanding(Graded.Standing.WRONG, truth("odd"), Verdict.EXPLAINED, "gain");
    checkStanding(Graded.Standing.WRONG, truth("odd"), Verdict.NONE);
    checkStanding(Graded.Standing.RIGHT, truth("gain", "odd"), Verdict.PARTLY, "gain");
    checkStanding(Graded.Standing.CAUTIOUS, truth("gain", "odd"), Verdict.PARTLY, "wrap");
    checkStanding(Graded.Standing.RIGHT, truth("gain", "odd"), Verdict.UNEXPLAINED);
    assertEquals(Graded.Standing.WRONG, new Graded(truth(), Optional.empty()).standing());
  }

  /** What physics cannot tell apart may be called either way, and nothing else may. */
  @Test
  void acceptedNames_areRight() {
    Truth either = accepting(truth("gain"), List.of(Set.of("gain"), Set.of("absorption", "wrap")));
    checkStanding(Graded.Standing.RIGHT, either, Verdict.EXPLAINED, "wrap", "absorption");
    checkStanding(Graded.Standing.WRONG, either, Verdict.EXPLAINED, "absorption");
    checkStanding(Graded.Standing.CAUTIOUS, either, Verdict.PARTLY, "absorption", "wrap");
    Truth odd = accepting(truth("odd"), List.of(Set.of("gain")));
    checkStanding(Graded.Standing.RIGHT, odd, Verdict.EXPLAINED, "gain");
    checkStanding(Graded.Standing.RIGHT, odd, Verdict.UNEXPLAINED);
    checkStanding(Graded.Standing.WRONG, odd, Verdict.EXPLAINED, "latency");
    Graded called = graded(odd, answer(Verdict.EXPLAINED, 0, "gain"));
    assertFalse(called.wronglyExplained());
    assertTrue(called.right());
    assertTrue(graded(odd, answer(Verdict.EXPLAINED, 0, "latency")).wronglyExplained());
    assertTrue(either.mayBeCalled("absorption"));
    assertFalse(either.mayBeCalled("latency"));
  }

  @Test
  void standings_areCountedByKind() {
    Scores scores =
        new Scores(
            List.of(
                graded(truth(), answer(Verdict.NONE, 0.1)),
                graded(truth(), answer(Verdict.UNDECIDED, 0.5)),
                graded(truth("gain"), answer(Verdict.EXPLAINED, 0.1, "latency"))));
    assertEquals(
        Map.of("none", Map.of("right", 1, "cautious", 1), "single", Map.of("wrong", 1)),
        scores.json().get("standings"));
    assertEquals(new Proportion(1, 3), scores.shares().get("all right"));
    assertEquals(new Proportion(1, 3), scores.shares().get("all cautious"));
    assertEquals(new Proportion(1, 3), scores.shares().get("all wrong"));
    assertEquals(new Proportion(1, 3), scores.shares().get("all wrongly explained"));
  }

  private static Truth shown(Truth truth, double z) {
    return new Truth(
        truth.id(),
        truth.effects(),
        truth.strange(),
        false,
        truth.countedM(),
        truth.nominalCm(),
        truth.oracleCm(),
        truth.accept(),
        Optional.of(z));
  }

  /** The kinds have one weight each, however many cases they have; what hardly shows has none. */
  @Test
  void classMean_leavesOutWhatHardlyShows() {
    Scores scores =
        new Scores(
            List.of(
                graded(shown(truth(), 0), answer(Verdict.NONE, 0.1)),
                graded(shown(truth(), 0), answer(Verdict.NONE, 0.1)),
                graded(shown(truth(), 0), answer(Verdict.EXPLAINED, 0.1, "gain")),
                graded(shown(truth("gain"), 5), answer(Verdict.EXPLAINED, 0.1, "gain")),
                graded(shown(truth("odd"), 40), answer(Verdict.EXPLAINED, 0.1, "gain")),
                graded(shown(truth("gain"), 4.9), answer(Verdict.NONE, 0.1)),
                graded(shown(truth("odd"), 1), answer(Verdict.UNEXPLAINED, 0.1))));
    assertEquals((2 / 3.0 + 1 + 0) / 3, scores.classMean(), 1e-12);
    assertEquals(new Proportion(0, 1), scores.shares().get("outside called unexplained"));
    assertEquals(
        Map.of(
            "none", Map.of("right", 2, "wrong", 1),
            "single", Map.of("right", 1),
            "outside", Map.of("wrong", 1),
            "faint", Map.of("right", 1, "wrong", 1)),
        scores.json().get("standings"));
    String power = String.valueOf(scores.json().get("power"));
    assertTrue(power.startsWith("[{z_from=0.0, z_to=2.0, right={hits=1, of=1,"), power);
    assertTrue(power.contains("{z_from=2.0, z_to=5.0, right={hits=0, of=1,"), power);
    assertTrue(power.contains("{z_from=40.0, right={hits=0, of=1,"), power);
  }

  @Test
  void probabilityOfTruth_isThatOfAllThatIsSo() {
    assertEquals(
        0.9 * 0.1, graded(truth(), answer(Verdict.NONE, 0.1, "gain")).probabilityOfTruth(), 1e-12);
    assertEquals(0.7, graded(truth("odd"), answer(Verdict.NONE, 0.7)).probabilityOfTruth(), 1e-12);
    assertEquals(
        0.8 * 0.9,
        graded(truth("gain", "latency"), answer(Verdict.NONE, 0.2, "latency", "gain"))
            .probabilityOfTruth(),
        1e-12);
    assertEquals(
        0,
        graded(truth("gain", "latency"), answer(Verdict.NONE, 0.2, "gain")).probabilityOfTruth());
    assertEquals(0, new Graded(truth("gain"), Optional.empty()).probabilityOfTruth());
  }

  /** What the vocabulary holds but the diagnosis was not told of is a kind of its own. */
  @Test
  void withheld_isApartFromOutside() {
    Truth withheld =
        new Truth(
            "w",
            List.of("gain"),
            Set.of("gain"),
            false,
            List.of(1.0),
            Optional.empty(),
            Optional.empty());
    assertEquals("withheld", withheld.kind());
    assertEquals("outside", truth("odd").kind());
    Scores scores =
        new Scores(
            List.of(
                graded(withheld, answer(Verdict.UNEXPLAINED, 0.9)),
                graded(withheld, answer(Verdict.EXPLAINED, 0.2, "absorption")),
                graded(truth("odd"), answer(Verdict.NONE, 0.1)),
                graded(truth("gain"), answer(Verdict.EXPLAINED, 0.1, "gain")),
                graded(truth("gain"), answer(Verdict.EXPLAINED, 0.1, "latency")),
                new Graded(truth(), Optional.empty())));
    assertEquals(new Proportion(1, 2), scores.shares().get("withheld called unexplained"));
    assertEquals(new Proportion(0, 1), scores.shares().get("outside called unexplained"));
    assertEquals(new Proportion(1, 3), scores.shares().get("unknown called unexplained"));
    assertEquals(new Proportion(2, 2), scores.shares().get("singles called explained"));
    assertEquals(
        Map.of(
            "none", Map.of("no answer", 1),
            "outside", Map.of("none", 1),
            "single", Map.of("explained, named rightly", 1, "explained, named otherwise", 1),
            "withheld", Map.of("unexplained", 1, "explained, named otherwise", 1)),
        scores.json().get("kinds"));
  }

  @Test
  void caseLine_saysWhatWasSoAndSaid() {
    Graded named = graded(truth("gain"), answer(Verdict.EXPLAINED, 0.25, "gain"));
    Graded silent = new Graded(truth(), Optional.empty());
    List<Object> lines = CaseLines.json(List.of(named, silent), "L1", "L2");
    assertEquals(
        "{case=c, level=L1, kind=single, so=gain, said=gain, right=true, verdict=explained,"
            + " verdict_probability=0.675, unknown_probability=0.25, first_effect=gain,"
            + " first_probability=0.9}",
        lines.get(0).toString());
    assertEquals(
        "{case=c, level=L1, kind=none, so=none, said=(no answer), right=false}",
        lines.get(1).toString());
  }

  /**
   * The mean of 400 throws of a fair coin: half, give or take 1.96 standard errors of 0.025. The
   * bootstrap's own chance is a tenth of that.
   */
  @Test
  void bootstrapInterval_isThatOfTheMean() {
    List<Double> coins = new ArrayList<>();
    for (int i = 0; i < 400; i++) {
      coins.add((double) (i % 2));
    }
    List<Double> interval =
        Spread.interval95(
            coins, s -> s.stream().mapToDouble(Double::doubleValue).average().orElse(0));
    assertEquals(0.5 - 1.96 * 0.025, interval.get(0), 0.006);
    assertEquals(0.5 + 1.96 * 0.025, interval.get(1), 0.006);
    assertEquals(List.of(), Spread.interval95(List.<Double>of(), s -> 1));
  }

  @Test
  void ranking_isTheShareOfPairsInOrder() {
    List<Scored> strange = List.of(new Scored(0.9, true), new Scored(0.4, true));
    List<Scored> known = List.of(new Scored(0.4, true), new Scored(0.1, false));
    assertEquals((1 + 1 + 0.5 + 1) / 4, Ranking.auroc(strange, known), 1e-12);
    assertEquals((1 + 0.5) / 4, Ranking.openAuc(strange, known), 1e-12);
    assertEquals(0.5, Ranking.auroc(List.of(), known));
    assertEquals(new Proportion(1, 2), Ranking.flaggedAt(strange, known, 0.05));
    assertEquals(0, Ranking.standardError(1, 10, 10), 1e-12);
  }

  @Test
  void calibration_isZeroForSharesThatHold_andNotForOthers() {
    List<Claim> honest = new ArrayList<>();
    List<Claim> boastful = new ArrayList<>();
    for (int i = 0; i < 100; i++) {
      honest.add(new Claim(0.8, i % 5 != 0));
      boastful.add(new Claim(1, i % 5 != 0));
    }
    assertEquals(0, Calibration.expectedError(honest), 1e-9);
    assertEquals(0.2, Calibration.expectedError(boastful), 1e-9);
    assertEquals(Calibration.baseScore(honest), Calibration.logScore(honest), 1e-12);
    assertTrue(Calibration.logScore(boastful) > Calibration.logScore(honest));
    assertEquals(0, Calibration.expectedError(List.of()));
  }

  @Test
  void verdictProbabilities_areStatedOrFollow() {
    Answer follow = answer(Verdict.EXPLAINED, 0.2, "gain");
    assertEquals(0.2, follow.probabilityOf(Verdict.UNEXPLAINED), 1e-12);
    assertEquals(0.72, follow.probabilityOf(Verdict.EXPLAINED), 1e-12);
    assertEquals(0.08, follow.probabilityOf(Verdict.NONE), 1e-12);
    Answer stated =
        new Answer(
            Verdict.NONE,
            List.of(),
            List.of(),
            0.3,
            Optional.of(Map.of(Verdict.NONE, 0.7, Verdict.UNEXPLAINED, 0.3)),
            Optional.empty(),
            Optional.empty());
    assertEquals(0.7, stated.probabilityOf(Verdict.NONE));
    assertEquals(0, stated.probabilityOf(Verdict.EXPLAINED));
  }

  /**
   * A point forecast 4 cm off has a gap of 4 cm: of 10 cm nominal and 2 cm true, 6/8 are removed.
   */
  @Test
  void shrinkage_isComparedWithTheSealedRows() {
    double[] row = new double[Forecast.LEVELS];
    Arrays.fill(row, 1.04);
    Answer answer =
        new Answer(
            Verdict.EXPLAINED,
            List.of("gain"),
            List.of(new Answer.Named("gain", 1, List.of())),
            0,
            Optional.empty(),
            Optional.of(new Answer.Shrink(0.65, 0.55, 0.75)),
            Optional.of(new Forecast(new double[][] {row, row})));
    Graded graded = graded(truth("gain"), answer);
    assertEquals(4, graded.afterCm().orElseThrow(), 1e-9);
    assertEquals(0.6, graded.sealedShrink().orElseThrow(), 1e-9);
    assertEquals(0.75, graded.shareOfRemoval().orElseThrow(), 1e-9);
    Scores scores = new Scores(List.of(graded));
    assertEquals(5, scores.shrinkErrors().get(0), 1e-9);
    assertEquals(new Proportion(1, 1), scores.shares().get("shrinkage interval covers"));
  }

  /** Who always states the one verdict there is loses nothing: no figure says by how much more. */
  @Test
  void logScore_ofOneVerdict_isNotCompared() {
    Scores one = new Scores(List.of(graded(truth("gain"), answer(Verdict.EXPLAINED, 0, "gain"))));
    assertEquals(OptionalDouble.empty(), one.verdictBetterBy());
    assertFalse(one.json().containsKey("verdict_log_score_better_by"));
    assertTrue(
        new Table("all", Map.of("diagnosis", one))
            .text()
            .lines()
            .anyMatch(l -> l.matches(".*ECE, log score.*, -\\s*")));
    Scores two =
        new Scores(
            List.of(
                graded(truth("gain"), answer(Verdict.EXPLAINED, 0, "gain")),
                graded(truth(), answer(Verdict.NONE, 0))));
    assertTrue(two.verdictBetterBy().orElseThrow() > 0);
    assertTrue(two.json().containsKey("verdict_log_score_better_by_ci95"));
  }

  @Test
  void median_isTheMiddle() {
    assertEquals(2, Spread.median(List.of(3.0, 1.0, 2.0)));
    assertEquals(1.5, Spread.median(List.of(1.0, 2.0)));
    assertEquals(0, Spread.json(List.of()).get("n"));
    assertEquals(2.0, Spread.json(List.of(2.0, 2.0)).get("low95"));
  }

  @Test
  void effects_areListedWorstFirst() {
    List<Effects.Line> lines =
        Effects.lines(
            List.of(
                graded(truth("gain"), answer(Verdict.EXPLAINED, 0, "gain")),
                graded(truth("latency"), answer(Verdict.NONE, 0)),
                graded(truth("gain", "odd"), answer(Verdict.UNEXPLAINED, 1)),
                graded(truth(), answer(Verdict.NONE, 0))));
    assertEquals(
        List.of("latency", "(odd)", "gain"), lines.stream().map(Effects.Line::effect).toList());
  }
}
