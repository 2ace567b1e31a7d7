package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simbad.sonar.sensing.ReadingRow;

/** The withheld check from its command line, with all its processes, on a handful of cases. */
class BlindCheckCommandTest {
  private static final int ROWS = 160;
  private static final ObjectMapper MAPPER = new ObjectMapper();

  @TempDir
  @SuppressWarnings("NullAway.Init")
  private Path folder;

  private Path out() {
    return folder.resolve("check");
  }

  private Shell check(String... arguments) {
    List<String> all = new ArrayList<>(List.of("blind-check", "--out", out().toString()));
    all.addAll(List.of(arguments));
    return Shell.simbad(all.toArray(String[]::new));
  }

  /** A data set whose echoes are longer by an offset, with its truth and rows never shown. */
  private void foreign(String name, double offsetM) throws IOException {
    Path set = BenchData.write(folder.resolve("sets").resolve(name), BenchData.rows(ROWS, offsetM));
    List<ReadingRow> fresh = BenchData.rows(2 * ROWS, offsetM).subList(ROWS, 2 * ROWS);
    Path other = BenchData.write(folder.resolve("fresh-" + name), fresh);
    Files.copy(other.resolve("readings.csv"), set.resolve("sealed.csv"));
    String effects = offsetM == 0 ? "" : "\"range-offset\": {\"m\": " + offsetM + "}";
    Files.writeString(set.resolve("truth.json"), "{\"effects\": {" + effects + "}}\n");
  }

  private JsonNode json(String name) throws IOException {
    return MAPPER.readTree(out().resolve(name).toFile());
  }

  /** All files but the log, whose lines hold times. */
  private Map<String, String> contents() throws IOException {
    Map<String, String> contents = new TreeMap<>();
    try (Stream<Path> paths = Files.walk(out())) {
      for (Path file : paths.filter(Files::isRegularFile).toList()) {
        String bytes = new String(Files.readAllBytes(file), StandardCharsets.ISO_8859_1);
        contents.put(out().relativize(file).toString(), bytes);
      }
    }
    assertTrue(contents.remove("run.log").contains(" scored"));
    return contents;
  }

  @Test
  void foreignSets_areSealedDiagnosedAndScored() throws IOException {
    foreign("long", 0.05);
    foreign("plain", 0);
    String sets = folder.resolve("sets").toString();
    String[] arguments = {"--foreign", sets, "--level", "L0, this very program"};
    Shell first = check(arguments);
    assertEquals(0, first.status(), first.err());
    assertEquals("", first.err());
    assertTrue(first.out().contains("foreign data sets (L0, this very program)"), first.out());
    assertTrue(first.out().contains(out().resolve("report.html").toString()), first.out());
    JsonNode all = json("check.json").at("/scores/foreign data sets (L0, this very program)");
    assertEquals(2, all.at("/diagnosis/shares/all verdicts right/hits").asInt());
    assertEquals(1, all.at("/diagnosis/shares/singles named and explained/hits").asInt());
    assertEquals(2, all.at("/oracle/shares/all verdicts right/hits").asInt());
    assertEquals(
        "2 verified against manifest.json", json("check.json").at("/commitments").asText());
    assertFalse(
        Files.exists(out().resolve("answers/plain/report.html")), "it was answered rightly");
    checkSeals();
    checkOpenFolder();
    checkResumed(arguments);
    checkTampering(arguments);
  }

  /** The manifest's commitment is SHA-256 of salt and truth; the truth is what was handed in. */
  private void checkSeals() throws IOException {
    JsonNode entry = json("world/manifest.json").at("/cases/0");
    Path truth = out().resolve("world/truth/long");
    byte[] salt = HexFormat.of().parseHex(Files.readString(truth.resolve("salt.txt")).strip());
    byte[] text = Files.readAllBytes(truth.resolve("truth.json"));
    assertEquals(32, salt.length);
    assertEquals("long", entry.at("/case").asText());
    assertEquals(sha256(salt, text), entry.at("/commitment").asText());
  }

