package simbad.blindworld.file;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;

/** Files that are written, with faults that name them. */
public final class Output {
  private Output() {}

  /**
   * Writes a text in UTF-8.
   *
   * @param file over one that may be there
   * @param text the whole content
   * @return the file
   * @throws IOException naming the file, which Java leaves out when the disk is full
   */
  public static Path write(Path file, String text) throws IOException {
    try {
      return Files.write(file, text.getBytes(StandardCharsets.UTF_8));
    } catch (FileSystemException e) {
      throw e;
    } catch (IOException e) {
      FileSystemException named = new FileSystemException(file.toString(), null, e.getMessage());
      named.initCause(e);
      throw named;
    }
  }
}
