package simbad.blindworld.score;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simbad.blindworld.file.FormatException;
import simbad.blindworld.file.Seal;
import simbad.blindworld.world.Forecast;

/** Scores side by side, their parts by origin, and the statistics behind them. */
class ScoringTextTest {

  private static final double NEAR = 1e-12;

  private static Truth truth(String id, boolean reference, String... effects) {
    return new Truth(
        id,
        List.of(effects),
        effects.length > 0 && effects[0].startsWith("odd") ? Set.of(effects[0]) : Set.of(),
        reference,
        List.of(1.0),
        Optional.of(10.0),
        Optional.of(2.0));
  }

  private static Answer answer(Verdict verdict, double unknown, boolean predicts, String... names) {
    double[][] row = {Collections.nCopies(19, 1.03).stream().mapToDouble(x -> x).toArray()};
    return new Answer(
        verdict,
        List.of(names),
        java.util.Arrays.stream(names).map(n -> new Answer.Named(n, 0.9, List.of())).toList(),
        unknown,
        Optional.empty(),
        Optional.empty(),
        predicts ? Optional.of(new Forecast(row)) : Optional.empty());
  }

  private static Scoring scoring(Optional<Scoring.Origin> origin, Truth... truths) {
    Scoring scoring = new Scoring(List.of(truths), origin);
    scoring.add(
        "diagnosis",
        Map.of(
            "a", answer(Verdict.EXPLAINED, 0.1, true, "gain"),
            "b", answer(Verdict.EXPLAINED, 0.2, false, "latency")));
    scoring.add("oracle", Map.of("a", answer(Verdict.EXPLAINED, 0, false, "gain")));
    return scoring;
  }

  private static List<String> parts(Scoring scoring) {
    return new ArrayList<>(scoring.json().keySet());
  }

  @Test
  void parts_areByLevelAndOrigin() {
    Truth plain = truth("a", false, "gain");
    Truth off = truth("b", true);
    assertEquals(
        List.of(
            "all cases (L1 and L2)", "set-up as believed (L1)", "set-up off, with reference (L2)"),
        parts(scoring(Optional.empty(), plain, off)));
    assertEquals(List.of("set-up as believed (L1)"), parts(scoring(Optional.empty(), plain)));
    assertEquals(List.of("set-up off, with reference (L2)"), parts(scoring(Optional.empty(), off)));
    Optional<Scoring.Origin> motion = Optional.of(Scoring.Origin.MOTION);
    assertEquals(
        List.of(
            "worlds of motion (M1 and M2)",
            "robot as believed (M1)",
            "robot off, with reference (M2)"),
        parts(scoring(motion, plain, off)));
    assertEquals(
        List.of("worlds of waves (L2w)"),
        parts(scoring(Optional.of(Scoring.Origin.WAVE), plain, off)));
    assertEquals(
        List.of("foreign data sets (L3)"),
        parts(scoring(Optional.of(Scoring.Origin.foreign("L3")), plain, off)));
  }

  @Test
  void cases_haveTheirLevel() {
    Truth plain = truth("a", false, "gain");
    Truth off = truth("b", true);
    assertEquals("L1 L2", levels(Optional.empty(), plain, off));
    assertEquals("M1 M2", levels(Optional.of(Scoring.Origin.MOTION), plain, off));
    assertEquals("L2w L2w", levels(Optional.of(Scoring.Origin.WAVE), plain, off));
  }

  private static String levels(Optional<Scoring.Origin> origin, Truth... truths) {
    StringBuilder levels = new StringBuilder();
    for (Object line : scoring(origin, truths).casesJson("diagnosis")) {
      levels.append(((Map<?, ?>) line).get("level")).append(' ');
    }
    return levels.toString().strip();
  }

  /** Of two answers one comes with predictions; the other sort has one answer without. */
  @Test
  void predictions_areCountedOfAnswers() {
    Scoring scoring = scoring(Optional.empty(), truth("a", false, "gain"), truth("b", false));
    assertEquals(new Proportion(1, 2), scoring.predictions("diagnosis"));
    assertEquals(new Proportion(0, 1), scoring.predictions("oracle"));
    assertEquals(new Proportion(0, 0), scoring.predictions("nobody"));
  }

  private static String line(String text, String name) {
    return text.lines().filter(l -> l.strip().startsWith(name)).findFirst().orElse("");
  }