  private static String sha256(byte[]... parts) {
    try {
      java.security.MessageDigest digest = java.security.MessageDigest.getInstance("SHA-256");
      for (byte[] part : parts) {
        digest.update(part);
      }
      return HexFormat.of().formatHex(digest.digest());
    } catch (java.security.NoSuchAlgorithmException e) {
      throw new AssertionError(e);
    }
  }

  /** What may be seen holds no truth, and what is to be predicted no readings. */
  private void checkOpenFolder() throws IOException {
    try (Stream<Path> files = Files.list(out().resolve("world/cases/long"))) {
      assertEquals(
          List.of("readings.csv", "scene.json"),
          files.map(file -> file.getFileName().toString()).sorted().toList());
    }
    String header = Files.readAllLines(out().resolve("world/rows/long/rows.csv")).get(0);
    assertEquals("run,sensor,t_s,x_m,z_m,heading_deg", header);
  }

  /** A second call keeps what is there and gives the same bytes; a lost answer is made anew. */
  private void checkResumed(String... arguments) throws IOException {
    Map<String, String> before = contents();
    assertEquals(0, check(arguments).status());
    assertEquals(List.of(), changed(before));
    Path kept = out().resolve("answers/plain/diagnosis.json");
    FileTime time = Files.getLastModifiedTime(kept);
    delete(out().resolve("answers/long"));
    Files.createDirectory(out().resolve("answers/long.unfinished"));
    assertEquals(0, check(arguments).status());
    assertEquals(time, Files.getLastModifiedTime(kept));
    List<String> changed = changed(before);
    for (String same : List.of("model.json", "predictions.csv", "scene.json")) {
      assertFalse(changed.contains("answers/long/" + same), same);
    }
    Shell other = check("--foreign", arguments[1]);
    assertEquals(2, other.status());
    assertTrue(other.err().contains("order.json: was begun with other options"), other.err());
  }

  /** Files whose bytes differ from what they were. */
  private List<String> changed(Map<String, String> before) throws IOException {
    Map<String, String> after = contents();
    assertEquals(before.keySet(), after.keySet());
    return before.keySet().stream()
        .filter(n -> !Objects.equals(before.get(n), after.get(n)))
        .toList();
  }

  private static void delete(Path root) throws IOException {
    try (Stream<Path> paths = Files.walk(root)) {
      for (Path path : paths.sorted(Comparator.reverseOrder()).toList()) {
        Files.delete(path);
      }
    }
  }

  /** A truth that was changed after it was sealed is found out, and nothing is scored. */
  private void checkTampering(String... arguments) throws IOException {
    Path truth = out().resolve("world/truth/plain/truth.json");
    Files.writeString(truth, "{\"effects\": {\"gain\": {}}}\n");
    Shell shell = check(arguments);
    assertEquals(2, shell.status());
    assertEquals(1, shell.complaints().size(), shell.err());
    assertTrue(shell.err().contains("plain, truth.json: hash"), shell.err());
    assertTrue(shell.err().contains("was committed to"), shell.err());
    assertFalse(shell.out().contains("no effect"), shell.out());
  }

  @Test
  @Tag("full")
  void drawnCases_areOfTheKindsAskedFor() throws IOException {
    Shell shell =
        check(
            "--cases 2 --seed 4 --rows 200-220 --withhold range-offset --mix none:1,withheld:1"
                .split(" "));
    assertEquals(0, shell.status(), shell.err());
    List<String> kinds = new ArrayList<>();
    json("check.json").at("/cases").forEach(one -> kinds.add(one.at("/kind").asText()));
    assertEquals(List.of("none", "withheld"), kinds.stream().sorted().toList());
    json("check.json")
        .at("/cases")
        .forEach(one -> assertFalse(one.at("/said").asText().contains("range-offset")));
    assertEquals("range-offset", json("order.json").at("/withheld/0").asText());
    assertTrue(Files.readString(out().resolve("report.html")).contains("not told of range-offset"));
    assertEquals(3, Files.readAllLines(out().resolve("cases.csv")).size());
  }

