package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.ReadingRow;

/** Diagnose and predict from the command line, on small data. */
class DiagnoseCommandTest {
  private static final int ROWS = 240;

  @TempDir
  @SuppressWarnings("NullAway.Init")
  private Path folder;

  private Path out = Path.of("");

  @BeforeEach
  void nameOut() {
    out = folder.resolve("out");
  }

  private Path data(String name, double offsetM) throws IOException {
    return BenchData.write(folder.resolve(name), BenchData.rows(ROWS, offsetM));
  }

  private Shell diagnose(Object... arguments) {
    List<String> all = new ArrayList<>(List.of("diagnose", "--out", out.toString()));
    Stream.of(arguments).map(Object::toString).forEach(all::add);
    return Shell.simbad(all.toArray(String[]::new));
  }

  private static List<String> names(Path root) throws IOException {
    try (Stream<Path> entries = Files.walk(root)) {
      return entries.skip(1).map(p -> root.relativize(p).toString()).sorted().toList();
    }
  }

  private JsonNode diagnosis(String name) throws IOException {
    return new ObjectMapper().readTree(out.resolve(name).resolve("diagnosis.json").toFile());
  }

  /** Two echoes of five are lost: with that in the scene the same readings have no gap. */
  @Test
  void correctedScene_hasWhatWasNamed() throws IOException {
    SplittableRandom random = new SplittableRandom(11);
    List<ReadingRow> rows =
        BenchData.rows(ROWS, 0).stream()
            .map(row -> random.nextDouble() < 0.4 ? silent(row) : row)
            .toList();
    Path bench = BenchData.write(folder.resolve("lossy"), rows);
    Path corrected = folder.resolve("corrected.json");
    Shell shell = diagnose(bench, "--corrected", corrected);
    assertEquals(0, shell.status(), shell.err());
    assertTrue(shell.out().contains(corrected + ": corrected for dropout"), shell.out());
    double missed =
        new ObjectMapper().readTree(corrected.toFile()).at("/sensor/miss_rate").asDouble();
    assertEquals(0.4, missed, 0.1);
    Path mended = BenchData.write(folder.resolve("mended"), rows);
    Files.copy(corrected, mended.resolve("scene.json"), StandardCopyOption.REPLACE_EXISTING);
    assertTrue(diagnose(mended).out().startsWith("mended: none"), shell.out());
  }

  private static ReadingRow silent(ReadingRow row) {
    return new ReadingRow(row.run(), row.sensor(), row.timeS(), row.pose(), NoEcho.NO_ECHO);
  }

  @Test
  void whatNoSceneSays_isSaid() throws IOException {
    Path corrected = folder.resolve("corrected.json");
    Shell shell = diagnose(data("bench", 0.05), "--corrected", corrected);
    assertEquals(0, shell.status(), shell.err());
    assertTrue(shell.out().contains(corrected + ": the scene, unchanged"), shell.out());
    assertTrue(shell.out().contains("a scene has no field for range-offset"), shell.out());
  }

  @Test
  void correctedOfTwo_isRefused() throws IOException {
    Shell shell = diagnose(data("a", 0), data("b", 0), "--corrected", folder.resolve("c.json"));
    assertEquals(2, shell.status());
    assertTrue(shell.err().contains("--corrected: the scene of one data set"), shell.err());
  }

  @Test
  void offset_isNamedAndPredicted() throws IOException {
    Path bench = data("bench", 0.05);
    Shell shell = diagnose(bench, "--seed", 7);
    assertEquals(0, shell.status(), shell.err());
    assertEquals("", shell.err());
    assertTrue(shell.out().startsWith("bench: explained, range-offset"), shell.out());
    Path report = out.resolve("bench/report.html");
    assertTrue(shell.out().endsWith("\nreport: " + report + "\n"), shell.out());
    List<String> files = new ArrayList<>(names(out.resolve("bench")));
    files.remove("next-experiment.csv"); // Only where there is a tie.
    assertEquals(List.of("diagnosis.json", "model.json", "report.html", "scene.json"), files);
    assertArrayEquals(
        Files.readAllBytes(bench.resolve("scene.json")),
        Files.readAllBytes(out.resolve("bench/scene.json")));
    JsonNode json = diagnosis("bench");
    assertEquals("range-offset", json.at("/explanation/0").asText());
    assertEquals(0.05, json.at("/effects/0/parameters/offset_m").asDouble(), 0.003);
    assertEquals(7, json.at("/provenance/seed").asInt());
    assertEquals(ROWS, json.at("/provenance/rows/readings").asInt());
    assertEquals(33, json.at("/effects").size());
    checkPredictions(bench.resolve("readings.csv"));
  }