  /** A forecast that is 3 cm off on every row removes 7 of 10 cm, and the truth's removes 8. */
  @Test
  void table_hasAColumnForEachSort() {
    String text = scoring(Optional.empty(), truth("a", false, "gain"), truth("b", false)).text();
    assertTrue(text.startsWith("set-up as believed (L1)" + " ".repeat(19) + "diagnosis"), text);
    assertTrue(line(text, "set-up").contains("diagnosis" + " ".repeat(17) + "oracle"), text);
    assertEquals(
        "  answered" + " ".repeat(32) + "2/2 100% [34-100]" + " ".repeat(9) + "1/2 50% [9-91]",
        line(text, "answered").stripTrailing());
    assertTrue(line(text, "mean of the classes").contains("0.500"), text);
    assertTrue(line(text, "unknown AUROC").contains("0.500"), text);
    assertTrue(line(text, "share of the oracle's removal").contains("0.875 (n=1)"), text);
    assertTrue(line(text, "shrinkage claimed").stripTrailing().endsWith("-"), text);
    assertTrue(line(text, "verdict: ECE").contains("%"), text);
    assertTrue(line(text, "first effect: ECE").contains(", "), text);
    assertTrue(line(text, "probability of the truth").matches(".*0\\.[0-9]{3} .*"), text);
    assertTrue(text.contains("\nby effect, worst first (diagnosis)\n  gain"), text);
    String wrong = text.substring(text.indexOf("\nanswered wrongly\n"));
    assertTrue(wrong.contains("  b ") && wrong.contains("latency"), wrong);
    assertFalse(wrong.contains("  a "), wrong);
    assertTrue(text.lines().skip(1).findFirst().orElse("").startsWith("  answered"));
  }

  private static Ranking.Scored scored(double score, boolean right) {
    return new Ranking.Scored(score, right);
  }

  /** Hanley and McNeil 1982: 0.8 of 3 and 5 cases has a variance of 0.4978 / 15. */
  @Test
  void ranking_isByPairs() {
    assertEquals(Math.sqrt(0.49777777777777776 / 15), Ranking.standardError(0.8, 3, 5), 1e-9);
    assertEquals(0.5, Ranking.standardError(0.8, 0, 5));
    assertEquals(0.5, Ranking.standardError(0.8, 3, 0));
    List<Ranking.Scored> strange = List.of(scored(0.9, false), scored(0.5, false));
    List<Ranking.Scored> known = List.of(scored(0.5, true), scored(0.2, false), scored(0.95, true));
    // 0.9 beats two and 0.5 one and a half of six pairs; of those with right ones 1 and 0.5.
    assertEquals(3.5 / 6, Ranking.auroc(strange, known), NEAR);
    assertEquals(1.5 / 6, Ranking.openAuc(strange, known), NEAR);
    assertEquals(0.5, Ranking.auroc(List.of(), known));
    assertEquals(0.5, Ranking.auroc(strange, List.of()));
  }

  /** Of twenty known ones one may be above. */
  @Test
  void flagged_isAboveAShareOfTheKnown() {
    List<Ranking.Scored> known = new ArrayList<>();
    for (int i = 1; i <= 20; i++) {
      known.add(scored(i / 20.0, true));
    }
    List<Ranking.Scored> strange =
        List.of(scored(0.95, false), scored(0.96, false), scored(0.5, false));
    assertEquals(new Proportion(1, 3), Ranking.flaggedAt(strange, known, 0.05));
    assertEquals(new Proportion(2, 3), Ranking.flaggedAt(strange, known, 0.1));
    assertEquals(new Proportion(0, 3), Ranking.flaggedAt(strange, List.of(), 0.05));
  }

  /** Only a known one whose verdict and names are right counts where all have to be right. */
  @Test
  void openRanking_needsRightNames() {
    List<Graded> cases = new ArrayList<>();
    cases.add(new Graded(truth("a", false, "odd"), some(Verdict.UNEXPLAINED, 0.9)));
    cases.add(new Graded(truth("b", false, "gain"), some(Verdict.EXPLAINED, 0.1, "gain")));
    cases.add(new Graded(truth("c", false, "gain"), some(Verdict.EXPLAINED, 0.1, "latency")));
    cases.add(new Graded(truth("d", false, "gain"), some(Verdict.PARTLY, 0.1, "gain")));
    cases.add(new Graded(truth("e", false, "wrap"), some(Verdict.EXPLAINED, 0.1, "wrap")));
    assertEquals(1, new Scores(cases).auroc(), NEAR);
    String unknown = String.valueOf(new Scores(cases).json().get("unknown"));
    assertTrue(unknown.startsWith("{unknown_cases=1, known_cases=4, auroc=1.0,"), unknown);
    // Two of the four.
    assertTrue(unknown.contains("open_auc=0.5"), unknown);
  }

