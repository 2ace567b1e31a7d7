package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertAll;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.ExecutionException;
import java.util.stream.Stream;
import javax.vecmath.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import simbad.obstacles.Catalogue;
import simbad.obstacles.ObstacleType;
import simbad.obstacles.SonarObstacle;
import simbad.sim.EnvironmentDescription;
import simbad.sim.World;
import simbad.sonar.format.DataFormatException;

class MainTest {
  /** What a test subcommand does. */
  @FunctionalInterface
  interface Work {
    void of(Probe probe) throws Exception;
  }

  @Command(
      name = "probe",
      description = "A subcommand of the tests.",
      footer = "%nExample: simbad probe --depth 3")
  static final class Probe extends Subcommand {
    private final Work work;

    @Option(names = "--depth", description = "How deep.")
    private int depth;

    Probe(Work work) {
      this.work = work;
    }

    @Override
    protected void run() throws Exception {
      work.of(this);
    }
  }

  @Command(name = "group", description = "A group of the tests.")
  static final class Group extends CommandGroup {}

  record Outcome(int status, String out, String err) {}

  private static Outcome simbad(Work work, String... arguments) {
    StringWriter out = new StringWriter();
    StringWriter err = new StringWriter();
    int status =
        Main.run(
            List.of(new Probe(work), new Group()),
            new PrintWriter(out, true),
            new PrintWriter(err, true),
            arguments);
    return new Outcome(status, out.toString(), err.toString());
  }

  private static Outcome simbad(String... arguments) {
    return simbad(probe -> probe.out().println("depth " + probe.depth), arguments);
  }

  private static void checkComplaint(Outcome outcome, int status, String line) {
    assertAll(
        () -> assertEquals(line + System.lineSeparator(), outcome.err()),
        () -> assertEquals("", outcome.out()),
        () -> assertEquals(status, outcome.status()));
  }

  @Test
  void subcommandRuns_statusZero() {
    assertEquals(
        new Outcome(0, "depth 3" + System.lineSeparator(), ""), simbad("probe", "--depth", "3"));
  }

  /** Who made the world can mend it: that is no fault in the program. */
  @Test
  void overlapInAnOwnWorld_isBadInput() {
    EnvironmentDescription own = new EnvironmentDescription();
    ObstacleType plate = Catalogue.find("plate").orElseThrow();
    own.add(new SonarObstacle(new Vector3d(0, 0, 0), 0, plate));
    own.add(new SonarObstacle(new Vector3d(0.01, 0, 0), 0, plate));
    checkComplaint(
        simbad(probe -> probe.out().print(new World(own)), "probe"),
        2,
        "simbad probe: obstacle plate at x 0.01000, z 0.000 m overlaps obstacle plate at x 0.000,"
            + " z 0.000 m");
  }

  @ParameterizedTest
  @ValueSource(strings = {"--help", "-h", "help"})
  void help_listsTheCommands(String argument) {
    Outcome outcome = simbad(argument);
    assertAll(
        () -> assertEquals(0, outcome.status()),
        () -> assertEquals("", outcome.err()),
        () -> assertTrue(outcome.out().contains("probe  A subcommand of the tests.")),
        () -> assertTrue(outcome.out().contains("Example: simbad COMMAND --help")));
  }

  @Test
  void helpOfSubcommand_isTheSameInThreeWays() {
    Outcome outcome = simbad("probe", "-h");
    assertAll(
        () -> assertEquals(0, outcome.status()),
        () -> assertTrue(outcome.out().contains("Example: simbad probe --depth 3")),
        () -> assertEquals(outcome, simbad("probe", "--help")),
        () -> assertEquals(outcome, simbad("help", "probe")));
  }

  @Test
  void version_namesVersionAndCommit() {
    Outcome outcome = simbad("--version");
    assertEquals(0, outcome.status());
    assertTrue(
        outcome
            .out()
            .strip()
            .matches(
                "simbad \\d+\\.\\d+\\.\\d+\\S* \\(commit ([0-9a-f]{40}(\\+changes)?|unknown)\\)"),
        outcome.out());
  }

