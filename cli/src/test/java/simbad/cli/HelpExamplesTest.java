package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;
import static org.junit.jupiter.api.DynamicTest.dynamicTest;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import picocli.CommandLine;
import simbad.bench.board.BenchScene;
import simbad.bench.board.BenchTarget;
import simbad.bench.board.Board;
import simbad.bench.board.BoardKit;
import simbad.bench.board.BoardSetup;
import simbad.bench.board.TurntableBench;
import simbad.gap.diagnosis.DataSetFolder;
import simbad.obstacles.Catalogue;
import simbad.obstacles.ObstacleType;
import simbad.sonar.model.DetectionRule;

/**
 * Every example of every command's help, typed in a folder that holds what the example takes for
 * granted and nothing else. What is not run, and why, stands in {@code help/not-run.txt}.
 */
@Timeout(1800)
class HelpExamplesTest {
  private static final Path PROJECT = Path.of("..");
  private static final BoardKit KIT = BoardKit.ofProject(PROJECT);
  private static final String EXAMPLE = "Example: ";
  private static final String PORT = "/dev/ttyUSB0";
  private static final List<String> OUTPUTS = List.of("--out", "--plot");

  @TempDir
  @SuppressWarnings("NullAway.Init")
  private Path folder;

  @TempDir
  @SuppressWarnings("NullAway.Init")
  private Path prepared;

  @SuppressWarnings("NullAway.Init")
  private GuideShell shell;

  @SuppressWarnings("NullAway.Init")
  private HelpInputs inputs;

  @BeforeEach
  void open() throws IOException {
    shell = GuideShell.in(folder, PROJECT.resolve("data"), PROJECT.resolve("docs"));
    inputs = new HelpInputs(prepared);
  }

  @AfterEach
  void close() throws IOException {
    shell.close();
  }

  private static List<String> examples() {
    return commands(Main.commandLine(Subcommands.all()))
        .flatMap(command -> Arrays.stream(command.getCommandSpec().usageMessage().footer()))
        .flatMap(footer -> String.format(footer).lines())
        .filter(line -> line.startsWith(EXAMPLE))
        .map(line -> line.substring(EXAMPLE.length()))
        .distinct()
        .toList();
  }

  private static Stream<CommandLine> commands(CommandLine command) {
    return Stream.concat(
        Stream.of(command),
        command.getSubcommands().values().stream().flatMap(HelpExamplesTest::commands));
  }

  private static Optional<GuideRule> rule(String example) throws IOException {
    return GuideRule.all("help").stream().filter(it -> it.subject().equals(example)).findFirst();
  }

  @TestFactory
  Stream<DynamicTest> everyExample_works() {
    assertTrue(examples().size() > 50, "few examples: " + examples());
    return examples().stream().map(example -> dynamicTest(example, () -> check(example)));
  }

  /** Those that take minutes. */
  @Tag("full")
  @TestFactory
  Stream<DynamicTest> everyLongExample_works() throws IOException {
    return GuideRule.all("help").stream()
        .filter(rule -> rule.way() == GuideRule.Way.LONG)
        .map(rule -> dynamicTest(rule.subject(), () -> run(rule.subject())));
  }

  @Test
  void everyLineOfTheList_isAnExample() throws IOException {
    List<String> listed = GuideRule.all("help").stream().map(GuideRule::subject).toList();
    assertEquals(listed.stream().distinct().toList(), listed);
    assertEquals(List.of(), listed.stream().filter(line -> !examples().contains(line)).toList());
  }

  private void check(String example) throws Exception {
    Optional<GuideRule> rule = rule(example);
    if (rule.isEmpty()) {
      run(example);
    } else if (rule.get().way() != GuideRule.Way.SHOWN) {
      Main.commandLine(Subcommands.all()).parseArgs(words(example).toArray(String[]::new));
      checkProjectsFiles(example);
    }
    if (rule.isPresent() && rule.get().way() == GuideRule.Way.TESTED) {
      rule.get().checkTest();
    }
  }

  /** Without the program's name, and what a shell does with its output. */
  private static List<String> words(String example) {
    String line = example.replaceFirst("^simbad ?", "").replaceFirst(" > .*", "");
    return Stream.of(GuideShell.words(line)).toList();
  }

  /** What is named of the project must be there, however long the example takes. */
  private void checkProjectsFiles(String example) throws Exception {
    for (String word : words(example)) {
      if (word.matches("(data|docs)/.*")) {
        Shell found = shell.bash("ls -d " + word);
        assertEquals(0, found.status(), word + ": " + found.out());
      }
    }
  }

