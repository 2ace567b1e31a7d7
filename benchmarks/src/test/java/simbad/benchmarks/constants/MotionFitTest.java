package simbad.benchmarks.constants;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simbad.gap.diagnosis.Verdict;
import simbad.gap.motion.MotionConstants;

class MotionFitTest {
  private static final ObjectMapper MAPPER = new ObjectMapper();

  private static final MotionConstants TRUTH =
      new MotionConstants(
          Map.of("base", 2.0, "named", -5.0, "stranger", -0.5),
          Map.of("base", 1.0, "stranger", 1.0, "left_beside", 4.0, "named", -1.0),
          Map.of("base", 1.0, "stranger", -0.3, "worth", 1.5, "scatters", -1.0),
          0.4);

  private static CheckedDrive drawn(Random random) {
    boolean isNamed = random.nextBoolean();
    double stranger = 8 * random.nextDouble() - 4;
    double left = random.nextDouble();
    Map<String, Double> signs =
        new HashMap<>(
            Map.of(
                "named", isNamed ? 1.0 : 0.0,
                "stranger", stranger,
                "stranger_beside", isNamed ? stranger : 0.0,
                "left_beside", isNamed ? left : 0.0,
                "left_alone", isNamed ? 0.0 : left));
    String effect = random.nextBoolean() ? "turn-bias" : "slip";
    if (effect.equals("turn-bias")) {
      signs.put("worth_turn-bias", 6 * random.nextDouble() - 3);
    }
    double at = random.nextDouble() - TRUTH.verdict(Verdict.NONE, signs);
    Verdict truth = Verdict.NONE;
    if (at > 0) {
      boolean isExplained = at < TRUTH.verdict(Verdict.EXPLAINED, signs);
      truth = isExplained ? Verdict.EXPLAINED : Verdict.UNEXPLAINED;
    }
    Map<String, Boolean> names =
        isNamed
            ? Map.of(effect, random.nextDouble() < TRUTH.namedRightly(signs, effect))
            : Map.of();
    return new CheckedDrive(
        "c",
        signs,
        isNamed ? Verdict.EXPLAINED : Verdict.NONE,
        truth,
        names,
        OptionalDouble.of(random.nextDouble()));
  }

  /** Probabilities come back that two thousand cases were drawn by. */
  @Test
  void manyCases_bringBackTheirProbabilities() {
    Random random = new Random(5);
    List<CheckedDrive> cases = new ArrayList<>();
    for (int i = 0; i < 2000; i++) {
      cases.add(drawn(random));
    }
    MotionConstants fitted = MotionFit.of(cases);
    assertEquals(0.95, fitted.otherDrive(), 0.01);
    for (CheckedDrive one : cases.subList(0, 200)) {
      for (Verdict verdict : Verdict.TRUTHS) {
        assertEquals(
            TRUTH.verdict(verdict, one.signs()), fitted.verdict(verdict, one.signs()), 0.12);
      }
      for (String effect : one.names().keySet()) {
        double rightly = TRUTH.namedRightly(one.signs(), effect);
        assertEquals(rightly, fitted.namedRightly(one.signs(), effect), 0.08);
      }
    }
    double score = MotionFit.verdictScore(fitted, cases);
    assertTrue(score >= MotionFit.verdictScore(TRUTH, cases) - 3, "score " + score);
  }

  private static JsonNode json(String text) throws IOException {
    return MAPPER.readTree(text.replace('\'', '"'));
  }

  private static final String SAID =
      "{'verdict': 'explained', 'explanation': ['speed-scale', 'slip'],"
          + " 'effects': [{'name': 'speed-scale', 'indistinguishable_from': ['wheel-scale']},"
          + " {'name': 'slip'}, {'name': 'turn-bias'}],"
          + " 'gap': {'after': 0.5, 'shrink_of_this_log_ci95': [0.45, 0.55]},"
          + " 'signs': {'named': 1, 'worth_turn-bias': -2, 'worth_speed-scale': 2}}";