  /** Waves are drawn, diagnosed and scored as all others are, under a level of their own. */
  @Test
  void waves_haveALevelOfTheirOwn() throws IOException {
    Shell shell =
        check(
            "--level wave --cases 1 --seed 4 --rows 300-320 --mix single:1 --effects range-offset --sizes 1-2"
                .split(" "));
    assertEquals(0, shell.status(), shell.err());
    assertTrue(shell.out().contains("worlds of waves (L2w)"), shell.out());
    assertEquals("--level", json("order.json").at("/options/0").asText());
    assertTrue(json("order.json").at("/reference_share").isMissingNode());
    JsonNode scores = json("check.json").at("/scores/worlds of waves (L2w)/oracle");
    assertEquals(1, scores.at("/shares/all right/hits").asInt());
    assertEquals("L2w", json("check.json").at("/cases/0/level").asText());
    String page = Files.readString(out().resolve("report.html"));
    assertTrue(page.contains("Right, cautious, wrong"), "the table of verdicts");
    assertTrue(page.contains("--level wave --sizes 1-2"), "the command that repeats it");
  }

  /** Robots are drawn and scored on a page like the others', whether or not they are predicted. */
  @Test
  void motion_hasLevelsOfItsOwn() throws IOException {
    String order = "--motion --cases 1 --seed 4 --seconds 60-61 --mix single:1 --reference 0";
    check((order + " --effects speed-scale --limit 120").split(" "));
    assertEquals("motion", json("order.json").at("/options/1").asText());
    JsonNode scores = json("check.json").at("/scores/robot as believed (M1)");
    assertEquals(1, scores.at("/oracle/shares/all right/hits").asInt());
    assertEquals(1, scores.at("/baseline/shares/answered/hits").asInt());
    assertEquals("M1", json("check.json").at("/cases/0/level").asText());
    String page = Files.readString(out().resolve("report.html"));
    assertTrue(page.contains("--motion --seconds 60-61"), "the command that repeats it");
    assertFalse(page.contains("--level motion"), "no option of this command");
  }

