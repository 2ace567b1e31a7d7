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
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Random;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simbad.gap.unexplained.Constants;
import simbad.gap.unexplained.ThresholdConstants;

class ConstantsFitTest {
  private static final Set<String> GAIN = Set.of("gain");

  /** A case of level waves whose truth is gain, with sets that are behind by some nats. */
  private static CheckedCase weighed(double gainBehind, double otherBehind) {
    return new CheckedCase(
        "c",
        true,
        Map.of("misfit", 0.0),
        List.of(
            new CheckedCase.Weighed(GAIN, gainBehind),
            new CheckedCase.Weighed(Set.of("absorption"), otherBehind)),
        Set.of(GAIN),
        false,
        true,
        GAIN);
  }

  private static CheckedCase signed(double misfit, boolean isUnknown) {
    return new CheckedCase(
        "c",
        false,
        Map.of("misfit", misfit),
        List.of(),
        Set.of(isUnknown ? Set.of("wind") : Set.of()),
        isUnknown,
        false,
        Set.of());
  }

  private static double weight(Constants constants, String name) {
    return Objects.requireNonNull(constants.threshold().weights().get(name), name);
  }

  @Test
  void noCases_leaveWhatWasKnown() {
    Constants former = Constants.own();
    Constants fitted = new ConstantsFit(former).of(List.of());
    assertEquals(weight(former, "base"), weight(fitted, "base"), 1e-3);
    assertEquals(former.threshold().most(), fitted.threshold().most(), 1e-3);
    former
        .threshold()
        .weights()
        .forEach((name, w) -> assertEquals(w, weight(fitted, name), 1e-3, name));
    assertEquals(former.threshold().temperature(), fitted.threshold().temperature(), 1e-3);
    assertEquals(former.threshold().namedRightly(), fitted.threshold().namedRightly(), 1e-12);
    assertEquals(former.level().namedRightly(), fitted.level().namedRightly(), 1e-12);
  }

  /** Drawn by base -2 and weight 1: two thousand cases outweigh what was believed before. */
  @Test
  void manyCases_bringTheirOwnWeights() {
    Random random = new Random(3);
    Map<String, Double> weights = new LinkedHashMap<>(Constants.own().threshold().weights());
    weights.put("misfit", 1.0);
    weights.put("base", -2.0);
    Constants truth =
        new Constants(
            new ThresholdConstants(0.005, 0.965, weights, 2, 0.985), Constants.own().level());
    List<CheckedCase> cases = new ArrayList<>();
    for (int i = 0; i < 2000; i++) {
      double misfit = 4 * random.nextDouble();
      boolean unknown = random.nextDouble() < truth.threshold().unknown(Map.of("misfit", misfit));
      cases.add(signed(misfit, unknown));
    }
    Constants fitted = new ConstantsFit(Constants.own()).of(cases);
    assertEquals(-2, weight(fitted, "base"), 0.3);
    assertEquals(1, weight(fitted, "misfit"), 0.15);
    double known = weight(Constants.own(), "stand_in");
    assertEquals(known, weight(fitted, "stand_in"), 0.01, "no case speaks of it");
    assertTrue(
        ConstantsFit.logScore(fitted.threshold(), cases)
            > ConstantsFit.logScore(Constants.own().threshold(), cases));
  }

  /** Gain wins by 6 nats and is wrong one time in five: nats that say too much are cooled. */
  @Test
  void wrongSetsThatSeemSure_heat() {
    List<CheckedCase> cases = new ArrayList<>();
    for (int i = 0; i < 4000; i++) {
      cases.add(i % 5 == 0 ? weighed(6, 0) : weighed(0, 6));
    }
    Constants fitted = new ConstantsFit(Constants.own()).of(cases);
    // A fifth is exp(-6 / T) of the rest: T = 6 / ln 4 = 4.3, and a little of what was believed.
    assertEquals(6 / Math.log(4), fitted.level().temperature(), 0.05);
    assertEquals(
        Constants.own().threshold().temperature(),
        fitted.threshold().temperature(),
        1e-3,
        "no case of that law");
  }

  /**
   * Drawn by odds alone: what has no name is as probable as the odds say, and misfits say nothing.
   */
  @Test
  void levelCases_bringTheirOwnWeights() {
    Random random = new Random(5);
    List<CheckedCase> cases = new ArrayList<>();
    for (int i = 0; i < 2000; i++) {
      double logOdds = 8 * random.nextDouble() - 4;
      boolean unknown = random.nextDouble() < 1 / (1 + Math.exp(1 - logOdds));
      cases.add(strange(6 * random.nextDouble(), Math.exp(logOdds), unknown));
    }
    Constants fitted = new ConstantsFit(Constants.own()).of(cases);
    assertEquals(1, levelWeight(fitted, "strangers_likelier"), 0.2);
    assertEquals(1, levelWeight(fitted, "strangers_less_likely"), 0.2);
    assertEquals(0, levelWeight(fitted, "misfit"), 0.15);
    assertEquals(-1, levelWeight(fitted, "base"), 0.5);
    assertEquals(
        weight(Constants.own(), "base"), weight(fitted, "base"), 1e-3, "no case of the other law");
    assertTrue(
        ConstantsFit.logScore(fitted.level(), cases)
            > ConstantsFit.logScore(Constants.own().level(), cases));
  }

