package simbad.blindworld;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simbad.blindworld.file.Csv;
import simbad.blindworld.file.FormatException;
import simbad.blindworld.file.JsonObject;

/** Worlds of motion from their command lines: what is made, that it tells nothing, its seals. */
class MotionWorldsTest {

  private static final int CASES = 24;
  private static final String EASY =
      "speed-scale,turn-scale,turn-bias,actuation-latency,wheel-scale,turns-unequal";

  /** The root over the first two cases of the benchmark's part of motion. */
  private static final String FIRST_OF_MOTION =
      "69866080a7cb95efd0e6328c1b259ca239d0e13fba91aa5b08ba8ddcc283b115";

  private static Path folder = Path.of("");
  private static Path world = Path.of("");

  private record Done(int status, String out, String err) {}

  private static Done run(String line, Path to) {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    ByteArrayOutputStream err = new ByteArrayOutputStream();
    List<String> arguments = new ArrayList<>(List.of(line.split(" ")));
    arguments.addAll(List.of("--out", to.toString()));
    int status =
        Main.run(
            arguments.toArray(String[]::new),
            new PrintStream(out, true, StandardCharsets.UTF_8),
            new PrintStream(err, true, StandardCharsets.UTF_8));
    return new Done(
        status, out.toString(StandardCharsets.UTF_8), err.toString(StandardCharsets.UTF_8));
  }

  private static Done generate(int cases, String mix, Path to) {
    return run(
        "generate --level motion --seed 4 --seconds 60-90 --repeats 40 --reference 0.25 --cases "
            + cases
            + " --effects "
            + EASY
            + " --mix "
            + mix,
        to);
  }

  @BeforeAll
  static void makeAWorld(@TempDir Path temporary) {
    folder = temporary;
    world = folder.resolve("world");
    Done done = generate(CASES, "none:1,single:1", world);
    assertEquals(0, done.status, done.err);
  }

  private static List<Path> cases() throws IOException {
    try (var paths = Files.list(world.resolve("cases"))) {
      return paths.sorted().toList();
    }
  }

  private static JsonObject truth(Path one) throws IOException, FormatException {
    return JsonObject.read(world.resolve("truth").resolve(one.getFileName()).resolve("truth.json"));
  }

  @Test
  void halfHoldsNothing_aQuarterHasAReference_andEffectsShow() throws Exception {
    int none = 0;
    int references = 0;
    for (Path one : cases()) {
      JsonObject truth = truth(one);
      boolean nothing = truth.object("effects").fields().isEmpty();
      none += nothing ? 1 : 0;
      references += Files.exists(one.resolve("reference-track.csv")) ? 1 : 0;
      assertEquals(
          Files.exists(one.resolve("reference-track.csv")),
          Files.exists(one.resolve("reference-commands.csv")));
      assertTrue(nothing || truth.number("z") >= 5, one.toString());
      assertTrue(nothing || truth.number("sealed_gap_oracle") < 1.1, one.toString());
      assertEquals(9, truth.numbers("sealed_nominal").size());
    }
    assertEquals(CASES / 2, none);
    assertEquals(CASES / 4, references);
  }

  /** Columns, decimals, names and times of files are the same everywhere. */
  @Test
  void everyFile_looksTheSame() throws Exception {
    for (Path one : cases()) {
      assertTrue(one.getFileName().toString().matches("c[0-9a-f]{7}"), one.toString());
      check(
          one.resolve("track.csv"),
          "run,t_s,x_m,z_m,heading_deg",
          "run-\\d,\\d+\\.\\d{4},-?\\d+\\.\\d{5},-?\\d+\\.\\d{5},-?\\d+\\.\\d{3}");
      boolean rims =
          JsonObject.read(one.resolve("robot.json")).text("kinematics").equals("differential");
      check(
          one.resolve("commands.csv"),
          rims ? "run,t_s,left_m_s,right_m_s" : "run,t_s,v_m_s,w_rad_s",
          "run-\\d,\\d+\\.\\d{3},-?\\d+\\.\\d{5},-?\\d+\\.\\d{5}");
      try (var files = Files.list(one)) {
        for (Path file : files.toList()) {
          assertEquals(
              "2020-01-01T00:00:00Z", Files.getLastModifiedTime(file).toString(), file + "");
        }
      }
    }
  }

