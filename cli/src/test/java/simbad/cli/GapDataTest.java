package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** data/gap is what the commands on its page make. */
class GapDataTest {
  private static final Path DATA = Path.of("..", "data");

  @TempDir
  @SuppressWarnings("NullAway.Init")
  private Path folder;

  @Test
  void commandsOfThePage_makeTheSameBytes() throws Exception {
    Path made = Files.createDirectories(folder.resolve("data/gap"));
    int commands = 0;
    try (GuideShell shell = GuideShell.in(folder, DATA.resolve("logs"))) {
      for (GuidePiece piece : GuidePiece.of(DATA.resolve("gap/README.md"))) {
        for (String line : piece.commands()) {
          if (!piece.kind().equals(GuidePiece.SPAN)) {
            Shell said = shell.type(line.replace("./simbad ", ""));
            assertEquals(0, said.status(), line + ": " + said.err());
            commands++;
          }
        }
      }
    }
    List<Path> files = files(made);
    assertEquals(2 * commands, files.size(), "a scene and readings of each");
    for (Path file : files) {
      Path kept = DATA.resolve("gap").resolve(made.relativize(file));
      assertEquals(-1, Files.mismatch(file, kept), file.toString());
    }
  }

  private static List<Path> files(Path made) throws Exception {
    try (Stream<Path> found = Files.walk(made)) {
      return found.filter(Files::isRegularFile).toList();
    }
  }
}
