package simbad.experiments.cli;

import static org.junit.jupiter.api.Assertions.assertAll;
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
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Random;
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
import simbad.bench.capture.JournalText;
import simbad.experiments.bench.CaptureFolder;
import simbad.obstacles.Catalogue;
import simbad.obstacles.ObstacleType;
import simbad.sonar.format.TableFile;
import simbad.sonar.model.DetectionRule;
import simbad.sonar.shape.ThresholdTable;

/** The bench's commands, with the real program in gpsim at the other end of a real port. */
@Timeout(1800)
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
    checkDone(Shell.simbad("bench", "table", at(capture), "--out", at(capture + ".csv")));
    ThresholdTable found = TableFile.read(Path.of(at(capture + ".csv"))).table();
    ThresholdTable behind = Catalogue.angleTable().table();
    assertEquals(bearings, found.size());
    for (int i = 0; i < bearings; i++) {
      assertEquals(behind.thresholdM(found.bearingRad(i)), found.valueM(i), 0.0202, "bearing " + i);
    }
  }

  @Test
  void closedLoop_twelveBearingsComeOutAsTheTableBehind() throws Exception {
    needTools();
    Shell shell =
        Shell.simbad(
            "bench",
            "capture",
            "--auto",
            "--obstacle",
            "angle",
            "--bearings",
            "12",
            "--out",
            at("angle"));
    checkDone(shell);
    assertTrue(shell.out().contains("12 of 12 bearings"), shell.out());
    checkTable("angle", 12);
    Shell compared =
        Shell.simbad(
            "bench",
            "table",
            at("angle"),
            "--out",
            at("again.csv"),
            "--compare",
            "angle",
            "--plot",
            at("angle.svg"));
    checkDone(compared);
    assertTrue(compared.out().contains("12 of 12 within the interval"), compared.out());
    assertTrue(Files.size(folder.resolve("angle.svg")) > 1000);
    checkDone(Shell.simbad("bench", "resume", at("angle")));
    checkDone(Shell.simbad("diagnose", at("angle"), "--out", at("diagnosis")));
    checkDone(Shell.simbad("table", "show", at("angle.csv")));
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

  private static Process start(String... arguments) throws IOException {
    List<String> command =
        Stream.concat(
                Stream.of(
                    Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                    "-XX:TieredStopAtLevel=1",
                    "-cp",
                    System.getProperty("java.class.path"),
                    "-Dsimbad.home=" + Path.of("..").toAbsolutePath().normalize(),
                    Main.class.getName()),
                Stream.of(arguments))
            .toList();
    return new ProcessBuilder(command)
        .redirectErrorStream(true)
        .redirectOutput(ProcessBuilder.Redirect.DISCARD)
        .start();
  }

  private static long gpsims() {
    return ProcessHandle.allProcesses()
        .filter(process -> process.info().command().orElse("").endsWith("/gpsim"))
        .filter(process -> process.parent().map(ProcessHandle::pid).orElse(1L) == 1L)
        .count();
  }

  /** Killed at random moments until it is done: what was recorded stays, byte for byte. */
  private void checkKills(int kills, long seed) throws Exception {
    Random random = new Random(seed);
    CaptureFolder capture = new CaptureFolder(folder.resolve("killed"));
    byte[] before = new byte[0];
    int killed = 0;
    while (killed < kills) {
      Process process =
          Files.exists(capture.journal())
              ? start("bench", "resume", at("killed"))
              : start(
                  "bench",
                  "capture",
                  "--auto",
                  "--obstacle",
                  "angle",
                  "--bearings",
                  "72",
                  "--out",
                  at("killed"));
      long had = before.length;
      while (process.isAlive() && grown(capture, had) < 200 + random.nextInt(6000)) {
        Thread.sleep(1 + random.nextInt(20));
      }
      process.destroyForcibly().waitFor();
      killed++;
      byte[] after = Files.readAllBytes(capture.journal());
      JournalText text = JournalText.read(capture.journal());
      assertTrue(text.wholeBytes() >= before.length, "kill " + killed);
      assertTrue(
          new String(after, StandardCharsets.ISO_8859_1)
              .startsWith(new String(before, StandardCharsets.ISO_8859_1)),
          "kill " + killed + " changed what was recorded");
      before = Arrays.copyOf(after, (int) text.wholeBytes());
    }
  }

  private static long grown(CaptureFolder capture, long had) throws IOException {
    return Files.exists(capture.journal()) ? Files.size(capture.journal()) - had : 0;
  }

  @Test
  void tenKills_loseNothingAndLeaveNoSimulator() throws Exception {
    needTools();
    long others = gpsims();
    checkKills(10, 1);
    for (int i = 0; i < 100 && gpsims() > others; i++) {
      Thread.sleep(100);
    }
    assertEquals(others, gpsims());
  }

  @Test
  @Tag("full")
  void thousandKills_loseNothing() throws Exception {
    needTools();
    checkKills(1000, 2);
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
      assertTrue(first.out().contains("not done: there must be"), first.out());
      assertTrue(first.out().contains("go on with: simbad bench resume"), first.out());
      Shell second = typing("15.5\nu\n", "bench", "resume", at("hand"), "--port", port.toString());
      checkDone(second);
      assertTrue(second.err().contains("3 readings are there, 0 of 72 bearings"), second.err());
      assertTrue(second.out().contains("does not count any more"), second.out());
      assertTrue(board.isRunning());
    }
    assertTrue(Files.readString(folder.resolve("hand/readings.csv")).contains("bearing 0"));
    Shell table = Shell.simbad("bench", "table", at("hand"), "--out", at("hand.csv"));
    assertEquals(2, table.status());
    assertTrue(table.err().contains("0 of 72 bearings are done"), table.err());
    assertFalse(Files.exists(folder.resolve("hand.csv")));
  }

  // ---------------------------------------------------------------- the guide

  /** Each command of the guide, in its order, with a board at the port that it names. */
  @Test
  void commandsOfTheGuide_work() throws Exception {
    needTools();
    Files.writeString(folder.resolve("numbers.txt"), "49\n".repeat(72));
    ObstacleType post = Catalogue.types().get(0);
    BenchScene scene =
        new BenchScene(
            Optional.of(new BenchTarget(post.outline(), post.thresholds().table())), 0.15, 0, 0);
    TurntableBench bench =
        new TurntableBench(DetectionRule.SHADOW, Catalogue.srf04(), new Random(1), scene, 20);
    Path port = folder.resolve("tty");
    int commands = 0;
    try (Board board = Board.start(KIT, new BoardSetup(port, 1), bench)) {
      for (String line : Files.readAllLines(Path.of("../docs/guide/bench.md"))) {
        if (line.startsWith("    ./simbad ")) {
          String[] words = line.strip().substring("./simbad ".length()).split(" +", -1);
          for (int i = 1; i < words.length; i++) {
            words[i] = words[i].replace("/dev/ttyUSB0", port.toString());
            words[i] = words[i].matches("(my|old|numbers).*") ? at(words[i]) : words[i];
          }
          Shell shell = typing("15\nq\n", words);
          assertEquals(0, shell.status(), line + ": " + shell.err());
          commands++;
        }
      }
      assertTrue(board.isRunning());
    }
    assertEquals(9, commands);
  }

  // ---------------------------------------------------------------- wrong

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "2 | capture --obstacle angle --out x | exactly one of --port and --auto",
        "2 | capture --auto --obstacle pots --out x | OBSTACLE 'pots'",
        "2 | capture --auto --obstacle angle --out x --bearings 2 | bearings = 2.0 is not in",
        "2 | capture --auto --obstacle angle --out x --pings 3 --misses 4 | misses = 4.0",
        "2 | capture --auto --obstacle angle --out x --temperature 99 | temperatureC = 99.0",
        "2 | capture --auto --obstacle angle --out x --sensor ears | --sensor: 'ears' is none",
        "2 | capture --auto --obstacle angle --out ../docs | ../docs",
        "1 | capture --port /dev/ttyNOWHERE --obstacle angle --out x | /dev/ttyNOWHERE: there is no",
        "1 | ports /dev/ttyNOWHERE | /dev/ttyNOWHERE: there is no such port",
        "2 | resume nowhere | journal.txt: no such file",
        "2 | table nowhere --out x.csv | journal.txt: no such file",
        "2 | table nowhere --out ../README.md | README.md",
        "2 | import nowhere.txt --obstacle angle --out x.csv | nowhere.txt: no such file",
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
