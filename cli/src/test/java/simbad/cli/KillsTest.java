package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import simbad.bench.board.BoardKit;

/** Real processes, ended and killed: none says more than it should, and nothing of them stays. */
@Timeout(1800)
class KillsTest {
  @TempDir Path folder = Path.of("");

  private Path temporary = Path.of("");
  private Path results = Path.of("");

  @BeforeEach
  void makeFolders() throws IOException {
    BoardKit kit = BoardKit.ofProject(Path.of(".."));
    assumeTrue(
        kit.missingPackages().isEmpty(),
        () -> "no simulated board here: missing " + kit.missingPackages());
    temporary = Files.createDirectory(folder.resolve("temporary"));
    results = Files.createDirectory(folder.resolve("results"));
  }

  private SimbadProcess start(String... arguments) throws IOException {
    List<String> command = new ArrayList<>(SimbadProcess.command(arguments));
    command.add(1, "-Djava.io.tmpdir=" + temporary);
    return SimbadProcess.start(Files.createTempDirectory(folder, "said"), "", command);
  }

  private SimbadProcess startBoard() throws IOException {
    return start("board", "--pace", "0");
  }

  private static void awaitPort(SimbadProcess board) throws Exception {
    while (!Files.readString(board.out()).contains("serial port: ")) {
      assertTrue(board.process().isAlive(), () -> "said: " + said(board));
      Thread.sleep(5);
    }
  }

  private static String said(SimbadProcess board) {
    try {
      return String.join(" | ", board.complaints());
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** All that is there of ours: not the native library of the serial port. */
  private List<String> left() throws IOException {
    List<String> names = new ArrayList<>();
    for (Path place : List.of(temporary, results)) {
      try (Stream<Path> entries = Files.list(place)) {
        entries.map(entry -> entry.getFileName().toString()).forEach(names::add);
      }
    }
    names.removeIf(name -> !name.matches("simbad-.*|imageio.*|\\..*unfinished.*"));
    return names;
  }

  /** In a hundred milliseconds the simulator sends thousands of messages. */
  @Test
  void boardsThatAreEnded_sayOneLineAndLeaveNothing() throws Exception {
    Random random = new Random(1);
    for (int i = 0; i < 4; i++) {
      SimbadProcess board = startBoard();
      awaitPort(board);
      Thread.sleep(random.nextInt(100));
      board.process().toHandle().destroy();
      assertEquals(128 + 15, board.process().waitFor());
      assertEquals(List.of("simbad: interrupted"), board.complaints());
      assertEquals(List.of(), left());
    }
  }

  @Test
  void boardThatIsKilled_isTidiedUpAfterByTheNext() throws Exception {
    SimbadProcess killed = startBoard();
    SimbadProcess other = startBoard();
    awaitPort(killed);
    awaitPort(other);
    killed.process().destroyForcibly().waitFor();
    assertEquals(4, left().size(), () -> "two folders each");
    assertEquals(0, start("board", "--pace", "0", "--for", "1").process().waitFor());
    assertEquals(2, left().size(), () -> "those of the one that runs stay");
    other.process().toHandle().destroy();
    other.process().waitFor();
    assertEquals(List.of(), left());
  }

  @Test
  @Tag("full")
  void sixtyKills_leaveNothing() throws Exception {
    Random random = new Random(7);
    int most = 0;
    for (int i = 0; i < 60; i++) {
      SimbadProcess one = startAny(i);
      Thread.sleep(300 + random.nextInt(4000));
      if (random.nextBoolean()) {
        one.process().destroyForcibly();
      } else {
        one.process().toHandle().destroy();
      }
      one.process().waitFor();
      one.complaints()
          .forEach(line -> assertFalse(line.matches(".*(Exception|fault in|\tat ).*"), line));
      most = Math.max(most, left().size());
    }
    assertTrue(most > 0, "no kill came in time");
    assertEquals(0, start("board", "--pace", "0", "--for", "1").process().waitFor());
    assertEquals(0, startRun("last").process().waitFor());
    assertEquals(List.of(), left());
  }

  private SimbadProcess startRun(String name) throws IOException {
    return start("run", "angle", "--sensor", "shadow", "--out", results.resolve(name).toString());
  }

  private SimbadProcess startAny(int number) throws IOException {
    String name = "results" + number;
    return switch (number % 4) {
      case 0 -> startBoard();
      case 1 -> startRun(name);
      case 2 ->
          start(
              "batch",
              "../data/batch/edge-follower-tuning.json",
              "--out",
              results.resolve(name).toString());
      default ->
          start(
              "bench",
              "capture",
              "--auto",
              "--obstacle",
              "angle",
              "--out",
              results.resolve(name).toString());
    };
  }
}
