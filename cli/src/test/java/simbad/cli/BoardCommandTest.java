package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertAll;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simbad.bench.board.BoardKit;

@Timeout(600)
class BoardCommandTest {
  @TempDir Path folder = Path.of("");

  private static void needTools() {
    BoardKit kit = BoardKit.ofProject(Path.of(".."));
    assumeTrue(
        kit.missingPackages().isEmpty(),
        () -> "no simulated board here: missing " + kit.missingPackages());
  }

  @Test
  void scriptOfTheGuide_isPlayedToItsEnd() {
    needTools();
    Path link = folder.resolve("tty");
    Shell shell =
        Shell.simbad(
            "board",
            "--script",
            "../docs/guide/board-session.csv",
            "--pace",
            "0",
            "--for",
            "60",
            "--link",
            link.toString());
    assertEquals("", shell.err());
    assertEquals(0, shell.status());
    String[] lines = shell.out().split("\\R", -1);
    assertEquals("serial port: " + link.toAbsolutePath(), lines[0]);
    int pings = Integer.parseInt(lines[1].replace("pings: ", ""));
    // Four a second for a minute, but for the 5 s in which the line is stuck high.
    assertTrue(pings > 210 && pings < 230, shell.out());
    assertTrue(Files.notExists(link, LinkOption.NOFOLLOW_LINKS));
  }

  private void copyFirmware(Path project) throws IOException {
    Path source = Path.of("../firmware-pic18");
    for (String part : List.of(".", "dist", "gpsim", "gpsim/shim")) {
      Path to = Files.createDirectories(project.resolve("firmware-pic18").resolve(part));
      try (var entries = Files.list(source.resolve(part))) {
        for (Path file : entries.filter(Files::isRegularFile).toList()) {
          Files.copy(file, to.resolve(file.getFileName()));
        }
      }
    }
  }

  /** Of another account, or a read-only mount, in which the board was never built. */
  @Test
  void projectThatCannotBeWritten_hasItsBoardBuiltElsewhere() throws Exception {
    needTools();
    Path project = folder.resolve("project");
    copyFirmware(project);
    Path temporary = Files.createDirectory(folder.resolve("temporary"));
    List<String> command = new ArrayList<>(ReadOnly.command(project));
    for (String word : SimbadProcess.command("board", "--pace", "0", "--for", "2")) {
      command.add(word.startsWith("-Dsimbad.home") ? "-Dsimbad.home=" + project : word);
    }
    command.add(command.indexOf("-cp"), "-Djava.io.tmpdir=" + temporary);
    SimbadProcess board = SimbadProcess.start(folder, "", command);
    int status = board.process().waitFor();
    assertEquals(List.of(), board.complaints());
    assertEquals(0, status);
    assertTrue(Files.readString(board.out()).contains("pings: 8"));
    assertTrue(Files.notExists(project.resolve("firmware-pic18/target")));
    try (var left = Files.list(temporary)) {
      assertEquals(List.of(), left.toList());
    }
  }

  @Test
  void obstacleWithoutScript_isPlayed() {
    needTools();
    Shell shell =
        Shell.simbad(
            "board",
            "--obstacle",
            "angle",
            "--distance",
            "1.5",
            "--sensor",
            "noisy",
            "--for",
            "2",
            "--pace",
            "0");
    assertAll(
        () -> assertEquals("", shell.err()),
        () -> assertTrue(shell.out().contains("pings: 8"), shell.out()));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "--script nowhere.csv | --script: nowhere.csv: no such file",
        "--script ../docs/protocol.csv | ../docs/protocol.csv:1: time_s: column is missing",
        "--script x.csv --distance 1 | --script says where things stand; it does not "
            + "go with --obstacle",
        "--obstacle pots | --obstacle: 'pots': no such obstacle, expected square",
        "--distance -1 | --distance: -1.0 is not a number of at least 0",
        "--temperature -60 | --temperature: -60.0 is not in",
        "--clockwise NaN | --clockwise: NaN is not a number of degrees",
        "--sensor ears | --sensor: 'ears' is none of shadow, original, overlap, noisy, level, level-noisy",
        "--pace -1 | --pace: -1.0 is not a number of at least 0",
        "--for NaN | --for: NaN is not a number of at least 0"
      })
  void badInput_oneLineAndStatusTwo(String arguments, String message) {
    Shell shell = Shell.simbad(("board " + arguments).split(" ", -1));
    assertAll(
        () -> assertEquals(2, shell.status()),
        () -> assertEquals(1, shell.complaints().size(), shell.err()),
        () -> assertTrue(shell.err().startsWith("simbad board: " + message), shell.err()));
  }

  @Test
  void linkThatIsAFile_statusOne() throws Exception {
    needTools();
    Path file = Files.writeString(folder.resolve("mine"), "");
    Shell shell = Shell.simbad("board", "--link", file.toString(), "--for", "1");
    assertEquals(1, shell.status());
    assertTrue(shell.err().contains("mine: exists and is not a link"), shell.err());
  }

  @Test
  void flashInfo_saysFileAndChecksum() {
    Shell shell = Shell.simbad("flash-info");
    assertAll(
        () -> assertEquals(0, shell.status()),
        () -> assertTrue(shell.out().contains("ranger.hex"), shell.out()),
        () -> assertTrue(shell.out().contains("(checked)"), shell.out()));
  }
}