  private static CheckedCase strange(double misfit, double odds, boolean isUnknown) {
    return new CheckedCase(
        "c",
        true,
        Map.of("misfit", misfit, "strangers_odds", odds),
        List.of(),
        Set.of(isUnknown ? Set.of("wind") : Set.of()),
        isUnknown,
        false,
        Set.of());
  }

  private static double levelWeight(Constants constants, String name) {
    return Objects.requireNonNull(constants.level().weights().get(name), name);
  }

  /** All signs speak for it, and in three of four there was something: no more is said. */
  @Test
  void theMost_isTheShareThatIsSo() {
    List<CheckedCase> cases = new ArrayList<>();
    for (int i = 0; i < 2000; i++) {
      cases.add(signed(12, i % 4 != 0));
    }
    Constants fitted = new ConstantsFit(Constants.own()).of(cases);
    assertEquals(0.75, fitted.threshold().unknown(Map.of("misfit", 12.0)), 0.02);
  }

  @Test
  void answersAndTruths_areRead(@TempDir Path check) throws IOException {
    write(
        check,
        "answers/c1/diagnosis.json",
        "{\"verdict\": \"explained\", \"explanation\": [\"gain\"], \"model\": \"level\","
            + " \"signs\": {\"misfit\": 0.5, \"strangers_odds\": 2},"
            + " \"tried\": [{\"effects\": [\"gain\"], \"behind_nats\": 0},"
            + " {\"effects\": [], \"behind_nats\": null}]}");
    write(
        check,
        "world/truth/c1/truth.json",
        "{\"effects\": {\"short-burst\": {}}, \"unknown\": [\"short-burst\"],"
            + " \"accept\": [[\"short-burst\"], [\"gain\"]]}");
    CheckedCase one = CheckedCase.read(check).get(0);
    assertEquals(Map.of("misfit", 0.5, "strangers_odds", 2.0), one.signs());
    assertEquals(1, one.tried().size(), "what was left out has no odds");
    assertTrue(one.hasNameless() && one.isNamedRightly() && !ConstantsFit.isUnknown(one));
    write(check, "answers/c1/diagnosis.json", "{}");
    IOException old = assertThrows(IOException.class, () -> CheckedCase.read(check));
    assertTrue(old.toString().contains("signs: not there"), old.toString());
  }

  /** Worlds of equations say it otherwise: the world's own word stands among the effects. */
  @Test
  void whatIsOutsideTheVocabulary_hasNoName(@TempDir Path check) throws IOException {
    write(
        check,
        "answers/c1/diagnosis.json",
        "{\"verdict\": \"unexplained\", \"explanation\": [\"dropout\"], \"model\": \"threshold\","
            + " \"signs\": {\"misfit\": 4}, \"tried\": []}");
    write(
        check,
        "world/truth/c1/truth.json",
        "{\"effects\": {\"one-gain\": {}}, \"outside_vocabulary\": [\"one-gain\"]}");
    CheckedCase one = CheckedCase.read(check).get(0);
    assertTrue(one.hasNameless() && ConstantsFit.isUnknown(one));
  }

  /**
   * What is written is read as constants again, says its origin, and leaves the other law alone.
   */
  @Test
  void program_writesConstantsWithTheirOrigin(@TempDir Path folder) throws IOException {
    Path check = folder.resolve("L1");
    for (int i = 0; i < 50; i++) {
      String name = "c" + i;
      write(
          check,
          "answers/" + name + "/diagnosis.json",
          "{\"verdict\": \"none\", \"explanation\": [], \"model\": \"threshold\","
              + " \"signs\": {\"misfit\": 0}, \"tried\": []}");
      write(check, "world/truth/" + name + "/truth.json", "{\"effects\": {}}");
    }
    write(check, "order.json", "{\"seed\": 7}");
    Path out = folder.resolve("constants.json");
    FitConstants.main(new String[] {out.toString(), "2026-11-25", check.toString()});
    JsonNode root = new ObjectMapper().readTree(Files.readString(out));
    JsonNode origin = root.at("/threshold/origin");
    assertEquals("2026-11-25", origin.at("/date").asText());
    assertEquals(7, origin.at("/checks/0/order/seed").asInt());
    assertEquals(50, origin.at("/checks/0/cases").asInt());
    double score = origin.at("/unknown_held_out/former/mean_log_score").asDouble();
    assertEquals(Math.log(1 - Constants.own().threshold().unknown(Map.of())), score, 1e-5);
    Constants read = Constants.of(root);
    assertEquals(
        Constants.own().threshold().weights().keySet(), read.threshold().weights().keySet());
    assertEquals(Constants.own().level(), read.level(), "no case of it");
    assertTrue(root.at("/level/origin/date").isTextual());
    assertThrows(IllegalArgumentException.class, () -> FitConstants.main(new String[] {"x"}));
  }

  @Test
  void missingNumber_isNamed() throws IOException {
    JsonNode root = new ObjectMapper().readTree("{\"format\": \"simbad-constants/2\"}");
    IllegalArgumentException wrong =
        assertThrows(IllegalArgumentException.class, () -> Constants.of(root));
    assertTrue(wrong.toString().contains("least: "), wrong.toString());
  }

  private static void write(Path folder, String name, String text) throws IOException {
    Path file = folder.resolve(name);
    Files.createDirectories(file.getParent());
    Files.writeString(file, text);
  }
}
