package simbad.figures.site;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class FigureBlocksTest {
  private static final Path PROJECT = Path.of("..");
  private static final String PAGE =
      """
      before
      <!-- figures: speed -->
      %s<!-- end of figures -->
      after
      """;

  @TempDir
  @SuppressWarnings("NullAway.Init")
  private Path folder;

  @Test
  void filled_puts_whatIsMeasured_inItsBlock() throws IOException {
    Files.writeString(folder.resolve("speed.txt"), "1 $2\n\n3\n");
    origins("speed,0123abc,2026-11-24,cli");
    String filled = FigureBlocks.filled(PAGE.formatted("old\n"), folder);
    assertEquals(PAGE.formatted("\n    1 $2\n\n    3\n\nMeasured at commit 0123abc.\n"), filled);
    assertEquals(filled, FigureBlocks.filled(filled, folder));
  }

  @Test
  void filled_puts_oneLine_withinALine() throws IOException {
    Files.writeString(folder.resolve("share.txt"), "97 $1 of 100\n");
    origins("share,0123abc,2026-11-24,cli gap");
    String row =
        "| a | <!-- figure: share -->%s<!-- end --> | <!-- figure: share -->%s<!-- end --> |";
    assertEquals(
        row.formatted("97 $1 of 100 (0123abc)", "97 $1 of 100 (0123abc)"),
        FigureBlocks.filled(row.formatted("", "old"), folder));
  }

  private void origins(String row) throws IOException {
    Files.writeString(folder.resolve("origins.csv"), "figure,commit,date,folders\n" + row + "\n");
  }

  @Test
  void filled_figureWithoutOrigin_isRefused() throws IOException {
    Files.writeString(folder.resolve("speed.txt"), "1\n");
    origins("other,0123abc,2026-11-24,cli");
    IOException none =
        assertThrows(IOException.class, () -> FigureBlocks.filled(PAGE.formatted(""), folder));
    assertTrue(none.toString().contains("has no row of figure speed"), none.toString());
    origins("speed,yesterday,2026-11-24,cli");
    IOException wrong =
        assertThrows(IOException.class, () -> FigureBlocks.filled(PAGE.formatted(""), folder));
    assertTrue(
        wrong.toString().contains("origins.csv, line 2: \"speed,yesterday"), wrong.toString());
  }

  @Test
  void filled_blockWithoutFile_isRefused() {
    assertThrows(NoSuchFileException.class, () -> FigureBlocks.filled(PAGE.formatted(""), folder));
  }

  /** Who changes a figure by hand, or measures anew and forgets the page, learns of it here. */
  @Test
  void readme_showsWhatWasMeasured() throws IOException {
    String readme = Files.readString(PROJECT.resolve("README.md"));
    assertTrue(readme.contains("<!-- figures: main-job -->"));
    assertEquals(readme, FigureBlocks.filled(readme, PROJECT.resolve("docs/figures")));
  }

  @Test
  void readme_isShort() throws IOException {
    assertTrue(Files.readAllLines(PROJECT.resolve("README.md")).size() < 150);
  }
}
