package simbad.gui;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Path;
import java.util.Locale;
import javax.imageio.ImageIO;
import simbad.sonar.format.WholeFile;

/** Writes pictures into a folder, under the first name of a row that is not there yet. */
final class PictureFile {
  private static final int MOST = 10_000;

  private PictureFile() {}

  /**
   * Writes a picture as PNG.
   *
   * @param folder is there
   * @return the file that was made
   * @throws IOException if it cannot be written; nothing is left of it then
   */
  static Path write(Path folder, BufferedImage picture) throws IOException {
    byte[] png = png(picture);
    for (int i = 1; i < MOST; i++) {
      Path file = folder.resolve(String.format(Locale.ROOT, "simbad-world-%03d.png", i));
      if (create(file, png)) {
        return file;
      }
    }
    throw new IOException(folder + " has " + (MOST - 1) + " pictures");
  }

  private static boolean create(Path file, byte[] png) throws IOException {
    try {
      WholeFile.create(file, png);
      return true;
    } catch (FileAlreadyExistsException e) {
      return false;
    }
  }

  private static byte[] png(BufferedImage picture) throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    if (!ImageIO.write(picture, "png", bytes)) {
      throw new IOException("this Java writes no PNG");
    }
    return bytes.toByteArray();
  }

  /** Says in one line why a picture could not be written. */
  static String why(IOException failure) {
    String message = failure.getMessage();
    String cause = message == null ? failure.getClass().getSimpleName() : message;
    boolean denied = failure instanceof AccessDeniedException;
    return "no picture was written: "
        + cause.lines().findFirst().orElse("")
        + (denied ? ": this folder may not be written to" : "");
  }
}
