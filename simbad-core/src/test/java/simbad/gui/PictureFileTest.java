package simbad.gui;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class PictureFileTest {
  private final BufferedImage picture = new BufferedImage(3, 2, BufferedImage.TYPE_INT_RGB);

  @Test
  void names_goOn_andNothingIsOverwritten(@TempDir Path folder) throws IOException {
    Path taken = folder.resolve("simbad-world-002.png");
    Files.writeString(taken, "mine");
    assertEquals(folder.resolve("simbad-world-001.png"), PictureFile.write(folder, picture));
    Path third = PictureFile.write(folder, picture);
    assertEquals(folder.resolve("simbad-world-003.png"), third);
    assertEquals("mine", Files.readString(taken));
    assertEquals(3, ImageIO.read(third.toFile()).getWidth());
  }

  @Test
  void folderThatIsNotThere_isSaidInOneLine(@TempDir Path folder) {
    Path nowhere = folder.resolve("nowhere");
    IOException failure =
        assertThrows(IOException.class, () -> PictureFile.write(nowhere, picture));
    String why = PictureFile.why(failure);
    assertTrue(why.startsWith("no picture was written: "), why);
    assertTrue(why.contains("nowhere"), why);
    assertEquals(1, why.lines().count());
    assertFalse(Files.exists(nowhere));
  }

  @Test
  void cause_isSaidInOneLine() {
    assertEquals(
        "no picture was written: simbad-world-001.png: No space left on device",
        PictureFile.why(new IOException("simbad-world-001.png: No space left on device\nnow")));
    assertEquals(
        "no picture was written: a.png: this folder may not be written to",
        PictureFile.why(new AccessDeniedException("a.png")));
    assertEquals("no picture was written: IOException", PictureFile.why(new IOException()));
  }
}
