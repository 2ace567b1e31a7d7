package simbad.sonar.format;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class WholeFileTest {
  private static final byte[] NEW = "new".getBytes(StandardCharsets.UTF_8);

  @TempDir private Path directory = Path.of("target");

  private Path file = Path.of("");

  @BeforeEach
  void name() {
    file = directory.resolve("file");
  }

  private List<String> names() throws IOException {
    try (Stream<Path> files = Files.list(directory)) {
      return files.map(one -> String.valueOf(one.getFileName())).sorted().toList();
    }
  }

  /** What is under way has a name that differs each time, and hides. */
  @Test
  void fileUnderWay_hasANameThatNobodyKnowsBefore() throws Exception {
    TreeSet<String> seen = new TreeSet<>();
    for (int i = 0; i < 2; i++) {
      WholeFile.write(
          file,
          channel -> {
            channel.write(ByteBuffer.wrap(NEW));
            seen.addAll(names());
          });
    }
    seen.remove("file");
    assertEquals(2, seen.size());
    // By lot, then by whose it is, so that it can be swept once its process is gone.
    String own = "[.]unfinished-[0-9a-f-]{36}-" + ProcessHandle.current().pid() + "-[0-9a-f-]+";
    assertTrue(seen.stream().allMatch(name -> name.matches(own)), seen.toString());
    assertEquals(List.of("file"), names());
  }

  /** As Java reports a full disk: without a word on which file it was. */
  @Test
  void fullDisk_namesTheFileAndLeavesNothing() throws Exception {
    Files.writeString(file, "before");
    IOException fault =
        assertThrows(
            IOException.class,
            () ->
                WholeFile.write(
                    file,
                    channel -> {
                      channel.write(ByteBuffer.wrap(NEW));
                      throw new IOException("No space left on device");
                    }));
    assertEquals(file + ": No space left on device", fault.getMessage());
    assertEquals("before", Files.readString(file));
    assertEquals(List.of("file"), names());
  }

  @Test
  void contentThatIsNotThere_leavesNothing() throws Exception {
    assertThrows(
        DataFormatException.class,
        () ->
            WholeFile.write(
                file,
                channel -> {
                  channel.write(ByteBuffer.wrap(NEW));
                  throw DataFormatException.inArgument("source", "gone");
                }));
    assertEquals(List.of(), names());
  }

  @Test
  void create_leavesWhatIsThere() throws Exception {
    WholeFile.create(file, NEW);
    assertThrows(FileAlreadyExistsException.class, () -> WholeFile.create(file, new byte[0]));
    assertEquals("new", Files.readString(file));
    Path link = Files.createSymbolicLink(directory.resolve("link"), directory.resolve("nowhere"));
    FileAlreadyExistsException refused =
        assertThrows(FileAlreadyExistsException.class, () -> WholeFile.create(link, NEW));
    assertEquals(link.toString(), refused.getFile());
    assertEquals(List.of("file", "link"), names());
  }
}