  /**
   * Nominal medians lie 5 cm below the readings, diagnosed ones on them; the rows' order is kept.
   */
  private void checkPredictions(Path rows) throws IOException {
    List<String> forward = predict(rows, "diagnosed");
    List<String> nominal = predict(rows, "nominal");
    assertEquals(
        "q05,q10,q15,q20,q25,q30,q35,q40,q45,q50,q55,q60,q65,q70,q75,q80,q85,q90,q95",
        forward.get(0));
    assertEquals(ROWS + 1, forward.size());
    List<String> lines = Files.readAllLines(rows);
    double diagnosedCm = meanError(lines, forward);
    double nominalCm = meanError(lines, nominal);
    assertEquals(5, nominalCm - diagnosedCm, 0.5);
    List<String> backward = new ArrayList<>(lines.subList(1, lines.size()));
    Collections.reverse(backward);
    backward.add(0, lines.get(0));
    List<String> reversed = predict(Files.write(folder.resolve("back.csv"), backward), "diagnosed");
    Collections.reverse(reversed.subList(1, reversed.size()));
    assertEquals(forward, reversed);
  }

  private List<String> predict(Path rows, String model) throws IOException {
    Path file = folder.resolve(model + rows.getFileName());
    Shell shell =
        Shell.simbad(
            "predict",
            out.resolve("bench").toString(),
            rows.toString(),
            "--out",
            file.toString(),
            "--model",
            model);
    assertEquals(0, shell.status(), shell.err());
    return new ArrayList<>(Files.readAllLines(file));
  }

  /** Mean of reading less median over the echoes, centimetres. */
  private static double meanError(List<String> rows, List<String> predictions) {
    double sum = 0;
    int echoes = 0;
    for (int i = 1; i < rows.size(); i++) {
      String range = rows.get(i).split(",", -1)[6];
      double median = Double.parseDouble(predictions.get(i).split(",", -1)[9]);
      if (!range.isEmpty() && median < 6) {
        sum += 100 * (Double.parseDouble(range) - median);
        echoes++;
      }
    }
    return sum / echoes;
  }

  /** Where names hash otherwise, as they do in every other process. */
  @Test
  void otherHashes_sameBytes() throws IOException, InterruptedException {
    Path bench = data("bench", 0.05);
    byte[] first = diagnosedWith("first", "-XX:hashCode=2", bench);
    byte[] second = diagnosedWith("second", "-XX:hashCode=3", bench);
    assertArrayEquals(first, second);
  }

  private byte[] diagnosedWith(String name, String hashing, Path bench)
      throws IOException, InterruptedException {
    Path result = folder.resolve(name);
    List<String> command =
        new ArrayList<>(
            SimbadProcess.command("diagnose", "--out", result.toString(), bench.toString()));
    command.addAll(1, List.of("-XX:+UnlockExperimentalVMOptions", hashing));
    SimbadProcess diagnose = SimbadProcess.start(folder, "", command);
    assertEquals(0, diagnose.process().waitFor(), () -> command.toString());
    return Files.readAllBytes(result.resolve("bench/diagnosis.json"));
  }

  @Test
  void nothing_isCalledNothing_andWithheldIsNotNamed() throws IOException {
    Path none = data("none", 0);
    Path offset = data("offset", 0.05);
    Shell shell = diagnose(none, offset, "--withhold", "range-offset", "--json");
    assertEquals(0, shell.status(), shell.err());
    List<String> lines = shell.out().lines().toList();
    assertEquals(2, lines.size());
    JsonNode first = new ObjectMapper().readTree(lines.get(0));
    assertEquals("none", first.get("dataset").asText());
    assertEquals("none", first.get("verdict").asText(), lines.get(0));
    assertEquals(out.resolve("none").toString(), first.get("folder").asText());
    JsonNode withheld = diagnosis("offset").at("/explanation");
    withheld.forEach(word -> assertFalse(word.asText().equals("range-offset")));
  }