  @Test
  void wrongUsage_oneLineAndStatusTwo() {
    checkComplaint(
        simbad("prob"),
        2,
        "simbad: unknown command or argument 'prob'; did you mean probe? (see simbad --help)");
    checkComplaint(simbad("--nix"), 2, "simbad: unknown option '--nix' (see simbad --help)");
    checkComplaint(
        simbad("probe", "--dept", "3"),
        2,
        "simbad probe: unknown option '--dept'; did you mean --depth?"
            + " (see simbad probe --help)");
    checkComplaint(
        simbad("probe", "--depth", "x"),
        2,
        "simbad probe: Invalid value for option '--depth': 'x' is not a whole number"
            + " (see simbad probe --help)");
    checkComplaint(
        simbad("probe", "--depth", "12345678901"),
        2,
        "simbad probe: Invalid value for option '--depth': '12345678901' is too large"
            + " (see simbad probe --help)");
    checkComplaint(
        simbad("help", "nix"), 2, "simbad: Unknown subcommand 'nix'. (see simbad --help)");
  }

  /** Who types the bare name wants to know what there is; the status says that nothing was done. */
  @ParameterizedTest
  @CsvSource({"'', simbad, probe  A subcommand of the tests.", "group, simbad group, A group of"})
  void groupAlone_showsItsHelpAndWhatIsMissing(String arguments, String name, String help) {
    Outcome outcome = simbad(arguments.isEmpty() ? new String[0] : arguments.split(" ", -1));
    List<String> said = outcome.err().lines().toList();
    assertAll(
        () -> assertEquals(2, outcome.status()),
        () -> assertEquals("", outcome.out()),
        () -> assertTrue(said.get(0).startsWith("Usage: " + name), outcome.err()),
        () -> assertTrue(outcome.err().contains(help), outcome.err()),
        () ->
            assertEquals(
                name + ": a command is missing (see " + name + " --help)",
                said.get(said.size() - 1)));
  }

  /** Not the help of something else. */
  @ParameterizedTest
  @ValueSource(strings = {"--help", "-h", "--version", "--help --nix"})
  void helpOfNoCommand_isRefused(String asked) {
    checkComplaint(
        simbad(("prob " + asked).split(" ", -1)),
        2,
        "simbad: unknown command or argument 'prob'; did you mean probe? (see simbad --help)");
    if (!asked.equals("--version")) {
      checkComplaint(
          simbad(("group gruop " + asked).split(" ", -1)),
          2,
          "simbad group: unknown command or argument 'gruop' (see simbad group --help)");
    }
  }

  /** Whoever mistyped an option and asks for help gets the help. */
  @Test
  void helpBesideAnUnknownOption_isHelp() {
    assertEquals(simbad("probe", "--help"), simbad("probe", "--nix", "--help"));
    assertEquals(simbad("--help"), simbad("--nix", "--help"));
  }

  /** One place shortens what is echoed: no complaint fills the screen. */
  @Test
  void longValue_isNotEchoedWhole() {
    String longest = "x".repeat(70_000);
    for (String[] line :
        List.of(
            new String[] {longest},
            new String[] {"--" + longest},
            new String[] {"probe", longest},
            new String[] {"probe", "--depth", longest},
            new String[] {"probe", "--depth=" + longest},
            new String[] {"help", longest})) {
      Outcome outcome = simbad(line);
      assertEquals(2, outcome.status());
      assertTrue(outcome.err().length() < 500, outcome.err());
      assertTrue(outcome.err().contains("xxx...xxx"), outcome.err());
      assertTrue(outcome.err().strip().endsWith("--help)"), outcome.err());
    }
  }

  @Test
  void longFault_keepsItsEnds() {
    Outcome outcome =
        simbad(
            probe -> {
              throw new IOException("begin " + "x".repeat(70_000) + "\u001b[2J end");
            },
            "probe");
    assertTrue(outcome.err().startsWith("simbad probe: begin xxx"), outcome.err());
    assertTrue(outcome.err().strip().endsWith("xxx [2J end"), outcome.err());
    assertTrue(outcome.err().length() < 1100, outcome.err());
  }