  private static void check(Path file, String header, String row) throws IOException {
    List<String> lines = Files.readAllLines(file);
    assertEquals(header, lines.get(0));
    for (String line : lines.subList(1, lines.size())) {
      assertTrue(line.matches(row), file + ": " + line);
    }
  }

  /**
   * The nearest case by any one outward number must not tell whether an effect is at work. By
   * chance half of 24 are right, with a standard deviation of 2.5: beyond 20 one guess in 1,300
   * goes.
   */
  @Test
  void outwardLooks_tellNothing() throws Exception {
    List<double[]> looks = new ArrayList<>();
    List<Boolean> effects = new ArrayList<>();
    for (Path one : cases()) {
      looks.add(
          new double[] {
            Files.size(one.resolve("track.csv")),
            Files.size(one.resolve("commands.csv")),
            Files.size(one.resolve("robot.json")),
            Long.parseLong(one.getFileName().toString().substring(1), 16),
            looks.size()
          });
      effects.add(!truth(one).object("effects").fields().isEmpty());
    }
    for (int look = 0; look < looks.get(0).length; look++) {
      int right = 0;
      for (int i = 0; i < CASES; i++) {
        right += effects.get(i).equals(effects.get(nearest(looks, i, look))) ? 1 : 0;
      }
      assertTrue(right <= 20, "look " + look + " guesses " + right + " of " + CASES);
    }
  }

  private static int nearest(List<double[]> looks, int i, int look) {
    int best = -1;
    for (int j = 0; j < looks.size(); j++) {
      double apart = Math.abs(looks.get(i)[look] - looks.get(j)[look]);
      boolean nearer = best < 0 || apart < Math.abs(looks.get(i)[look] - looks.get(best)[look]);
      best = j != i && nearer ? j : best;
    }
    return best;
  }

  @Test
  void sameSeed_givesTheSameBytes() throws Exception {
    Path first = folder.resolve("first");
    Path second = folder.resolve("second");
    String mix = "none:1,single:1,pair:1,unknown:1";
    assertEquals(0, generate(4, mix, first).status);
    assertEquals(0, generate(4, mix, second).status);
    assertEquals(contents(first), contents(second));
  }

  private static Map<String, String> contents(Path root) throws IOException {
    Map<String, String> contents = new TreeMap<>();
    try (var paths = Files.walk(root)) {
      for (Path file : paths.filter(Files::isRegularFile).toList()) {
        contents.put(root.relativize(file).toString(), Files.readString(file));
      }
    }
    return contents;
  }

  /** What is to be forecast has the sealed commands and frames, and poses of dead reckoning. */
  @Test
  void rowsToPredict_holdNoSealedPose() throws Exception {
    Path one = cases().get(0).getFileName();
    Path rows = world.resolve("rows").resolve(one);
    Path sealed = world.resolve("truth").resolve(one);
    assertEquals(
        Files.readString(sealed.resolve("sealed-commands.csv")),
        Files.readString(rows.resolve("commands.csv")));
    Csv told = Csv.read(rows.resolve("track.csv"));
    Csv seen = Csv.read(sealed.resolve("sealed-track.csv"));
    assertEquals(seen.size(), told.size());
    int same = 0;
    for (int row = 0; row < told.size(); row++) {
      assertEquals(seen.text(row, 1), told.text(row, 1));
      same += seen.text(row, 2).equals(told.text(row, 2)) ? 1 : 0;
    }
    assertTrue(same < told.size() / 10, same + " poses of " + told.size() + " are the sealed ones");
  }

