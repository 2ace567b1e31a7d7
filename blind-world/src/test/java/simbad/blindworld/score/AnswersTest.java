package simbad.blindworld.score;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.blindworld.file.FormatException;
import simbad.blindworld.file.Seal;
import simbad.blindworld.world.Forecast;

/** Answers and truths as files hold them. */
class AnswersTest {

  private static final double NEAR = 1e-12;
  private static final String HEADER = quantiles("q%02d");

  private static String quantiles(String format) {
    StringBuilder text = new StringBuilder();
    for (int q = 1; q <= Forecast.LEVELS; q++) {
      text.append(q == 1 ? "" : ",").append(format.formatted(5 * q));
    }
    return text.append('\n').toString();
  }

  private static String rising(double first) {
    StringBuilder text = new StringBuilder();
    for (int q = 0; q < Forecast.LEVELS; q++) {
      text.append(q == 0 ? "" : ",").append(first + q);
    }
    return text.append('\n').toString();
  }

  private static Truth truth(int rows) {
    return new Truth(
        "c1",
        List.of("gain"),
        Set.of(),
        false,
        java.util.Collections.nCopies(rows, 1.0),
        Optional.of(10.0),
        Optional.of(2.0));
  }

  private static Path write(Path folder, String name, String text) throws IOException {
    Path file = folder.resolve(name);
    Files.createDirectories(file.toAbsolutePath().getParent());
    return Files.writeString(file, text);
  }

  private static Answer answer(Path folder, String more) throws IOException, FormatException {
    write(
        folder,
        "c1/diagnosis.json",
        """
        {"verdict": "explained", "explanation": ["gain", "latency"],
         "effects": [{"name": "gain", "probability": 0.75,
          "indistinguishable_from": ["absorption"]}, {"name": "wrap", "probability": 0.5}],
         "unknown_probability": 0.125%s}
        """
            .formatted(more));
    Map<String, Answer> answers = new Answers(folder).read(List.of(truth(2), other()));
    assertEquals(Set.of("c1"), answers.keySet(), "cases without an answer are left out");
    return java.util.Objects.requireNonNull(answers.get("c1"));
  }

  private static Truth other() {
    return new Truth(
        "c2", List.of(), Set.of(), false, List.of(), Optional.empty(), Optional.empty());
  }

  @Test
  void answer_isRead(@TempDir Path folder) throws IOException, FormatException {
    Answer answer = answer(folder, "");
    assertEquals(Verdict.EXPLAINED, answer.verdict());
    assertEquals(List.of("gain", "latency"), answer.explanation());
    assertEquals(
        List.of(
            new Answer.Named("gain", 0.75, List.of("absorption")),
            new Answer.Named("wrap", 0.5, List.of())),
        answer.effects());
    assertEquals(0.125, answer.unknownProbability());
    assertEquals(Optional.empty(), answer.verdictProbability());
    assertEquals(Optional.empty(), answer.shrink());
    assertFalse(answer.predicts());
    assertEquals(Set.of("gain", "absorption", "latency"), answer.namedWithTies());
    assertEquals(0.5, answer.probabilityOf("wrap"));
    assertEquals(0, answer.probabilityOf("latency"));
    assertEquals(0.875 * 0.75, answer.probabilityOf(Verdict.EXPLAINED), NEAR);
    assertEquals(0.875 * 0.25, answer.probabilityOf(Verdict.NONE), NEAR);
  }

  @Test
  void statedProbabilities_goBeforeOthers(@TempDir Path folder)
      throws IOException, FormatException {
    Answer answer =
        answer(
            folder,
            ", \"verdict_probability\": {\"none\": 0.1, \"explained\": 0.7, \"unexplained\": 0.2}");
    assertEquals(0.1, answer.probabilityOf(Verdict.NONE));
    assertEquals(0.7, answer.probabilityOf(Verdict.EXPLAINED));
    assertEquals(0.2, answer.probabilityOf(Verdict.UNEXPLAINED));
    assertEquals(0.2, answer.probabilityOf(Verdict.PARTLY));
    assertEquals(0, answer.probabilityOf(Verdict.UNDECIDED));
  }

