package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertAll;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.concurrent.Callable;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simbad.bench.board.BenchScene;
import simbad.bench.board.BenchTarget;
import simbad.bench.board.Board;
import simbad.bench.board.BoardKit;
import simbad.bench.board.BoardSetup;
import simbad.bench.board.TurntableBench;
import simbad.bench.capture.SweepState;
import simbad.experiments.bench.CaptureFolder;
import simbad.obstacles.Catalogue;
import simbad.obstacles.ObstacleType;
import simbad.sonar.format.TableFile;
import simbad.sonar.model.DetectionRule;
import simbad.sonar.shape.ThresholdTable;

/** The bench's commands, with the real program in gpsim at the other end of a real port. */
@Timeout(5400)
class BenchCommandTest {
  private static final BoardKit KIT = BoardKit.ofProject(Path.of(".."));

  @TempDir Path folder = Path.of("");

  private static void needTools() {
    assumeTrue(
        KIT.missingPackages().isEmpty(),
        () -> "no simulated board here: missing " + KIT.missingPackages());
  }

  private String at(String name) {
    return folder.resolve(name).toString();
  }

  private static void checkDone(Shell shell) {
    assertEquals(0, shell.status(), shell.err());
  }

  /** Every bearing of the table within the step of the search and the clock's of 0.2 mm. */
  private void checkTable(String capture, int bearings) throws Exception {
    checkTable(folder.resolve(capture), bearings);
  }

  private static void checkTable(Path capture, int bearings) throws Exception {
    String file = capture + "-now.csv";
    checkDone(Shell.simbad("bench", "table", capture.toString(), "--out", file));
    ThresholdTable found = TableFile.read(Path.of(file)).table();
    ThresholdTable behind = Catalogue.angleTable().table();
    assertEquals(bearings, found.size());
    for (int i = 0; i < bearings; i++) {
      assertEquals(behind.thresholdM(found.bearingRad(i)), found.valueM(i), 0.0202, "bearing " + i);
    }
  }

  /** Steps of 118 us, no checksum: the same thresholds, for they are distances of the tape. */
  @Test
  void closedLoop_inTheThesissMode() throws Exception {
    needTools();
    checkDone(
        Shell.simbad(
            ("bench capture --auto --mode thesis --obstacle angle --bearings 3 --pings 3 --out "
                    + at("thesis"))
                .split(" ")));
    checkTable("thesis", 3);
    String table = Files.readString(folder.resolve("thesis-now.csv"));
    assertTrue(table.contains("# source: simulated board, shadow model; journal sha256 "), table);
    assertTrue(table.contains("# clock: 118.0 us a step, taken in its middle\n"), table);
    try (Stream<String> rows = Files.lines(folder.resolve("thesis/journal.txt"))) {
      assertTrue(
          rows.filter(row -> row.contains(",echo,"))
              .allMatch(
                  row -> Integer.parseInt(row.replaceFirst(".*echo,(\\d+),.*", "$1")) % 118 == 59));
    }
    String scene = Files.readString(folder.resolve("thesis/scene.json"));
    assertTrue(scene.contains("0.0202"), scene);
  }

  @Test
  @Tag("full")
  void closedLoop_allSeventyTwoBearings() throws Exception {
    needTools();
    checkDone(
        Shell.simbad("bench", "capture", "--auto", "--obstacle", "angle", "--out", at("whole")));
    checkTable("whole", 72);
  }

  // ---------------------------------------------------------------- killed

  private static long gpsims() {
    return ProcessHandle.allProcesses()
        .filter(process -> process.info().command().orElse("").endsWith("/gpsim"))
        .filter(process -> process.parent().map(ProcessHandle::pid).orElse(1L) == 1L)
        .count();
  }

  /** How long a process lives: until it has written so much, or for a while in which it begins. */
  private static void letLive(Process process, CaptureFolder capture, long had, Random random)
      throws Exception {
    if (random.nextInt(4) == 0) {
      Thread.sleep(random.nextInt(1500));
      return;
    }
    long until = had + 1 + random.nextInt(3000);
    while (process.isAlive() && size(capture) < until) {
      Thread.sleep(1 + random.nextInt(20));
    }
  }

  private static long size(CaptureFolder capture) throws IOException {
    return Files.exists(capture.journal()) ? Files.size(capture.journal()) : 0;
  }

  private static SimbadProcess goingOn(Path where, CaptureFolder capture, int bearings)
      throws IOException {
    String words =
        Files.exists(capture.journal())
            ? "resume " + capture.path()
            : "capture --auto --obstacle angle --bearings %d --out %s"
                .formatted(bearings, capture.path());
    return SimbadProcess.start(where, "", ("bench " + words).split(" ", -1));
  }