  /** However large the gap is: with nothing to test on, neither "none" nor a name is said. */
  @Test
  void tooFewRows_areUndecided_andEveryOutputSaysWhy() throws IOException {
    Path few = BenchData.write(folder.resolve("few"), BenchData.rows(20, 0.5));
    String why = "there are too few readings: 20, where 50 are needed";
    Shell shell = diagnose(few);
    assertEquals(0, shell.status(), shell.err());
    assertTrue(shell.out().startsWith("few: undecided; " + why), shell.out());
    JsonNode json = diagnosis("few");
    assertEquals("undecided", json.at("/verdict").asText());
    assertTrue(json.at("/reason").asText().startsWith(why), json.at("/reason").asText());
    assertTrue(json.at("/gap/shrink_ci95/0").isNull(), "nothing is known of another log");
    String page = Files.readString(out.resolve("few/report.html"));
    assertTrue(page.contains("<strong>These data cannot tell:</strong> " + why));
    Path again = folder.resolve("again");
    Shell script = Shell.simbad("diagnose", few.toString(), "--json", "--out", again.toString());
    JsonNode line = new ObjectMapper().readTree(script.out());
    assertEquals("undecided", line.get("verdict").asText());
    assertEquals(json.get("reason"), line.get("reason"));
  }

  /** Bad data sets say why, the others are diagnosed; what is there already is not touched. */
  @Test
  void oneIsBad_othersAreDone() throws IOException {
    Path good = data("good", 0);
    Path bad = data("bad", 0);
    List<String> lines = new ArrayList<>(Files.readAllLines(bad.resolve("readings.csv")));
    lines.set(4, lines.get(4).replaceFirst("^([^,]*,[^,]*),[^,]*", "$1,soon"));
    Files.write(bad.resolve("readings.csv"), lines);
    Path there = data("there", 0);
    Files.createDirectories(out.resolve("there"));
    Files.writeString(out.resolve("there/theirs"), "kept");
    Shell shell = diagnose(bad, folder.resolve("nowhere"), there, good);
    assertEquals(2, shell.status());
    assertEquals(
        List.of(
            "simbad diagnose: " + bad + "/readings.csv:5: t_s: 'soon' is not a finite number",
            "simbad diagnose: DATASET: " + folder.resolve("nowhere") + ": no such folder",
            "simbad diagnose: --out: " + out.resolve("there") + ": exists already"),
        shell.complaints().stream().map(line -> line.replaceFirst(" of at most.*", "")).toList());
    assertTrue(shell.out().startsWith("good: none"), shell.out());
    assertEquals(
        List.of("good", "there"), names(out).stream().filter(n -> !n.contains("/")).toList());
    assertEquals(List.of("theirs"), names(out.resolve("there")));
  }

  @Test
  void sameSeed_sameBytes() throws IOException {
    Path bench = data("bench", 0.05);
    assertEquals(0, diagnose(bench).status());
    Path first = out;
    out = folder.resolve("again");
    assertEquals(0, diagnose(bench, data("other", 0)).status());
    for (String file : names(first)) {
      if (!Files.isDirectory(first.resolve(file))) {
        assertArrayEquals(
            Files.readAllBytes(first.resolve(file)), Files.readAllBytes(out.resolve(file)), file);
      }
    }
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "diagnose",
        "diagnose DATA",
        "diagnose --out OUT",
        "diagnose DATA --out OUT --seed many",
        "diagnose DATA --out OUT --withhold ghosts",
        "diagnose DATA DATA --out OUT",
        "diagnose DATA --out DATA/scene.json",
        "predict DATA",
        "predict DATA DATA/readings.csv",
        "predict DATA DATA/readings.csv --out OUT --model best",
        "predict DATA DATA/readings.csv --out DATA/scene.json",
        "predict DATA DATA/readings.csv --out OUT",
        "predict OUT DATA/readings.csv --out OUT/p.csv",
        "predict DATA DATA/nothing.csv --out OUT --model nominal"
      })
  void badUsage_isSaidInOneLine(String line) throws IOException {
    String data = BenchData.write(folder.resolve("d"), BenchData.rows(3, 0)).toString();
    String[] words = line.replace("DATA", data).replace("OUT", out.toString()).split(" ");
    Shell shell = Shell.simbad(words);
    assertEquals(2, shell.status(), shell.err());
    assertEquals(1, shell.complaints().size(), shell.err());
    assertFalse(Files.exists(out));
  }
}