  /**
   * A part of the benchmark is drawn, diagnosed and scored by one command. Who mistypes an option
   * before may mend it and keep the folder.
   */
  @Test
  void benchmark_isDrawnDiagnosedAndScored() throws IOException {
    assertEquals(2, check("--mix", "odd:1").status());
    Shell shell = check("--benchmark", "l1", "--first", "1");
    assertEquals(0, shell.status(), shell.err());
    assertEquals("L1", json("order.json").at("/benchmark").asText());
    assertEquals("SRB-1.1", json("world/manifest.json").at("/benchmark").asText());
    assertEquals(1, json("check.json").at("/cases").size());
    assertTrue(
        Files.readString(out().resolve("report.html")).contains("--benchmark L1 --first 1"),
        "the command that repeats it");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "--cases 0 | --cases: 0 is not in [1, 100000]",
        "--benchmark motion --audit-only | --audit-only: the audit that is counted is of readings",
        "--cases many | --cases",
        "--reference 1.5 | --reference: 1.5 is not in [0, 1]",
        "--reference NaN | --reference: NaN is not in [0, 1]",
        "--off --reference 0.5 | --off and --reference exclude each other",
        "--withhold ghosts | --withhold: 'ghosts' is not the name of an effect",
        "--jobs 0 | --jobs: 0 is not at least 1",
        "--jobs 2 --spark local[2] | mutually exclusive",
        "--spark local[2] | --spark: Spark is not among this program's jars",
        "--limit 0 | --limit: 0.0 is not in (0, 1000000.0] s",
        "--level L3 | --level: 'L3' is not wave; another level goes with --foreign",
        "--foreign sets --cases 3 | --foreign: nothing is drawn",
        "--foreign sets --off | --foreign: nothing is drawn",
        "--level wave --off | --level wave: every case has a reference",
        "--level wave --reference 0.5 | --level wave: every case has a reference",
        "--sizes 0-10 | --sizes: '0'",
        "--first 3 | --first: expected --benchmark with it",
        "--practice 3 | --practice: expected --benchmark with it",
        "--benchmark L1 --practice 3 | --practice: expected --first with it, and no --seed",
        "--benchmark L1 --first 1 --practice 1000001 | --practice: '1000001'",
        "--benchmark L9 | --benchmark: 'L9', expected L1, L2, L2w, motion",
        "--motion --level wave | --motion: --level",
        "--motion --rows 300-400 | --motion: --level",
        "--motion --seconds 9-10 | --seconds: '9'",
        "--seconds 60-90 | --seconds: expected --motion with it",
        "--foreign sets --motion | --foreign: nothing is drawn",
        "--foreign sets --next | --next: only worlds with sonars that were drawn here",
        "--motion --next | --next: only worlds with sonars that were drawn here",
        "--benchmark motion --next | --next: only worlds with sonars that were drawn here",
        "--audit-only --next | --audit-only: nothing is diagnosed, expected no --next",
        "--benchmark motion --motion | --benchmark: its cases are fixed",
        "--benchmark L1 --first 351 | --first: '351'",
        "--benchmark L1 --first 1 --seed 4 | --seed: not that of the second half",
        "--benchmark L1 --cases 4 | --benchmark: its cases are fixed",
        "--level wave --sizes 0-1 | --sizes: '0'",
        "--mix odd:1 | --mix: 'odd:1'",
        "--mix withheld:1 | --mix: withheld cases, expected --withheld",
        "--effects magic | --effects: no such effect: magic; expected one that simbad effects",
        "--rows 9 | --rows: '9'",
        "--foreign FOLDER/nowhere | nowhere: no such folder",
        "--foreign FOLDER/empty | no data set in it",
      })
  void badUsage_isSaidInOneLine(String line, String complaint) throws IOException {
    Files.createDirectories(folder.resolve("empty"));
    Shell shell = check(line.replace("FOLDER", folder.toString()).split(" "));
    assertEquals(2, shell.status(), shell.err());
    assertEquals(1, shell.complaints().size(), shell.err());
    assertTrue(shell.err().contains(complaint), shell.err());
    assertFalse(Files.exists(out().resolve("world")), "nothing half-made stays");
  }

  @Test
  void someoneElsesFolder_isLeftAlone() throws IOException {
    Files.createDirectories(out());
    Files.writeString(out().resolve("theirs"), "kept");
    Shell shell = check();
    assertEquals(2, shell.status());
    assertTrue(shell.err().contains("is neither empty nor the folder of a check"), shell.err());
    assertEquals("kept", Files.readString(out().resolve("theirs")));
  }

  @Test
  void foreignSetWithoutTruth_isNamed() throws IOException {
    foreign("plain", 0);
    Files.delete(folder.resolve("sets/plain/truth.json"));
    Shell shell = check("--foreign", folder.resolve("sets").toString());
    assertEquals(2, shell.status());
    assertTrue(shell.err().contains("plain/truth.json: there is no such file"), shell.err());
  }

  /** What cannot be diagnosed counts as wrong, the rest is scored, and the status says so. */
  @Test
  void brokenSet_hasNoAnswer() throws IOException {
    foreign("broken", 0);
    foreign("plain", 0);
    Path readings = folder.resolve("sets/broken/readings.csv");
    Files.writeString(
        readings, Files.readString(readings).replaceFirst("\nrun 0,S,", "\nrun 0,S,x"));
    Shell shell = check("--foreign", folder.resolve("sets").toString());
    assertEquals(1, shell.status(), shell.err());
    assertTrue(shell.err().contains("broken/readings.csv:2: t_s"), shell.err());
    assertTrue(shell.err().contains("1 without an answer, which counts as wrong: broken"));
    JsonNode shares =
        json("check.json").at("/scores/foreign data sets (level not stated)/diagnosis");
    assertEquals(1, shares.at("/shares/answered/hits").asInt());
    assertEquals(2, shares.at("/shares/answered/of").asInt());
  }
}