  private static Optional<Answer> some(Verdict verdict, double unknown, String... names) {
    return Optional.of(answer(verdict, unknown, false, names));
  }

  @Test
  void families_areOfOneVocabulary() {
    assertTrue(Names.isSameStage("gain", "absorption"));
    assertTrue(Names.isSameStage("slip", "motion-noise"));
    assertFalse(Names.isSameStage("gain", "slip"));
    assertFalse(Names.isSameStage("slip", "turn-bias"));
    assertFalse(Names.isSameStage("gain", "latency"));
    Graded family = new Graded(truth("a", false, "gain"), some(Verdict.EXPLAINED, 0, "absorption"));
    assertTrue(family.familyRight());
    assertFalse(
        new Graded(truth("a", false, "gain"), some(Verdict.EXPLAINED, 0, "wrap")).familyRight());
    assertFalse(new Graded(truth("a", false, "gain"), some(Verdict.NONE, 0)).familyRight());
  }

  /** Stated 0.9 four times and 0.2 once, of which three and none were so. */
  @Test
  void calibration_isInClosedForm() {
    List<Calibration.Claim> claims = new ArrayList<>();
    for (int i = 0; i < 4; i++) {
      claims.add(new Calibration.Claim(0.9, i > 0));
    }
    claims.add(new Calibration.Claim(0.2, false));
    // Each of five claims is a bin of its own.
    assertEquals((0.9 + 3 * 0.1 + 0.2) / 5, Calibration.expectedError(claims), NEAR);
    double said = -(3 * Math.log(0.9) + Math.log(0.1) + Math.log(0.8)) / 5;
    double base = -(3 * Math.log(0.6) + 2 * Math.log(0.4)) / 5;
    assertEquals(said, Calibration.logScore(claims), NEAR);
    assertEquals(base, Calibration.baseScore(claims), NEAR);
    assertEquals(1 - said / base, Calibration.findBetterBy(claims).orElseThrow(), NEAR);
    assertTrue(Calibration.findBetterBy(claims.subList(1, 4)).isEmpty(), "all of them were so");
    assertEquals(0, Calibration.expectedError(List.of()));
    assertEquals(-Math.log(1e-4), Calibration.loss(0), NEAR);
    assertEquals(0, Calibration.better(1, 0));
    assertEquals(5, Calibration.json(claims).get("n"));
    assertEquals(2.5, Spread.median(List.of(4.0, 1.0, 2.0, 3.0)));
    assertEquals(2, Spread.median(List.of(3.0, 1.0, 2.0)));
  }

  private static String hash(String text) {
    return Seal.sha256(text.getBytes(StandardCharsets.UTF_8));
  }

  private static Path write(Path folder, String name, String text) throws IOException {
    Path file = folder.resolve(name);
    Files.createDirectories(file.toAbsolutePath().getParent());
    return Files.writeString(file, text);
  }

  /** A foreign truth's files stand in the manifest, a truth of motion has them itself. */
  @Test
  void sealedFiles_areOfTheManifestOrTheTruth(@TempDir Path folder)
      throws IOException, FormatException {
    for (boolean foreign : new boolean[] {true, false}) {
      String files = "{\"x.csv\": \"%s\"}".formatted(hash("x"));
      String truth = foreign ? "{}" : "{\"sealed_files\": %s}".formatted(files);
      write(folder, "truth/c1/truth.json", truth);
      write(folder, "truth/c1/salt.txt", "41");
      write(folder, "truth/c1/x.csv", "x");
      String commitment = hash("A" + truth);
      Path manifest =
          write(
              folder,
              "manifest.json",
              "{\"root\": \"%s\", \"cases\": [{\"case\": \"c1\", \"commitment\": \"%s\"%s}]}"
                  .formatted(commitment, commitment, foreign ? ", \"sealed\": " + files : ""));
      Truths truths = new Truths(folder.resolve("truth"), Set.of());
      assertEquals(1, truths.verify(manifest));
      write(folder, "truth/c1/x.csv", "y");
      assertThrows(FormatException.class, () -> truths.verify(manifest));
    }
  }
}
