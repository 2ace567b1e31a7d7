package simbad.sonar.format;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** What a killed process left is deleted; what any other may still need is not. */
class LeftoversTest {
  private static final Owner HERE = Owner.current();

  @TempDir Path folder = Path.of("");

  private List<String> names() throws IOException {
    try (Stream<Path> entries = Files.list(folder)) {
      return entries.map(entry -> entry.getFileName().toString()).sorted().toList();
    }
  }

  private static Owner gone() throws Exception {
    Process process = new ProcessBuilder("true").start();
    process.waitFor();
    return new Owner(process.pid(), HERE.start(), HERE.boot(), HERE.machine());
  }

  private Path leave(String stem, Owner owner) throws IOException {
    Path left = folder.resolve(stem + "-" + owner.mark() + "-7");
    Files.createDirectories(left.resolve("deep"));
    Files.writeString(left.resolve("deep/file"), "half");
    return left;
  }

  @Test
  void owner_isReadBackFromItsMark() {
    assertEquals(Optional.of(HERE), Owner.parse(HERE.mark()));
    assertEquals(Optional.empty(), Owner.parse("12-34"));
    assertEquals(Optional.empty(), Owner.parse(HERE.mark() + "-1"));
  }

  @Test
  void processThatRuns_isNotGone() {
    assertFalse(HERE.isGone());
    assertTrue(HERE.start() > 0);
  }

  /** Without its start, the process that has the number now would be taken for the owner. */
  @Test
  void numberThatAnotherProcessHasNow_isGone() {
    assertTrue(new Owner(HERE.pid(), HERE.start() - 1, HERE.boot(), HERE.machine()).isGone());
  }

  @Test
  void otherBootIsGone_otherMachineIsNotKnown() {
    assertTrue(new Owner(HERE.pid(), HERE.start(), "000000", HERE.machine()).isGone());
    assertFalse(new Owner(HERE.pid(), HERE.start(), HERE.boot(), "000000").isGone());
    assertFalse(new Owner(HERE.pid(), HERE.start() - 1, "000000", "000000").isGone());
  }

  /** A process that has ended, whose parent has not asked how. */
  @Test
  @EnabledOnOs(OS.LINUX)
  void processOfWhichOnlyItsStatusIsLeft_isGone() throws Exception {
    Process parent = new ProcessBuilder("sh", "-c", "sleep 0.1 & echo $!; exec sleep 60").start();
    try (BufferedReader said = parent.inputReader()) {
      long pid = Long.parseLong(said.readLine());
      String[] stat = Files.readString(Path.of("/proc/" + pid + "/stat")).split(" ", -1);
      Owner child = new Owner(pid, Long.parseLong(stat[21]), HERE.boot(), HERE.machine());
      while (!child.isGone()) {
        Thread.sleep(10);
      }
    } finally {
      parent.destroyForcibly();
    }
  }

  @Test
  void sweep_deletesWhatIsOfAProcessThatIsGone() throws Exception {
    leave("simbad-board", gone());
    leave(".out.unfinished", gone());
    Files.writeString(folder.resolve(".file.part-" + gone().mark() + "-12"), "half");
    Leftovers.sweep(folder);
    assertEquals(List.of(), names());
  }

  @Test
  void sweep_leavesAllElse() throws Exception {
    leave("simbad-board", HERE);
    leave("elsewhere", new Owner(1, 1, HERE.boot(), "abcdef"));
    Files.createDirectory(folder.resolve(".out.unfinished-4711"));
    Files.createDirectory(folder.resolve("results-2024-11-22-1"));
    Files.writeString(folder.resolve("table.csv"), "");
    List<String> before = names();
    Leftovers.sweep(folder);
    assertEquals(before, names());
  }

  @Test
  void sweep_followsNoLink() throws Exception {
    Path mine = Files.createDirectory(folder.resolve("mine"));
    Files.writeString(mine.resolve("kept"), "");
    Path left = leave("simbad-port", gone());
    Files.createSymbolicLink(left.resolve("tty"), mine);
    Files.createSymbolicLink(folder.resolve("link-" + gone().mark() + "-1"), mine);
    Leftovers.sweep(folder);
    assertEquals(List.of("mine"), names());
    assertTrue(Files.exists(mine.resolve("kept")));
  }

  @Test
  void folderThatIsNotThere_isNothingToSweep() {
    Leftovers.sweep(folder.resolve("nowhere"));
  }

  @Test
  void names_areAllDifferent() {
    String first = Leftovers.name("a");
    assertNotEquals(first, Leftovers.name("a"));
  }

  @Test
  void temporaryFolder_isGoneWhenClosedAndSweepsBefore() throws Exception {
    leave("simbad-old", gone());
    Path path;
    try (TemporaryFolder temporary = TemporaryFolder.in(folder, "simbad-new")) {
      path = temporary.path();
      Files.createSymbolicLink(path.resolve("tty"), Path.of("/nowhere"));
      Files.createDirectories(path.resolve("a/b"));
      assertEquals(List.of(path.getFileName().toString()), names());
      assertTrue(path.getFileName().toString().startsWith("simbad-new-" + HERE.mark() + "-"));
      assertEquals("rwx------", PosixFilePermissions.toString(Files.getPosixFilePermissions(path)));
    }
    assertEquals(List.of(), names());
  }

  /** Who can write to the system's folder of temporary files can foresee the name. */
  @Test
  void temporaryFolder_whoseNameIsTaken_getsAnother() throws Exception {
    String last = Leftovers.name("taken");
    int at = last.lastIndexOf('-') + 1;
    long number = Long.parseLong(last.substring(at));
    Path taken = Files.createDirectory(folder.resolve(last.substring(0, at) + (number + 1)));
    try (TemporaryFolder temporary = TemporaryFolder.in(folder, "taken")) {
      assertEquals(last.substring(0, at) + (number + 2), temporary.path().getFileName().toString());
    }
    assertTrue(Files.exists(taken));
  }

  @Test
  void temporaryFolder_whereNoneCanBe_isRefused() {
    assertThrows(IOException.class, () -> TemporaryFolder.in(folder.resolve("nowhere"), "x"));
  }
}
