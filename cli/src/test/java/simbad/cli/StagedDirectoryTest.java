package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

class StagedDirectoryTest {
  @TempDir
  @SuppressWarnings("NullAway.Init")
  private Path parent;

  private List<String> names() throws IOException {
    try (Stream<Path> entries = Files.list(parent)) {
      return entries.map(entry -> entry.getFileName().toString()).sorted().toList();
    }
  }

  private static void writeResult(StagedDirectory staged) throws IOException {
    Files.createDirectories(staged.path().resolve("plots"));
    Files.writeString(staged.path().resolve("plots/polar.svg"), "<svg/>");
  }

  @Test
  void published_appearsUnderItsNameOnly() throws IOException {
    Path target = parent.resolve("a/b");
    try (StagedDirectory staged = StagedDirectory.beside(target)) {
      writeResult(staged);
      assertFalse(Files.exists(target));
      staged.publish();
      assertThrows(IllegalStateException.class, staged::publish);
    }
    assertEquals("<svg/>", Files.readString(target.resolve("plots/polar.svg")));
    try (Stream<Path> entries = Files.list(target.getParent())) {
      assertEquals(List.of(target), entries.toList());
    }
  }

  @Test
  void notPublished_leavesNothing() throws IOException {
    try (StagedDirectory staged = StagedDirectory.beside(parent.resolve("out"))) {
      writeResult(staged);
    }
    assertEquals(List.of(), names());
  }

  @Test
  void targetExists_emptyIsReplacedAnythingElseIsKept() throws IOException {
    Path target = Files.createDirectory(parent.resolve("out"));
    try (StagedDirectory staged = StagedDirectory.beside(target)) {
      writeResult(staged);
      staged.publish();
    }
    assertThrows(FileAlreadyExistsException.class, () -> StagedDirectory.beside(target));
    Path file = Files.writeString(parent.resolve("file"), "");
    assertThrows(FileAlreadyExistsException.class, () -> StagedDirectory.beside(file));
    assertEquals(List.of("file", "out"), names());
  }

  /** The complaint names what was typed, not the directory beside it that nobody typed. */
  @Test
  @EnabledOnOs(OS.LINUX)
  void placeThatTakesNoDirectory_isNamedAsTyped() {
    Path target = Path.of("/proc/results");
    FileSystemException refused =
        assertThrows(FileSystemException.class, () -> StagedDirectory.beside(target));
    assertEquals("/proc/results: no directory can be made there", refused.getMessage());
  }

  @Test
  void targetFilledMeanwhile_isKept() throws IOException {
    Path target = parent.resolve("out");
    try (StagedDirectory staged = StagedDirectory.beside(target)) {
      writeResult(staged);
      Files.createDirectory(target);
      Files.writeString(target.resolve("theirs"), "");
      assertThrows(FileAlreadyExistsException.class, staged::publish);
    }
    assertEquals(List.of("out"), names());
    assertTrue(Files.exists(target.resolve("theirs")));
  }

  /** Writes one file, says so, and waits to be interrupted. */
  static final class Endless {
    private Endless() {}

    public static void main(String... arguments) throws Exception {
      try (StagedDirectory staged = StagedDirectory.beside(Path.of(arguments[0]))) {
        writeResult(staged);
        System.out.println("written");
        TimeUnit.MINUTES.sleep(5);
      }
    }
  }

  private Process endless() throws IOException {
    return new ProcessBuilder(
            SimbadProcess.java(Endless.class.getName(), parent.resolve("out").toString()))
        .redirectError(ProcessBuilder.Redirect.INHERIT)
        .start();
  }

  @Test
  void processKilled_isTidiedUpAfterByTheNext() throws Exception {
    Process process = endless();
    try (BufferedReader output = process.inputReader()) {
      assertEquals("written", output.readLine());
      StagedDirectory.beside(parent.resolve("other")).close();
      assertEquals(1, names().size(), "what a running process writes stays");
    } finally {
      process.destroyForcibly().waitFor();
    }
    assertEquals(1, names().size());
    StagedDirectory.beside(parent.resolve("other")).close();
    assertEquals(List.of(), names());
  }

  /** By SIGTERM, which takes the way of Ctrl-C; a parent that ignores SIGINT would hand that on. */
  @Test
  void processInterrupted_leavesNothing() throws Exception {
    Process process = endless();
    try (BufferedReader output = process.inputReader()) {
      assertEquals("written", output.readLine());
      assertEquals(1, names().size());
      process.destroy();
      assertTrue(process.waitFor(1, TimeUnit.MINUTES));
    } finally {
      process.destroyForcibly();
    }
    assertEquals(128 + 15, process.exitValue());
    assertEquals(List.of(), names());
  }
}
