package simbad.blindworld;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simbad.blindworld.file.Csv;
import simbad.blindworld.file.JsonObject;

/** Both programs from their command lines: what is made, that it tells nothing, that seals hold. */
class BlindCheckTest {

  private static final int CASES = 36;

  /** Effects that few rows show, so that few draws are needed. */
  private static final String EASY =
      "absorption,beam-width,early-timeout,dead-zone,floor-echo,gain,sound-speed,range-offset,"
          + "noise-side,range-band-loss";

  /** The root over the first two cases of the benchmark's part L1. */
  private static final String FIRST_OF_L1 =
      "088e9d96f9acdf538f3b38771d710a5b4b4524922fcf391c1bddc423db613ad9";

  /** Where what is refused would be written: no folder can be made below a file. */
  private static final String NOWHERE = "pom.xml/x";

  private static Path folder = Path.of("");
  private static Path world = Path.of("");

  private record Done(int status, String out, String err) {}

  private static Done run(String... arguments) {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    ByteArrayOutputStream err = new ByteArrayOutputStream();
    int status =
        Main.run(
            arguments,
            new PrintStream(out, true, StandardCharsets.UTF_8),
            new PrintStream(err, true, StandardCharsets.UTF_8));
    return new Done(
        status, out.toString(StandardCharsets.UTF_8), err.toString(StandardCharsets.UTF_8));
  }

  private static Done generate(Path to, int cases, String mix) {
    return run(
        "generate",
        "--cases",
        "" + cases,
        "--seed",
        "9",
        "--out",
        to.toString(),
        "--rows",
        "300-450",
        "--repeats",
        "40",
        "--reference",
        "0.25",
        "--mix",
        mix,
        "--effects",
        EASY);
  }

  @BeforeAll
  static void makeAWorld(@TempDir Path temporary) {
    folder = temporary;
    world = folder.resolve("world");
    Done done = generate(world, CASES, "none:1,single:1");
    assertEquals(0, done.status, done.err);
  }

  private static List<Path> cases() throws IOException {
    try (var paths = Files.list(world.resolve("cases"))) {
      return paths.sorted().toList();
    }
  }

  @Test
  void halfOfTheMix_isEachKind_andAQuarterHasAReference() throws Exception {
    int none = 0;
    int references = 0;
    for (Path one : cases()) {
      JsonObject truth = truth(one);
      none += truth.object("effects").fields().isEmpty() ? 1 : 0;
      references += Files.exists(one.resolve("reference.csv")) ? 1 : 0;
    }
    assertEquals(CASES, cases().size());
    assertEquals(CASES / 2, none);
    assertEquals(CASES / 4, references);
  }

  private static JsonObject truth(Path one) throws Exception {
    return JsonObject.read(world.resolve("truth").resolve(one.getFileName()).resolve("truth.json"));
  }

  @Test
  void everyFile_looksTheSame() throws Exception {
    for (Path one : cases()) {
      assertTrue(one.getFileName().toString().matches("c[0-9a-f]{7}"), one.toString());
      for (String name : List.of("readings.csv", "reference.csv")) {
        if (Files.exists(one.resolve(name))) {
          checkRows(one.resolve(name));
        }
      }
      try (var files = Files.list(one)) {
        for (Path file : files.toList()) {
          assertEquals(
              "2020-01-01T00:00:00Z", Files.getLastModifiedTime(file).toString(), file + "");
        }
      }
    }
  }

  private static void checkRows(Path file) throws IOException {
    List<String> lines = Files.readAllLines(file);
    assertEquals("run,sensor,t_s,x_m,z_m,heading_deg,range_m", lines.get(0));
    String row =
        "[^,]+,[^,]+,\\d+\\.\\d{3},-?\\d+\\.\\d{4},-?\\d+\\.\\d{4},-?\\d+\\.\\d{3},(\\d+\\.\\d{4})?";
    for (String line : lines.subList(1, lines.size())) {
      assertTrue(line.matches(row), file + ": " + line);
    }
  }