  /** Without an interval, or with one that is not known, the claim is its own interval. */
  @Test
  void shrinkage_mayHaveAnInterval(@TempDir Path folder) throws IOException, FormatException {
    assertEquals(
        Optional.of(new Answer.Shrink(0.7, 0.5, 0.9)),
        answer(folder, ", \"gap\": {\"shrink\": 0.7, \"shrink_ci95\": [0.5, 0.9]}").shrink());
    Optional<Answer.Shrink> alone = Optional.of(new Answer.Shrink(0.7, 0.7, 0.7));
    assertEquals(alone, answer(folder, ", \"gap\": {\"shrink\": 0.7}").shrink());
    assertEquals(
        alone, answer(folder, ", \"gap\": {\"shrink\": 0.7, \"shrink_ci95\": null}").shrink());
    assertEquals(
        alone,
        answer(folder, ", \"gap\": {\"shrink\": 0.7, \"shrink_ci95\": [null, null]}").shrink());
    assertEquals(Optional.empty(), answer(folder, ", \"gap\": {\"shrink\": null}").shrink());
    assertThrows(
        FormatException.class,
        () -> answer(folder, ", \"gap\": {\"shrink\": 0.7, \"shrink_ci95\": [0.5]}"));
  }

  @Test
  void predictions_areQuantilesOfEachRow(@TempDir Path folder) throws IOException, FormatException {
    write(folder, "c1/predictions.csv", HEADER + rising(1) + rising(2));
    Answer answer = answer(folder, "");
    assertTrue(answer.predicts());
    Forecast forecast = answer.forecast().orElseThrow();
    assertEquals(2, forecast.size());
    assertEquals(1, forecast.row(0)[0]);
    assertEquals(20, forecast.row(1)[18]);
  }

  @ParameterizedTest
  @ValueSource(strings = {"\"verdict\": \"maybe\"", "\"unknown_probability\": 2"})
  void brokenAnswer_isRefused(String field, @TempDir Path folder) throws IOException {
    write(
        folder,
        "c1/diagnosis.json",
        "{\"verdict\": \"none\", \"explanation\": [], \"effects\": [],"
            + " \"unknown_probability\": 0, "
            + field
            + "}");
    FormatException fault =
        assertThrows(FormatException.class, () -> new Answers(folder).read(List.of(truth(1))));
    assertTrue(fault.toString().contains(field.substring(1, 8)), fault.toString());
  }

  @Test
  void brokenPredictions_areRefused(@TempDir Path folder) throws IOException {
    Path falls = write(folder, "falls.csv", HEADER + rising(1) + rising(1).replace(",3.0", ",1.5"));
    FormatException fault = assertThrows(FormatException.class, () -> Answers.forecast(falls, 2));
    assertTrue(fault.toString().contains("line 3: quantiles that fall"), fault.toString());
    Path one = write(folder, "one.csv", HEADER + rising(1));
    assertThrows(FormatException.class, () -> Answers.forecast(one, 2));
    Path level = write(folder, "level.csv", HEADER + rising(1).replace(",3.0", ",2.0"));
    org.junit.jupiter.api.Assertions.assertDoesNotThrow(() -> Answers.forecast(level, 1));
  }

  @Test
  void hash_isOfDiagnosesAndPredictions(@TempDir Path folder) throws IOException, FormatException {
    write(folder, "b/diagnosis.json", "1");
    write(folder, "a/predictions.csv", "2");
    write(folder, "a/diagnosis.json", "3");
    write(folder, "a/other.txt", "4");
    List<String> leaves =
        List.of("3", "2", "1").stream()
            .map(t -> Seal.sha256(t.getBytes(StandardCharsets.US_ASCII)))
            .toList();
    String hash = new Answers(folder).hash();
    assertEquals(Seal.root(leaves), hash);
    write(folder, "b/diagnosis.json", "5");
    assertNotEquals(hash, new Answers(folder).hash());
    assertThrows(FormatException.class, () -> new Answers(folder.resolve("none")).hash());
  }

