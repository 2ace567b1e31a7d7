package simbad.bench.board;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.List;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import simbad.bench.protocol.FrameLine.Identity;
import simbad.bench.protocol.FrameLine.Ping;
import simbad.bench.protocol.PingStatus;
import simbad.sonar.format.Leftovers;
import simbad.sonar.model.DetectionRule;

/** The simulated board as a thing that starts, is driven, fails and ends. */
@Timeout(600)
class BoardTest {
  @TempDir Path folder = Path.of("");

  private static void needTools() {
    assumeTrue(
        TestBoard.KIT.missingPackages().isEmpty(),
        () -> "no simulated board here: missing " + TestBoard.KIT.missingPackages());
  }

  private static long workplaces() throws IOException {
    Path temporary = Path.of(System.getProperty("java.io.tmpdir"));
    // Of processes that were killed; the next board would delete it as well.
    Leftovers.sweep(temporary);
    try (Stream<Path> files = Files.list(temporary)) {
      return files.filter(f -> f.getFileName().toString().startsWith("simbad-board")).count();
    }
  }

  @Test
  void close_endsGpsimAndLeavesNoFile() throws Exception {
    needTools();
    long before = workplaces();
    Board board;
    try (TestBoard test = TestBoard.start(folder, n -> List.of(BoardOrder.distance(1)))) {
      board = test.board();
      assertTrue(board.isRunning());
      assertTrue(Files.isSymbolicLink(board.port()));
      test.serial.await(came -> came.contains("P 3 "));
    }
    assertFalse(board.isRunning());
    assertFalse(Files.exists(board.port(), LinkOption.NOFOLLOW_LINKS));
    assertEquals(before, workplaces());
  }

  /** Killed while gpsim was starting, before it had anybody to listen to. */
  @Test
  void programThatIsGoneBeforeTheRun_endsGpsim() throws Exception {
    needTools();
    BoardSetup setup = new BoardSetup(folder.resolve("tty"), 0);
    Workplace workplace = Workplace.create(TestBoard.KIT, setup);
    Process gpsim = workplace.startGpsim(TestBoard.KIT.environment());
    try {
      assertTrue(gpsim.waitFor(30, TimeUnit.SECONDS), "it runs for nobody");
    } finally {
      gpsim.destroyForcibly().waitFor();
      workplace.delete();
    }
  }

  @Test
  void stopFromTheWorld_endsInOrder() throws Exception {
    needTools();
    AtomicLong pings = new AtomicLong();
    BoardWorld world =
        new BoardWorld() {
          @Override
          public List<BoardOrder> ping(long number, double timeS) {
            pings.set(number);
            return List.of();
          }

          @Override
          public List<BoardOrder> wake(double timeS) {
            return timeS == 0
                ? List.of(BoardOrder.pace(0), BoardOrder.wakeAt(2.1))
                : List.of(BoardOrder.stop());
          }
        };
    try (Board board =
        Board.start(TestBoard.KIT, new BoardSetup(folder.resolve("tty"), 1), world)) {
      board.awaitEnd();
    }
    // Every 250 ms from the start on.
    assertEquals(9, pings.get());
  }

  @Test
  void worldThatFails_endsTheBoardAndIsTold() throws Exception {
    needTools();
    BoardWorld world =
        (number, timeS) -> {
          throw new IllegalStateException("no such obstacle");
        };
    try (Board board =
        Board.start(TestBoard.KIT, new BoardSetup(folder.resolve("tty"), 0), world)) {
      assertEquals(
          "no such obstacle",
          assertThrows(IllegalStateException.class, board::awaitEnd).getMessage());
    }
  }