  @Test
  void aCase_isReadWithWhatWouldHaveBeenRight() throws IOException {
    JsonNode truth = json("{'effects': {'wheel-scale': {}}, 'sealed_gap_oracle': 0.4}");
    CheckedDrive one = CheckedDrive.of(new AnsweredCase("c", json(SAID), truth), 0.25);
    assertEquals(Verdict.EXPLAINED, one.truth());
    assertEquals(Map.of("speed-scale", true, "slip", false, "turn-bias", false), one.names());
    // Left over is 0.75 where 0.5 was said, give or take a tenth of it.
    double apart = Math.log(1.5);
    assertEquals(Math.sqrt(apart * apart - 0.01), one.otherDrive().orElseThrow(), 1e-9);
  }

  @Test
  void whatHasNoName_mayBeCalledByNames() throws IOException {
    JsonNode strange = json("{'effects': {}, 'outside_vocabulary': ['slope']}");
    assertEquals(
        Verdict.UNEXPLAINED,
        CheckedDrive.of(new AnsweredCase("c", json(SAID), strange), 0.2).truth());
    JsonNode called =
        json(
            "{'effects': {}, 'outside_vocabulary': ['slope'], 'sealed_gap_oracle': 1,"
                + " 'accept': [['slip', 'speed-scale']]}");
    CheckedDrive one = CheckedDrive.of(new AnsweredCase("c", json(SAID), called), 0.2);
    assertEquals(Verdict.EXPLAINED, one.truth());
    assertEquals(Map.of("speed-scale", true, "slip", true, "turn-bias", false), one.names());
    assertTrue(one.otherDrive().isEmpty());
    assertEquals(
        Verdict.NONE,
        CheckedDrive.of(new AnsweredCase("c", json(SAID), json("{'effects': {}}")), 0).truth());
  }

  @Test
  void aCheck_isFittedAndWritten(@TempDir Path folder) throws IOException {
    Path check = folder.resolve("motion");
    for (int i = 0; i < 20; i++) {
      Path answer = Files.createDirectories(check.resolve("answers/c" + i));
      Path truth = Files.createDirectories(check.resolve("world/truth/c" + i));
      Files.writeString(answer.resolve("diagnosis.json"), SAID.replace('\'', '"'));
      Files.writeString(
          truth.resolve("truth.json"),
          "{'effects': {'wheel-scale': {}}, 'sealed_gap_oracle': 0.4}".replace('\'', '"'));
    }
    Files.writeString(check.resolve("order.json"), "{\"practice\": 7}");
    String sealed =
        IntStream.range(0, 20).mapToObj(i -> "c" + i + ",0.5,0.25\n").collect(Collectors.joining());
    Files.writeString(
        check.resolve("cases.csv"), "case,shrink_claimed,shrink_sealed\nnone,0.5,\n" + sealed);
    Path out = folder.resolve("constants.json");
    FitMotion.main(new String[] {out.toString(), "2026-01-02", check.toString()});
    JsonNode root = MAPPER.readTree(Files.readString(out));
    assertEquals(20, root.at("/origin/checks/0/cases").asInt());
    assertEquals(7, root.at("/origin/checks/0/order/practice").asInt());
    MotionConstants fitted = MotionConstants.of(root);
    assertTrue(fitted.verdict(Verdict.EXPLAINED, Map.of("named", 1.0)) > 0.8);
    Map<String, Double> signs = Map.of("named", 1.0, "worth_turn-bias", -2.0);
    assertTrue(fitted.namedRightly(signs, "turn-bias") < 0.2);
  }

  @Test
  void anAnswerWithoutSigns_isRefused(@TempDir Path folder) throws IOException {
    Path answer = Files.createDirectories(folder.resolve("answers/c"));
    Files.writeString(answer.resolve("diagnosis.json"), "{}");
    Files.writeString(folder.resolve("cases.csv"), "case,shrink_sealed\n");
    String message =
        Objects.toString(
            assertThrows(IOException.class, () -> CheckedDrive.read(folder)).getMessage());
    assertTrue(message.contains("signs"), message);
  }

  /** Of ten bins of one case each. */
  @Test
  void calibrationError_isTheMeanOverBins() {
    double[] said = {0.05, 0.15, 0.25, 0.35, 0.45, 0.55, 0.65, 0.75, 0.85, 0.95};
    boolean[] happened = {false, false, false, false, false, true, true, true, true, true};
    assertEquals(0.25, CalibrationError.of(said, happened), 1e-12);
    assertEquals(0, CalibrationError.of(new double[0], new boolean[0]), 0);
  }
}