  private static List<Truth> truths(
      Path folder, String json, Set<String> withheld, Set<String> known)
      throws IOException, FormatException {
    write(folder, "c1/truth.json", json);
    write(folder, "c1/sealed.csv", "range_m\n1.5\n\n2\n\"\"\n");
    return new Truths(folder, withheld, known).read();
  }

  private static Truth truth(Path folder, String json) throws IOException, FormatException {
    return truths(folder, json, Set.of(), Set.of()).get(0);
  }

  @Test
  void truth_isRead(@TempDir Path folder) throws IOException, FormatException {
    Truth truth =
        truth(
            folder,
            """
            {"effects": {"gain": {}}, "no_echo_m": 4, "sealed_gap_nominal_cm": 12,
             "sealed_gap_oracle_m": 0.05, "accept": [["gain"], ["absorption", "odd"], ["wrap"]],
             "z": 7, "sizes": [1.5], "reference": true}
            """);
    assertEquals("c1", truth.id());
    assertEquals(List.of("gain"), truth.effects());
    assertEquals(Set.of(), truth.strange());
    assertTrue(truth.reference());
    assertEquals(List.of(1.5, 2.0, 4.0), truth.countedM());
    assertEquals(Optional.of(12.0), truth.nominalCm());
    assertEquals(Optional.of(5.0), truth.oracleCm());
    assertEquals(List.of(Set.of("gain"), Set.of("wrap")), truth.accept());
    assertEquals(Optional.of(7.0), truth.z());
    assertEquals(Optional.of(1.5), truth.size());
    assertEquals(Optional.empty(), truth.motion());
  }

  @Test
  void truth_mayHaveLittle(@TempDir Path folder) throws IOException, FormatException {
    Truth pair =
        truth(
            folder,
            "{\"effects\": {\"gain\": {}, \"wrap\": {}}, \"no_echo_m\": 4, \"sizes\": [1]}");
    assertEquals(List.of(Set.of("gain", "wrap")), pair.accept());
    assertEquals(Optional.empty(), pair.size());
    assertFalse(pair.reference());
    Truth odd = truth(folder, "{\"effects\": {\"odd\": {}}, \"no_echo_m\": 4}");
    assertEquals(Set.of("odd"), odd.strange());
    assertEquals(List.of(), odd.accept());
    write(folder, "c1/reference.csv", "");
    write(folder, "c1/scene.json", "{\"no_echo_m\": 9}");
    Truth foreign = truth(folder, "{\"effects\": {}, \"reference\": false}");
    assertTrue(foreign.reference());
    assertEquals(List.of(1.5, 2.0, 9.0), foreign.countedM());
    assertEquals("none", foreign.kind());
  }

  @Test
  void names_areWithheldOrKnownBesides(@TempDir Path folder) throws IOException, FormatException {
    String json = "{\"effects\": {\"gain\": {}, \"mine\": {}}, \"no_echo_m\": 4}";
    assertEquals(Set.of("mine"), truths(folder, json, Set.of(), Set.of()).get(0).strange());
    assertEquals(Set.of(), truths(folder, json, Set.of(), Set.of("mine")).get(0).strange());
    assertEquals(
        Set.of("gain"), truths(folder, json, Set.of("gain"), Set.of("mine")).get(0).strange());
    assertThrows(FormatException.class, () -> new Truths(folder.resolve("c1"), Set.of()).read());
    assertThrows(FormatException.class, () -> new Truths(folder.resolve("none"), Set.of()).read());
  }