  /** Killed at random moments, then left alone: what was recorded stays, byte for byte. */
  private static Void checkKills(Path where, int kills, int bearings, Random random)
      throws Exception {
    CaptureFolder capture = new CaptureFolder(where.resolve("killed"));
    byte[] before = new byte[0];
    for (int kill = 1; kill <= kills; kill++) {
      Process process = goingOn(where, capture, bearings).process();
      letLive(process, capture, before.length, random);
      process.destroyForcibly().waitFor();
      before = checkKept(capture, before, "kill " + kill);
    }
    SimbadProcess last = goingOn(where, capture, bearings);
    assertEquals(0, last.process().waitFor(), () -> "complaints in " + last.err());
    checkKept(capture, before, "the end");
    checkTable(capture.path(), bearings);
    SweepState state = capture.read().state();
    for (int bearing = 0; bearing < bearings; bearing++) {
      state.levels(bearing).forEach(level -> assertEquals(10, level.pings()));
    }
    return null;
  }

  /** The whole lines that are there, when they begin with those that were. */
  private static byte[] checkKept(CaptureFolder capture, byte[] before, String when)
      throws Exception {
    if (!Files.exists(capture.journal())) {
      assertEquals(0, before.length, when);
      return before;
    }
    byte[] after = Files.readAllBytes(capture.journal());
    long whole = capture.read().text().wholeBytes();
    assertTrue(whole >= before.length, when);
    assertArrayEquals(before, Arrays.copyOf(after, before.length), when);
    return Arrays.copyOf(after, (int) whole);
  }

  @Test
  void fourKills_loseNothingAndLeaveNoSimulator() throws Exception {
    needTools();
    long others = gpsims();
    checkKills(folder, 4, 4, new Random(1));
    for (int i = 0; i < 100 && gpsims() > others; i++) {
      Thread.sleep(100);
    }
    // Those of other tests may have ended meanwhile.
    assertTrue(gpsims() <= others);
  }

  /** Two captures at once: most of the time is that in which programs begin. */
  @Test
  @Tag("full")
  void thousandKills_loseNothing() throws Exception {
    needTools();
    List<Callable<Void>> halves = new ArrayList<>();
    for (int half = 0; half < 2; half++) {
      Path where = Files.createDirectory(folder.resolve("half" + half));
      Random random = new Random(2 + half);
      halves.add(() -> checkKills(where, 500, 72, random));
    }
    Concurrently.run(halves);
  }

  // ---------------------------------------------------------------- by hand

  private static Shell typing(String lines, String... arguments) {
    InputStream before = System.in;
    System.setIn(new ByteArrayInputStream(lines.getBytes(StandardCharsets.UTF_8)));
    try {
      return Shell.simbad(arguments);
    } finally {
      System.setIn(before);
    }
  }

  /** The obstacle stays; a post 1 m away is heard, whatever the person types. */
  @Test
  void captureByHand_isJournalledAndGoneOnWith() throws Exception {
    needTools();
    ObstacleType post = Catalogue.types().get(0);
    TurntableBench bench =
        new TurntableBench(
            DetectionRule.SHADOW,
            Catalogue.srf04(),
            new Random(1),
            new BenchScene(
                Optional.of(new BenchTarget(post.outline(), post.thresholds().table())),
                0.15,
                0,
                0),
            20);
    Path port = folder.resolve("tty");
    try (Board board = Board.start(KIT, new BoardSetup(port, 1), bench)) {
      Shell ports = Shell.simbad("bench", "ports", port.toString());
      assertTrue(ports.out().contains("simbad-ranger 1.0"), ports.out() + ports.err());
      Shell first =
          typing(
              "15\n\nt 21\nq\n",
              "bench",
              "capture",
              "--port",
              port.toString(),
              "--obstacle",
              post.name(),
              "--pings",
              "3",
              "--out",
              at("hand"));
      checkDone(first);
      assertTrue(first.out().contains("3 of 3 heard at 15.0 cm"), first.out());
      assertTrue(first.out().contains("not done: this bearing needs"), first.out());
      assertTrue(first.out().contains("to continue: simbad bench resume"), first.out());
      Shell second = typing("15.5\nu\n", "bench", "resume", at("hand"), "--port", port.toString());
      checkDone(second);
      assertTrue(second.err().contains("3 readings are there, 0 of 72 bearings"), second.err());
      assertTrue(second.out().contains("no longer counts"), second.out());
      assertTrue(board.isRunning());
    }
    assertTrue(Files.readString(folder.resolve("hand/readings.csv")).contains("bearing 0"));
    Shell table = Shell.simbad("bench", "table", at("hand"), "--out", at("hand.csv"));
    assertEquals(2, table.status());
    assertTrue(table.err().contains("0 of 72 bearings are done"), table.err());
    assertFalse(Files.exists(folder.resolve("hand.csv")));
  }

  // ---------------------------------------------------------------- the guide