  private void run(String example) throws Exception {
    clear();
    inputs.make(folder, words(example));
    if (example.contains(PORT)) {
      checkAtBoard(example);
    } else if (example.startsWith("simbad board ") && !example.contains("--for ")) {
      checkUntilItIsEnded(example);
    } else {
      boolean needsShell = example.contains(" > ") || example.contains("*");
      Shell said =
          needsShell
              ? shell.bash("HOME=$PWD\n" + program() + "\n" + example)
              : shell.type(example.replaceFirst("^simbad ?", ""));
      assertEquals(0, said.status(), said.out() + said.err());
    }
    checkOutputs(words(example));
  }

  private static String program() {
    String command =
        SimbadProcess.command().stream()
            .map(word -> "'" + word + "'")
            .collect(Collectors.joining(" "));
    return "simbad() { " + command + " \"$@\"; }";
  }

  private void checkOutputs(List<String> words) {
    for (int i = 0; i + 1 < words.size(); i++) {
      if (OUTPUTS.contains(words.get(i))) {
        assertTrue(Files.exists(folder.resolve(words.get(i + 1))), words.get(i + 1));
      }
    }
  }

  /** Only the project's own folders stay. */
  private void clear() throws IOException {
    try (Stream<Path> entries = Files.walk(folder)) {
      for (Path entry : entries.sorted(Comparator.reverseOrder()).toList()) {
        boolean isOfTheProject = Files.isSymbolicLink(entry) && folder.equals(entry.getParent());
        if (!isOfTheProject && !entry.equals(folder)) {
          Files.delete(entry);
        }
      }
    }
  }

  private static void needBoard() {
    assumeTrue(KIT.missingPackages().isEmpty(), () -> "missing " + KIT.missingPackages());
  }

  private SimbadProcess start(String typed, List<String> words) throws IOException {
    Path said = Files.createTempDirectory(prepared, "said");
    // The program starts where the example is typed.
    List<String> command =
        Stream.concat(
                Stream.of("env", "-C", folder.toString()),
                SimbadProcess.command(words.toArray(String[]::new)).stream())
            .toList();
    return SimbadProcess.start(said, typed, command);
  }

  /** The simulated board stands where the example has a real one. */
  private void checkAtBoard(String example) throws Exception {
    needBoard();
    Path port = prepared.resolve("tty");
    TurntableBench bench =
        new TurntableBench(DetectionRule.SHADOW, Catalogue.srf04(), new Random(1), standing(), 20);
    try (Board board = Board.start(KIT, new BoardSetup(port, 0), bench)) {
      List<String> words =
          words(example).stream().map(word -> word.replace(PORT, port.toString())).toList();
      SimbadProcess simbad = start(example.contains(" measure ") ? "\n\n" : "15\nq\n", words);
      assertTrue(simbad.process().waitFor(10, TimeUnit.MINUTES));
      assertEquals(0, simbad.process().exitValue(), simbad.complaints().toString());
      assertTrue(board.isRunning());
    }
  }

  /** The angle, 15 cm away: what is typed for a distance fits. */
  private static BenchScene standing() {
    ObstacleType angle = Catalogue.find("angle").orElseThrow();
    return new BenchScene(
        Optional.of(new BenchTarget(angle.outline(), angle.thresholds().table())), 0.15, 0, 0);
  }

  private void checkUntilItIsEnded(String example) throws Exception {
    needBoard();
    SimbadProcess simbad = start("", words(example));
    try {
      while (Files.size(simbad.out()) == 0) {
        assertTrue(simbad.process().isAlive(), simbad.complaints().toString());
        Thread.sleep(50);
      }
      assertTrue(Files.readString(simbad.out()).contains("serial port: /"), "no port is said");
    } finally {
      simbad.process().destroy();
    }
    assertTrue(simbad.process().waitFor(1, TimeUnit.MINUTES));
    assertFalse(simbad.process().isAlive());
  }

  /** What the shell makes of the stars is data sets, and nothing that lies beside them. */
  @Test
  void starsOfDiagnose_areDataSets() throws Exception {
    List<String> starred =
        examples().stream()
            .filter(example -> example.startsWith("simbad diagnose "))
            .flatMap(example -> words(example).stream())
            .filter(word -> word.contains("*"))
            .toList();
    assertEquals(1, starred.size());
    Shell named = shell.bash("printf '%s\\n' " + starred.get(0));
    List<String> folders = named.out().lines().toList();
    assertTrue(folders.size() >= 7, named.out());
    for (String name : folders) {
      new DataSetFolder(folder.resolve(name)).read();
    }
  }
}