  /** The true world knows its names, and that there is something without one. */
  @Test
  void oracle_saysWhatIsSo(@TempDir Path folder) throws IOException, FormatException {
    List<Truth> truths =
        truths(
            folder,
            "{\"effects\": {\"gain\": {}, \"odd\": {}}, \"no_echo_m\": 4}",
            Set.of(),
            Set.of());
    write(folder, "c1/oracle.csv", HEADER + rising(1) + rising(1) + rising(1));
    Map<String, Answer> oracle = new Truths(folder, Set.of()).oracle(truths);
    Answer answer = java.util.Objects.requireNonNull(oracle.get("c1"));
    assertEquals(Verdict.UNEXPLAINED, answer.verdict());
    assertEquals(List.of("gain"), answer.explanation());
    assertEquals(List.of(new Answer.Named("gain", 1, List.of())), answer.effects());
    assertEquals(1, answer.unknownProbability());
    assertEquals(3, answer.forecast().orElseThrow().size());
    List<Truth> known = truths(folder, "{\"effects\": {}, \"no_echo_m\": 4}", Set.of(), Set.of());
    Files.delete(folder.resolve("c1/oracle.csv"));
    Answer none =
        java.util.Objects.requireNonNull(new Truths(folder, Set.of()).oracle(known).get("c1"));
    assertEquals(Verdict.NONE, none.verdict());
    assertEquals(0, none.unknownProbability());
    assertEquals(Optional.empty(), none.forecast());
  }

  private static String hash(String text) {
    return Seal.sha256(text.getBytes(StandardCharsets.UTF_8));
  }

  /** Two bytes of salt before the truth; hashes of what is sealed beside it and of what is open. */
  private static Path sealed(Path folder) throws IOException {
    String truth =
        "{\"effects\": {}, \"sealed_sha256\": \"%s\", \"oracle_sha256\": \"%s\"}"
            .formatted(hash("sealed"), hash("oracle"));
    write(folder, "truth/c1/truth.json", truth);
    write(folder, "truth/c1/sealed.csv", "sealed");
    write(folder, "truth/c1/oracle.csv", "oracle");
    write(folder, "truth/c1/salt.txt", "4142\n");
    write(folder, "cases/c1/readings.csv", "open");
    write(folder, "rows/c1/rows.csv", "rows");
    String commitment = hash("AB" + truth);
    return write(
        folder,
        "manifest.json",
        """
        {"root": "%s", "cases": [{"case": "c1", "commitment": "%s", "rows_sha256": "%s",
         "rows": {"rows.csv": "%s"}, "files": {"readings.csv": "%s"}}]}
        """
            .formatted(commitment, commitment, hash("rows"), hash("rows"), hash("open")));
  }

  @Test
  void seal_holds(@TempDir Path folder) throws IOException, FormatException {
    Path manifest = sealed(folder);
    assertEquals(1, new Truths(folder.resolve("truth"), Set.of()).verify(manifest));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "truth/c1/truth.json",
        "truth/c1/sealed.csv",
        "truth/c1/oracle.csv",
        "cases/c1/readings.csv",
        "rows/c1/rows.csv",
      })
  void seal_isBrokenByAnyFile(String name, @TempDir Path folder) throws IOException {
    Path manifest = sealed(folder);
    Files.writeString(folder.resolve(name), Files.readString(folder.resolve(name)) + " ");
    FormatException fault =
        assertThrows(
            FormatException.class,
            () -> new Truths(folder.resolve("truth"), Set.of()).verify(manifest));
    assertTrue(fault.toString().contains("was committed to"), fault.toString());
  }

  @Test
  void seal_isOfTheSameCases(@TempDir Path folder) throws IOException {
    Path manifest = sealed(folder);
    Truths truths = new Truths(folder.resolve("truth"), Set.of());
    write(folder, "truth/c2/truth.json", "{}");
    assertThrows(FormatException.class, () -> truths.verify(manifest));
    Files.delete(folder.resolve("truth/c2/truth.json"));
    Files.delete(folder.resolve("truth/c1/truth.json"));
    assertThrows(FormatException.class, () -> truths.verify(manifest));
    String other = Files.readString(manifest).replaceFirst("\"root\": \"..", "\"root\": \"00");
    Path wrong = write(folder, "wrong.json", other);
    FormatException fault = assertThrows(FormatException.class, () -> truths.verify(wrong));
    assertTrue(fault.toString().contains("root"), fault.toString());
  }
}