  /** The rule answers, the scorer scores it beside the oracle, and a byte that differs ends it. */
  @Test
  void baselineIsScored_andBrokenSealsAreRefused() throws Exception {
    Path own = folder.resolve("own");
    assertEquals(0, generate(4, "none:1,single:1", own).status);
    Path answers = folder.resolve("answers");
    Done made = run("baseline --cases " + own + "/cases --rows " + own + "/rows", answers);
    assertEquals(0, made.status, made.err);
    Path scores = folder.resolve("scores.json");
    Done scored = score(own, answers, scores);
    assertEquals(0, scored.status, scored.err);
    assertTrue(scored.out.contains("4 verified against manifest.json"), scored.out);
    assertTrue(scored.out.contains("worlds of motion (M1 and M2)"), scored.out);
    JsonObject all =
        JsonObject.read(scores).object("scores").object("worlds of motion (M1 and M2)");
    JsonObject oracle = all.object("oracle");
    assertEquals(1, oracle.object("share_of_oracle_removal").number("median"), 1e-3);
    assertEquals(1, oracle.object("shares").object("all verdicts right").number("share"));
    assertEquals("4 of 4 answers", JsonObject.read(scores).text("predictions"));
    checkMissing(own, answers);
    checkBroken(own, answers);
  }

  private static Done score(Path own, Path answers, Path out) {
    return run(
        "score --truth " + own + "/truth --manifest " + own + "/manifest.json --answers " + answers,
        out);
  }

  private static void checkMissing(Path own, Path answers) throws IOException {
    try (var paths = Files.list(answers)) {
      Files.delete(paths.sorted().findFirst().orElseThrow().resolve("predictions.csv"));
    }
    Done scored = score(own, answers, folder.resolve("other.json"));
    assertEquals(0, scored.status, scored.err);
    assertTrue(scored.out.contains("predictions are missing: 3 of 4 answers"), scored.out);
  }

  private static void checkBroken(Path own, Path answers) throws IOException {
    Path one;
    try (var paths = Files.list(own.resolve("truth"))) {
      one = paths.sorted().findFirst().orElseThrow().getFileName();
    }
    for (String name :
        List.of(
            "truth/ID/truth.json",
            "truth/ID/sealed-track.csv",
            "truth/ID/oracle.csv",
            "rows/ID/track.csv",
            "cases/ID/commands.csv")) {
      Path file = own.resolve(name.replace("ID", one.toString()));
      String text = Files.readString(file);
      Files.writeString(file, text + " ");
      Done scored = score(own, answers, folder.resolve("never.json"));
      assertEquals(2, scored.status, name);
      assertTrue(scored.err.contains("was committed to"), scored.err);
      Files.writeString(file, text);
    }
  }

  /**
   * The benchmark's first two cases are the same bytes for ever, and say of which part they are.
   */
  @Test
  void benchmark_isFrozen() throws Exception {
    Path two = folder.resolve("two of the benchmark");
    Done done = run("benchmark --part Motion --first 2", two);
    assertEquals(0, done.status, done.err);
    assertTrue(done.out.startsWith("SRB-1.1 motion, first half, root "), done.out);
    JsonObject manifest = JsonObject.read(two.resolve("manifest.json"));
    assertEquals("motion", manifest.text("worlds"));
    assertEquals("motion", manifest.text("part"));
    assertEquals(FIRST_OF_MOTION, manifest.text("root"), "other bytes");
  }

  @Test
  void options_ofOtherWorlds_areRefused() {
    Path nowhere = Path.of("pom.xml/x");
    Done rows = run("generate --level motion --rows 100-200", nowhere);
    assertEquals(2, rows.status);
    assertTrue(rows.err.contains("--rows: not of these worlds, expected --seconds"), rows.err);
    assertEquals(2, run("generate --seconds 100-200", nowhere).status);
    Done sonar = run("generate --level motion --effects gain", nowhere);
    assertTrue(sonar.err.contains("--effects: no such effect: gain"), sonar.err);
    assertEquals(2, run("generate --level moon", nowhere).status);
  }
}