  /**
   * The nearest case by any one outward number must not tell whether an effect is at work. By
   * chance half of 36 are right, with a standard deviation of 3: beyond 28 one guess in 2,500 goes.
   */
  @Test
  void outwardLooks_tellNothing() throws Exception {
    List<double[]> looks = new ArrayList<>();
    List<Boolean> effects = new ArrayList<>();
    for (Path one : cases()) {
      looks.add(
          new double[] {
            Files.size(one.resolve("readings.csv")),
            Files.size(one.resolve("scene.json")),
            Files.readAllLines(one.resolve("readings.csv")).size(),
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
      assertTrue(right <= 28, "look " + look + " guesses " + right + " of " + CASES);
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
    String mix = "none:1,single:2,pair:1,unknown:1";
    assertEquals(0, generate(first, 5, mix).status);
    assertEquals(0, generate(second, 5, mix).status);
    assertEquals(contents(first), contents(second));
    assertEquals(1, generate(second, 5, mix).status, "a folder with something in it");
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

  @Test
  void rowsToPredict_areTheSealedOnesWithoutReadings() throws Exception {
    Path one = cases().get(0).getFileName();
    Csv rows = Csv.read(world.resolve("rows").resolve(one).resolve("rows.csv"));
    Csv sealed = Csv.read(world.resolve("truth").resolve(one).resolve("sealed.csv"));
    assertEquals(sealed.header().subList(0, 6), rows.header());
    assertEquals(sealed.size(), rows.size());
    assertEquals(sealed.text(5, 4), rows.text(5, 4));
  }

  @Test
  void baselineIsScoredBesideTheOracle_andSealsHold() throws Exception {
    Path answers = folder.resolve("answers");
    Path scores = folder.resolve("scores.json");
    String truth = world.resolve("truth").toString();
    Done made =
        run(
            "baseline",
            "--cases",
            world.resolve("cases").toString(),
            "--rows",
            world.resolve("rows").toString(),
            "--out",
            answers.toString());
    assertEquals(0, made.status, made.err);
    Done scored =
        run(
            "score",
            "--truth",
            truth,
            "--answers",
            answers.toString(),
            "--baseline",
            answers.toString(),
            "--manifest",
            world.resolve("manifest.json").toString(),
            "--out",
            scores.toString());
    assertEquals(0, scored.status, scored.err);
    assertTrue(scored.out.contains("36 verified against manifest.json"), scored.out);
    assertTrue(scored.out.contains("set-up off, with reference (L2)"), scored.out);
    JsonObject all = JsonObject.read(scores).object("scores").object("all cases (L1 and L2)");
    assertEquals(36, all.object("diagnosis").number("cases"));
    JsonObject oracle = all.object("oracle");
    assertEquals(1, oracle.object("share_of_oracle_removal").number("median"), 1e-6);
    assertEquals(1, oracle.object("shares").object("all verdicts right").number("share"));
    checkWithheld(truth, answers);
    checkTampering(answers);
  }

  /** Leave-one-out: as many cases as asked for hold the effect, and no other case does. */
  @Test
  void withheldEffects_areAKindOfTheirOwn() throws Exception {
    Path to = folder.resolve("withheld");
    Done done =
        run(
            "generate --cases 10 --seed 3 --rows 300-350 --repeats 40 --withheld gain".split(" "),
            "--mix",
            "none:2,single:4,withheld:4",
            "--effects",
            "gain,sound-speed,floor-echo",
            "--out",
            to.toString());
    assertEquals(0, done.status, done.err);
    int held = 0;
    try (var paths = Files.list(to.resolve("truth"))) {
      for (Path one : paths.toList()) {
        JsonObject truth = JsonObject.read(one.resolve("truth.json"));
        boolean gain = truth.object("effects").fields().containsKey("gain");
        assertEquals(gain, truth.text("kind").equals("withheld"));
        held += gain ? 1 : 0;
      }
    }
    assertEquals(4, held);
  }

  private static Done run(String[] first, String... rest) {
    List<String> all = new ArrayList<>(List.of(first));
    all.addAll(List.of(rest));
    return run(all.toArray(String[]::new));
  }

  private static Done waves(Path to, String... more) {
    return run(
        "generate --level wave --seed 6 --repeats 40 --mix single:1".split(" "),
        Stream.concat(Stream.of("--out", to + ""), Arrays.stream(more)).toArray(String[]::new));
  }

  /** Worlds of waves: the same tree, a reference each, and a truth that says what may be said. */
  @Test
  void waves_areDrawnSealedAndScored() throws Exception {
    Path first = folder.resolve("waves");
    Done done = waves(first, "--cases", "1", "--effects", "range-offset", "--rows", "1200-1300");
    assertEquals(0, done.status, done.err);
    try (var paths = Files.list(first.resolve("cases"))) {
      for (Path one : paths.toList()) {
        checkRows(one.resolve("readings.csv"));
        checkRows(one.resolve("reference.csv"));
        checkWave(
            JsonObject.read(
                first.resolve("truth").resolve(one.getFileName()).resolve("truth.json")));
      }
    }
    Path answers = folder.resolve("wave answers");
    String[] baseline = {
      "baseline", "--cases", first + "/cases", "--rows", first + "/rows", "--out", answers + ""
    };
    assertEquals(0, run(baseline).status);
    Done scored = scoreForeign(first, answers);
    assertEquals(0, scored.status, scored.err);
    assertTrue(scored.out.contains("1 verified against manifest.json"), scored.out);
    assertTrue(scored.out.contains("worlds of waves (L2w)"), scored.out);
    assertTrue(scored.out.contains("all wrongly explained"), scored.out);
    Path truth = first.resolve("truth");
    try (var paths = Files.list(truth)) {
      Path sealed = paths.sorted().findFirst().orElseThrow().resolve("truth.json");
      Files.writeString(sealed, Files.readString(sealed).replaceFirst("single", "none"));
    }
    assertEquals(2, scoreForeign(first, answers).status);
  }

  private static void checkWave(JsonObject truth) throws Exception {
    String name = truth.object("effects").fields().keySet().iterator().next();
    assertTrue(truth.textLists("accept").contains(List.of(name)));
    assertEquals(List.of(name), truth.texts("public"));
    assertEquals(List.of(), truth.texts("unknown"));
    assertTrue(truth.number("z") >= 5);
    assertTrue(truth.number("sealed_gap_oracle_m") < truth.number("sealed_gap_unchanged_m"));
    assertTrue(truth.number("setup_floor_m") < truth.number("setup_gap_m"));
    assertTrue(truth.numbers("sizes").get(0) >= 0.5);
  }

  /** Sizes that are asked for are drawn as they are, whether they show or not. */
  @Test
  @Tag("full")
  void sizesAskedFor_needNotShow() throws Exception {
    Path to = folder.resolve("sizes");
    String[] small = {
      "--effects", "gain", "--sizes", "0.1-0.2", "--rows", "300-350", "--cases", "1"
    };
    Done done = waves(to, small);
    assertEquals(0, done.status, done.err);
    Path again = folder.resolve("sizes again");
    assertEquals(0, waves(again, small).status);
    assertEquals(contents(to), contents(again));
    try (var paths = Files.list(to.resolve("truth"))) {
      for (Path one : paths.toList()) {
        JsonObject truth = JsonObject.read(one.resolve("truth.json"));
        double size = truth.numbers("sizes").get(0);
        assertTrue(size >= 0.1 && size <= 0.2, "size " + size);
      }
    }
  }

  /** The first cases of the benchmark are those of all of it, byte for byte, on any machine. */
  @Test
  void benchmark_hasTheSameBytes() throws Exception {
    Path two = folder.resolve("two of the benchmark");
    Done done = run("benchmark", "--part", "L1", "--first", "2", "--out", two + "");
    assertEquals(0, done.status, done.err);
    assertTrue(done.out.contains("SRB-1.1 L1, first half, root "), done.out);
    assertEquals(
        FIRST_OF_L1, JsonObject.read(two.resolve("manifest.json")).text("root"), "other bytes");
    Path one = folder.resolve("one of the benchmark");
    assertEquals(0, run("benchmark", "--part", "l1", "--first", "1", "--out", one + "").status);
    try (var paths = Files.list(one.resolve("cases"))) {
      Path name = paths.findFirst().orElseThrow().getFileName();
      for (String file : List.of("cases", "truth", "rows")) {
        assertEquals(
            contents(one.resolve(file).resolve(name)), contents(two.resolve(file).resolve(name)));
      }
    }
  }

  @Test
  void benchmark_keepsItsSecondHalf() {
    String[] guess = {"benchmark", "--part", "L2w", "--seed", "1", "--out", folder + "/half"};
    Done done = run(guess);
    assertEquals(2, done.status);
    assertTrue(done.err.contains("--seed: not that of the second half of SRB-1.1"), done.err);
    assertFalse(Files.exists(folder.resolve("half")));
    assertEquals(2, run("benchmark", "--part", "L3", "--out", folder + "/half").status);
  }

  /** Sizes that are asked for are drawn in worlds of equations, too, up to three at a time. */
  @Test
  void sizesOfEquations_areInTheTruth() throws Exception {
    Path to = folder.resolve("sizes of equations");
    Done done =
        run(
            "generate --cases 3 --seed 3 --repeats 40 --rows 300-320 --mix triple:1 --sizes 0.2-3"
                .split(" "),
            "--out",
            to + "");
    assertEquals(0, done.status, done.err);
    try (var paths = Files.list(to.resolve("truth"))) {
      for (Path one : paths.toList()) {
        JsonObject truth = JsonObject.read(one.resolve("truth.json"));
        assertEquals(3, truth.object("effects").fields().size());
        assertEquals(3, truth.numbers("sizes").size());
        truth.numbers("sizes").forEach(size -> assertTrue(size >= 0.2 && size <= 3));
        assertTrue(Double.isFinite(truth.number("z")));
      }
    }
  }

  /** Data sets of others are sealed as they are, and scored under the level that they state. */
  @Test
  void foreignSets_areSealedAndScored() throws Exception {
    Path sets = folder.resolve("sets");
    for (Path one : cases().subList(0, 3)) {
      Path set = Files.createDirectories(sets.resolve(one.getFileName()));
      Path truth = world.resolve("truth").resolve(one.getFileName());
      for (Path file :
          List.of(
              one.resolve("scene.json"),
              one.resolve("readings.csv"),
              truth.resolve("truth.json"),
              truth.resolve("sealed.csv"))) {
        Files.copy(file, set.resolve(file.getFileName()));
      }
    }
    Path to = folder.resolve("sealed");
    String[] seal = {"seal", "--sets", sets + "", "--out", to + "", "--level", "L3, a bench"};
    assertEquals(0, run(seal).status);
    assertEquals(1, run(seal).status, "a folder with something in it");
    Path answers = folder.resolve("foreign-answers");
    String[] baseline = {
      "baseline", "--cases", to + "/cases", "--rows", to + "/rows", "--out", answers + ""
    };
    assertEquals(0, run(baseline).status);
    Done scored = scoreForeign(to, answers);
    assertEquals(0, scored.status, scored.err);
    assertTrue(scored.out.contains("3 verified against manifest.json"), scored.out);
    assertTrue(scored.out.contains("foreign data sets (L3, a bench)"), scored.out);
    Path one = to.resolve("truth").resolve(cases().get(0).getFileName());
    Files.writeString(one.resolve("sealed.csv"), "run\n");
    Done tampered = scoreForeign(to, answers);
    assertEquals(2, tampered.status);
    assertTrue(tampered.err.contains("sealed.csv: hash"), tampered.err);
  }

  private static Done scoreForeign(Path to, Path answers) {
    return run(
        "score",
        "--truth",
        to + "/truth",
        "--answers",
        answers + "",
        "--manifest",
        to + "/manifest.json");
  }

  @Test
  void foreignSets_thatAreNone_areNamed() throws Exception {
    Path sets = Files.createDirectories(folder.resolve("none"));
    check(sets + ": no data set in it", "seal", "--sets", sets + "", "--out", NOWHERE);
    Path set = Files.createDirectories(sets.resolve("a"));
    check("a/scene.json: there is no such file", "seal", "--sets", sets + "", "--out", NOWHERE);
    for (String name : List.of("scene.json", "readings.csv", "sealed.csv")) {
      Files.writeString(set.resolve(name), "");
    }
    Files.writeString(set.resolve("truth.json"), "{\"effects\": 7}");
    check("effects: expected an object", "seal", "--sets", sets + "", "--out", NOWHERE);
    check("no such folder", "seal", "--sets", folder + "/nowhere", "--out", NOWHERE);
  }

  private static void checkWithheld(String truth, Path answers) {
    Done scored =
        run("score", "--truth", truth, "--answers", answers.toString(), "--withheld", "gain");
    assertEquals(0, scored.status, scored.err);
    assertTrue(scored.out.contains("(gain)"), scored.out);
    assertEquals(
        2,
        run("score", "--truth", truth, "--answers", answers.toString(), "--withheld", "x").status);
    String line = "score --truth " + truth + " --known x --withheld x --answers " + answers;
    assertEquals(0, run(line.split(" ", -1)).status);
  }

  /** Each of the sealed files, changed by one byte, must be found out. */
  private static void checkTampering(Path answers) throws Exception {
    Path one = world.resolve("truth").resolve(cases().get(0).getFileName());
    Path open = cases().get(0);
    for (Path file :
        List.of(
            one.resolve("truth.json"),
            one.resolve("sealed.csv"),
            one.resolve("oracle.csv"),
            open.resolve("readings.csv"))) {
      FileTime time = Files.getLastModifiedTime(file);
      byte[] before = Files.readAllBytes(file);
      byte[] after = Arrays.copyOf(before, before.length);
      after[before.length - 2] ^= 1;
      Files.write(file, after);
      Done scored =
          run(
              "score",
              "--truth",
              world.resolve("truth").toString(),
              "--answers",
              answers.toString(),
              "--manifest",
              world.resolve("manifest.json").toString());
      Files.setLastModifiedTime(Files.write(file, before), time);
      assertEquals(2, scored.status, file.toString());
      assertTrue(scored.err.contains("was committed to"), scored.err);
      assertTrue(scored.out.isEmpty(), "nothing is scored");
    }
  }

  @Test
  void wrongUsage_isSaidInOneLine() {
    check(
        "blind-world: '': expected generate, benchmark, seal, baseline, score or next",
        new String[0]);
    check("--out: missing", "generate");
    check("--cases: '0', expected a number in [1.0, 100000.0]", "generate", "--cases", "0");
    check("--seed: 'x', expected a whole number", "generate", "--seed", "x");
    check("--mix: 'odd:1'", "generate", "--mix", "odd:1", "--out", NOWHERE);
    check("--mix: 'none', expected kind:weight", "generate", "--mix", "none", "--out", NOWHERE);
    check("expected a weight above 0", "generate", "--mix", "none:0", "--out", NOWHERE);
    check(
        "--effects: no such effect: magic; expected one that simbad effects lists or clock-stretch, ",
        "generate",
        "--effects",
        "magic",
        "--out",
        NOWHERE);
    check(
        "--effects: wave-hop: these worlds cannot have it; expected one of absorption, ",
        "generate",
        "--effects",
        "wave-hop",
        "--out",
        NOWHERE);
    check("--withheld: no such effect: wind", "generate", "--withheld", "wind", "--out", NOWHERE);
    checkMix("gain makes a fair pair with none", "gain", "single:1,pair:1");
    checkMix("none is of the vocabulary", "speed-loss", "single:1");
    checkMix("not every one of them is fair", "gain,latency", "triple:1");
    checkMix("all are of the vocabulary", "gain", "unknown:1");
    check("expected --withheld", "generate", "--mix", "withheld:1", "--out", NOWHERE);
    check("--rows: '9'", "generate", "--rows", "9", "--out", NOWHERE);
    check("--level: 'L9', expected wave", "generate", "--level", "L9", "--out", NOWHERE);
    check("--reference: every case", "generate", "--level", "wave", "--reference", "1");
    check("--sizes: '0'", "generate", "--level", "wave", "--sizes", "0-2", "--out", NOWHERE);
    check(
        "no such effect: latency-of-mine",
        "generate",
        "--level",
        "wave",
        "--effects",
        "latency-of-mine");
    check("--what: expected one of".replace("--what", "'--what'"), "generate", "--what", "9");
    check("--cases: expected a value after it", "generate", "--cases");
    check("no such folder", "score", "--answers", folder + "/nowhere", "--truth", "x");
  }

  private static void checkMix(String message, String effects, String mix) {
    check(
        "--effects: " + message, "generate", "--effects", effects, "--mix", mix, "--out", NOWHERE);
  }

  private static void check(String message, String... arguments) {
    Done done = run(arguments);
    assertEquals(2, done.status, done.err);
    assertTrue(done.err.contains(message), done.err);
    assertEquals(1, done.err.lines().count());
  }

  /** No arrow to any room: what is checked must not share code with what checks it. */
  @Test
  void noSource_namesAnotherRoom() throws IOException {
    List<Path> sources;
    try (var paths = Files.walk(Path.of("src/main/java"))) {
      sources = paths.filter(p -> p.toString().endsWith(".java")).toList();
    }
    assertTrue(sources.size() > 40);
    for (Path source : sources) {
      for (String line : Files.readAllLines(source)) {
        assertFalse(
            line.matches(".*\\bsimbad\\.(?!blindworld\\b)[a-z]+\\..*"), source + ": " + line);
        assertFalse(
            line.startsWith("import ")
                && !line.matches("import (static )?(simbad\\.blindworld|java|org\\.jspecify)\\..*"),
            source + ": " + line);
      }
    }
  }
}