  /** The same at fewer bearings: pings take their time. */
  @Test
  void commandsOfTheGuide_work() throws Exception {
    checkGuide("3");
  }

  @Test
  @Tag("full")
  void commandsOfTheGuide_work_atLength() throws Exception {
    checkGuide("12");
  }

  /**
   * Each command of the guide, in its order, with a board at the port that it names.
   *
   * @param bearings of the capture that the guide takes at 12
   */
  private void checkGuide(String bearings) throws Exception {
    needTools();
    Files.writeString(folder.resolve("numbers.txt"), "49\n".repeat(72));
    Files.createDirectory(folder.resolve("my-diagnosis"));
    Files.writeString(
        folder.resolve("my-diagnosis/next-experiment.csv"),
        "run,sensor,t_s,x_m,z_m,heading_deg\nnext-1,s,0,0,0.5,90\nnext-1,s,1,0,0.5,90\n");
    ObstacleType post = Catalogue.types().get(0);
    BenchScene scene =
        new BenchScene(
            Optional.of(new BenchTarget(post.outline(), post.thresholds().table())), 0.15, 0, 0);
    TurntableBench bench =
        new TurntableBench(DetectionRule.SHADOW, Catalogue.srf04(), new Random(1), scene, 20);
    Path port = folder.resolve("tty");
    String within = bearings + " of " + bearings + " within";
    int commands = 0;
    try (Board board = Board.start(KIT, new BoardSetup(port, 1), bench)) {
      for (String line : Files.readAllLines(Path.of("../docs/guide/bench.md"))) {
        if (line.startsWith("    ./simbad ")) {
          String[] words = line.strip().substring("./simbad ".length()).split(" +", -1);
          for (int i = 1; i < words.length; i++) {
            words[i] = words[i].replace("/dev/ttyUSB0", port.toString());
            words[i] = words[i].matches("(my|old|numbers).*") ? at(words[i]) : words[i];
            words[i] = words[i].equals("12") ? bearings : words[i];
          }
          Shell shell = typing("15\nq\n", words);
          assertEquals(0, shell.status(), line + ": " + shell.err());
          assertTrue(!line.contains("--compare") || shell.out().contains(within), line);
          commands++;
        }
      }
      assertTrue(board.isRunning());
    }
    assertEquals(11, commands);
    checkTable("my-trial", Integer.parseInt(bearings));
    checkDone(Shell.simbad("bench", "resume", at("my-trial")));
  }

  // ---------------------------------------------------------------- wrong

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "2 | capture --obstacle angle --out x | exactly one of --port and --auto",
        "2 | capture --auto --obstacle pots --out x | --obstacle: 'pots': no such obstacle",
        "2 | capture --auto --obstacle angle --out x --bearings 2 | --bearings: 2.0 is not in",
        "2 | capture --auto --obstacle angle --out x --pings 3 --misses 4 | --misses: 4.0",
        "2 | capture --auto --obstacle angle --out x --temperature 99 | --temperature: 99.0",
        "2 | capture --auto --obstacle angle --out x --sensor ears | --sensor: 'ears' is none",
        "2 | capture --auto --obstacle angle --out x --mode ears | --mode: 'ears' is neither",
        "2 | capture --auto --obstacle angle --out ../docs | ../docs",
        "1 | capture --port /dev/ttyNOWHERE --obstacle angle --out x | /dev/ttyNOWHERE: there is"
            + " no",
        "1 | capture --port nowhere --obstacle angle --out x | bench capture: --port: /",
        "1 | ports /dev/ttyNOWHERE | /dev/ttyNOWHERE: there is no such port",
        "2 | resume nowhere | journal.txt: no such file",
        "2 | table nowhere --out x.csv | journal.txt: no such file",
        "2 | table nowhere --out ../README.md | README.md",
        "2 | import nowhere.txt --obstacle angle --out x.csv | FILE: nowhere.txt: no such file",
        "2 | import ../README.md --obstacle angle --out x.csv | README.md:",
        "2 | import ../README.md --obstacle angle --out ../LICENSE | LICENSE"
      })
  void badInput_oneLineAndItsStatus(int status, String arguments, String message) {
    Shell shell = Shell.simbad(("bench " + arguments).split(" ", -1));
    assertAll(
        () -> assertEquals(status, shell.status(), shell.err()),
        () -> assertEquals(1, shell.complaints().size(), shell.err()),
        () -> assertTrue(shell.err().contains(message), shell.err()));
  }

  @Test
  void numbersOfTheThesis_becomeATable() throws Exception {
    Files.writeString(folder.resolve("numbers.txt"), "49\n".repeat(72));
    checkDone(
        Shell.simbad(
            "bench", "import", at("numbers.txt"), "--obstacle", "angle", "--out", at("old.csv")));
    assertEquals(72, TableFile.read(folder.resolve("old.csv")).table().size());
  }
}