  @Test
  void tenTimesRealTime_isKept() throws Exception {
    needTools();
    long begunNs = System.nanoTime();
    BoardWorld world =
        new BoardWorld() {
          @Override
          public List<BoardOrder> ping(long number, double timeS) {
            return List.of();
          }

          @Override
          public List<BoardOrder> wake(double timeS) {
            return List.of(timeS == 0 ? BoardOrder.wakeAt(10) : BoardOrder.stop());
          }
        };
    try (Board board =
        Board.start(TestBoard.KIT, new BoardSetup(folder.resolve("tty"), 10), world)) {
      board.awaitEnd();
    }
    // Not faster; how much slower is a matter of the machine.
    assertTrue(System.nanoTime() - begunNs >= 0.9e9);
  }

  @Test
  void fileInPlaceOfTheLink_isRefused() throws Exception {
    needTools();
    Path file = Files.writeString(folder.resolve("notes.txt"), "mine");
    IOException fault =
        assertThrows(
            IOException.class,
            () ->
                Board.start(TestBoard.KIT, new BoardSetup(file, 1), (number, timeS) -> List.of()));
    assertTrue(String.valueOf(fault.getMessage()).contains("notes.txt: exists and is not a link"));
    assertEquals("mine", Files.readString(file));
  }

  @Test
  void gpsimThatIsKilled_isToldAndLeavesNoFile() throws Exception {
    needTools();
    Path tty = folder.resolve("tty");
    BoardWorld world = (number, timeS) -> List.of();
    try (Board board = Board.start(TestBoard.KIT, new BoardSetup(tty, 1), world)) {
      ProcessHandle.current()
          .children()
          .filter(child -> child.info().command().orElse("").endsWith("gpsim"))
          .forEach(ProcessHandle::destroyForcibly);
      IOException fault = assertThrows(IOException.class, board::awaitEnd);
      assertTrue(String.valueOf(fault.getMessage()).contains("gpsim ended with status 137"));
    }
    assertFalse(Files.exists(tty, LinkOption.NOFOLLOW_LINKS));
  }

  @Test
  void missingTools_areNamedByTheirPackages() {
    assertEquals(
        List.of("g++", "gpsim", "make", "gpsim-dev"),
        BoardKit.missingPackages("", folder.resolve("modules.h")));
    assertEquals(List.of("g++", "gpsim", "make"), BoardKit.missingPackages("/nowhere:", folder));
  }

  @Test
  void wrongFirmwareFolder_isSaid() {
    needTools();
    IOException fault =
        assertThrows(
            IOException.class,
            () ->
                Board.start(
                    BoardKit.ofProject(folder),
                    new BoardSetup(folder.resolve("tty"), 1),
                    (number, timeS) -> List.of()));
    assertTrue(String.valueOf(fault.getMessage()).contains("is not the project's folder"));
  }

  /** All that the modules can be told, with modules that end at the first fault of memory. */
  @Test
  void modulesThatWatchThemselves_findNoFault() throws Exception {
    needTools();
    StringBuilder rows = new StringBuilder();
    int timeS = 0;
    for (BoardEvent event : BoardEvent.values()) {
      rows.append(timeS + ",post,0.6,0,0,20," + event.word() + "\n");
      timeS += 2;
    }
    BoardScript script = BoardScriptTest.parse(rows.toString());
    ScriptedBench bench =
        new ScriptedBench(
            script,
            DetectionRule.SHADOW,
            BoardScriptTest.SPEC,
            new Random(1),
            OptionalDouble.of(timeS));
    try (Board board =
            Board.start(TestBoard.KIT.watched(), new BoardSetup(folder.resolve("tty"), 1), bench);
        SerialReader serial = new SerialReader(board.port())) {
      board.order(new BoardOrder("nonsense"), new BoardOrder("fault maybe"), BoardOrder.pace(0));
      serial.type("p20\rixyz");
      board.awaitEnd();
      String text = serial.text();
      assertTrue(SerialReader.of(Identity.class, text).count() >= 4, text);
      List<PingStatus> statuses =
          SerialReader.pings(text).stream().map(Ping::status).distinct().toList();
      assertTrue(
          statuses.containsAll(List.of(PingStatus.ECHO, PingStatus.NO_ECHO, PingStatus.STUCK)));
    }
  }
}
