package simbad.sonar.format;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class TextFileTest {
  @TempDir private Path directory = Path.of("target");

  private List<String> names() throws IOException {
    try (Stream<Path> files = Files.list(directory)) {
      return files.map(file -> String.valueOf(file.getFileName())).sorted().toList();
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "a", "a\nb\r\n", "\u00e4\u03c0\u20ac\uD83D\uDE00", "a\uFEFFb"})
  void text_goesThereAndBack(String text) throws Exception {
    Path file = directory.resolve("text");
    TextFile.write(file, text);
    assertEquals(text, TextFile.read(file));
    assertEquals(List.of("text"), names());
  }

  @Test
  void byteOrderMark_isTakenOffOnce() throws Exception {
    assertEquals("a", TextFile.read(Faults.file(directory, "\uFEFFa")));
    assertEquals("\uFEFFa", TextFile.read(Faults.file(directory, "\uFEFF\uFEFFa")));
  }

  @Test
  void content_isReplaced() throws Exception {
    Path file = directory.resolve("text");
    TextFile.write(file, "a long text of before");
    TextFile.write(file, "short");
    assertEquals("short", TextFile.read(file));
    assertEquals(List.of("text"), names());
  }

  /** A reader that had the file open goes on reading the old text: it is replaced, not refilled. */
  @Test
  void content_isReplacedAtOnce() throws Exception {
    Path file = directory.resolve("text");
    TextFile.write(file, "before");
    try (var reader = Files.newBufferedReader(file)) {
      TextFile.write(file, "after");
      assertEquals("before", reader.readLine());
    }
    assertEquals("after", TextFile.read(file));
  }

  @Test
  void nothingIsLeftBeside_whenTheTargetIsADirectory() throws Exception {
    Path occupied = Files.createDirectory(directory.resolve("text"));
    Files.createFile(occupied.resolve("content"));
    assertThrows(IOException.class, () -> TextFile.write(occupied, "a"));
    assertEquals(List.of("text"), names());
    assertEquals(true, Files.exists(occupied.resolve("content")));
  }

  /** Somebody who knows where the new text is written before it is moved could leave a link. */
  @Test
  void linkThatWasLeftThere_isNotFollowed() throws Exception {
    Path theirs = Files.writeString(directory.resolve("theirs"), "theirs");
    Files.createSymbolicLink(directory.resolve(".text.part"), theirs);
    TextFile.write(directory.resolve("text"), "mine");
    assertEquals("theirs", Files.readString(theirs));
  }

  @Test
  void linkInPlaceOfTheFile_isReplaced() throws Exception {
    Path theirs = Files.writeString(directory.resolve("theirs"), "theirs");
    Path file = Files.createSymbolicLink(directory.resolve("text"), theirs);
    TextFile.write(file, "mine");
    assertEquals("theirs", Files.readString(theirs));
    assertEquals("mine", Files.readString(file));
  }

  @Test
  void directoryThatIsNotThere_isRefused() throws Exception {
    Path file = directory.resolve("none").resolve("text");
    assertThrows(IOException.class, () -> TextFile.write(file, "a"));
    assertEquals(List.of(), names());
  }

  @Test
  void relativePath_isWrittenWhereItPoints() throws Exception {
    Path relative = Path.of("target", "relative-text-file-test");
    TextFile.write(relative, "a");
    assertEquals("a", TextFile.read(relative.toAbsolutePath()));
    Files.delete(relative);
  }
}
