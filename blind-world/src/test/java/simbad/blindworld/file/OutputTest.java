package simbad.blindworld.file;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class OutputTest {
  @TempDir private Path folder = Path.of("target");

  private List<String> names() throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      return files.map(one -> String.valueOf(one.getFileName())).sorted().toList();
    }
  }

  @Test
  void file_isReplaced_linksAreNotFollowed() throws IOException {
    Path theirs = Files.writeString(folder.resolve("theirs"), "theirs");
    Path file = Files.createSymbolicLink(folder.resolve("file"), theirs);
    Output.write(file, "mine");
    assertEquals("mine", Files.readString(file));
    assertEquals("theirs", Files.readString(theirs));
    assertEquals(List.of("file", "theirs"), names());
  }

  @Test
  void fileThatCannotBeWritten_isNamedAndLeavesNothing() throws IOException {
    Path occupied = folder.resolve("file");
    Files.createDirectories(occupied.resolve("content"));
    IOException fault = assertThrows(IOException.class, () -> Output.write(occupied, "mine"));
    assertTrue(String.valueOf(fault.getMessage()).startsWith(occupied + ": "), fault::toString);
    assertEquals(List.of("file"), names());
    Path nowhere = folder.resolve("nowhere/file");
    NoSuchFileException missing =
        assertThrows(NoSuchFileException.class, () -> Output.write(nowhere, "mine"));
    assertEquals(folder.resolve("nowhere").toString(), missing.getFile());
  }
}