  static Stream<Arguments> faults() {
    Path file = Path.of("a.csv");
    return Stream.of(
        Arguments.of(
            DataFormatException.inField(file, 3, "range_m", "-1 is negative"),
            2,
            "a.csv:3: range_m: -1 is negative"),
        Arguments.of(new NoSuchFileException("a.csv"), 2, "a.csv: there is no such file"),
        Arguments.of(new AccessDeniedException("a.csv"), 2, "a.csv: permission denied"),
        Arguments.of(new FileAlreadyExistsException("out"), 2, "out: exists already"),
        Arguments.of(new IOException("No space left on device"), 1, "No space left on device"),
        Arguments.of(new IOException(), 1, "IOException"),
        Arguments.of(new IOException("two\n  lines"), 1, "two lines"),
        Arguments.of(new UncheckedIOException(new IOException("port gone")), 1, "port gone"),
        Arguments.of(
            new ExecutionException(new NoSuchFileException("b")), 2, "b: there is no such file"),
        Arguments.of(new InterruptedException("stopped"), 1, "stopped"),
        Arguments.of(
            new IllegalStateException("odd"),
            1,
            "a fault in the program: java.lang.IllegalStateException: odd (SIMBAD_TRACE=1 shows"
                + " where)"));
  }

  @ParameterizedTest
  @MethodSource("faults")
  void fault_oneLineAndItsStatus(Exception fault, int status, String line) {
    Outcome outcome =
        simbad(
            probe -> {
              throw fault;
            },
            "probe");
    checkComplaint(outcome, status, "simbad probe: " + line);
  }

  @Test
  void error_isReportedLikeAnException() {
    Outcome outcome =
        simbad(
            probe -> {
              throw new StackOverflowError();
            },
            "probe");
    checkComplaint(
        outcome,
        1,
        "simbad: a fault in the program: java.lang.StackOverflowError"
            + " (SIMBAD_TRACE=1 shows where)");
  }

  @ParameterizedTest
  @ValueSource(strings = {"probe --trace", "--trace probe"})
  void trace_showsTheStackWhereverTheOptionStands(String arguments) {
    Outcome outcome =
        simbad(
            probe -> {
              throw new IOException("port gone");
            },
            arguments.split(" ", -1));
    assertAll(
        () -> assertEquals(1, outcome.status()),
        () -> assertTrue(outcome.err().startsWith("simbad probe: port gone"), outcome.err()),
        () -> assertTrue(outcome.err().contains("\tat " + MainTest.class.getName())));
  }

  @Test
  void complaints_workGoesOnAndTheWorstCounts() {
    Outcome outcome =
        simbad(
            probe -> {
              probe.complain(DataFormatException.inFile(Path.of("a"), "is empty"));
              probe.complain(new IOException("b fails"));
              probe.out().println("done");
            },
            "probe");
    assertAll(
        () -> assertEquals(2, outcome.status()),
        () ->
            assertEquals(
                List.of("simbad probe: a: is empty", "simbad probe: b fails"),
                outcome.err().lines().toList()),
        () -> assertEquals("done", outcome.out().strip()));
  }

  /** What {@code --help} ends with when standard output fails. */
  private static Outcome withFailingOutput(String reason) {
    StringWriter err = new StringWriter();
    OutputStream failing =
        new PipeOutput(
            new OutputStream() {
              @Override
              public void write(int b) throws IOException {
                throw new IOException(reason);
              }
            });
    PrintWriter out = new PrintWriter(failing, true, StandardCharsets.UTF_8);
    int status = Main.run(List.of(), out, new PrintWriter(err, true), "--help");
    return new Outcome(status, "", err.toString());
  }

  @Test
  void standardOutputIsFull_statusOne() {
    checkComplaint(
        withFailingOutput("No space left on device"), 1, "simbad: cannot write to standard output");
  }

  @Test
  void readerHasReadEnough_isNoFailure() {
    assertEquals(new Outcome(0, "", ""), withFailingOutput("Broken pipe"));
  }
}
