package simbad.sonar.format;

import java.io.IOException;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;

/** Whole text files in UTF-8. */
public final class TextFile {
  private static final char BYTE_ORDER_MARK = '\uFEFF';

  private TextFile() {}

  /**
   * Reads a file; a byte order mark is taken off.
   *
   * @param file to read
   * @throws DataFormatException if there is none, if it is no regular file, if it cannot be read,
   *     or if it is no UTF-8 text
   */
  public static String read(Path file) throws DataFormatException {
    requireFile(file);
    try {
      String text = Files.readString(file, StandardCharsets.UTF_8);
      return !text.isEmpty() && text.charAt(0) == BYTE_ORDER_MARK ? text.substring(1) : text;
    } catch (CharacterCodingException e) {
      throw DataFormatException.inFile(file, "is not UTF-8 text");
    } catch (IOException e) {
      throw DataFormatException.inFile(file, "cannot be read: " + e.getMessage());
    }
  }

  /**
   * Checks that something can be read as a file.
   *
   * @param file to read
   * @throws DataFormatException if there is none, if it is no regular file, or if it may not be
   *     read
   */
  public static void requireFile(Path file) throws DataFormatException {
    if (!Files.exists(file)) {
      throw DataFormatException.inFile(file, "no such file");
    }
    if (Files.isDirectory(file)) {
      throw DataFormatException.inFile(file, "is a folder, expected a file");
    }
    if (!Files.isRegularFile(file)) {
      // A pipe may never end, a device never does.
      throw DataFormatException.inFile(file, "is not a regular file");
    }
    if (!Files.isReadable(file)) {
      throw DataFormatException.inFile(file, "cannot be read: permission denied");
    }
  }

  /**
   * Writes a file as {@link WholeFile} does: nobody sees a half, and no link is followed.
   *
   * @param file to write, over one that may be there; its directory must exist
   * @param text the whole content
   * @throws IOException naming the file, if it cannot be written; the target is then as it was
   */
  public static void write(Path file, String text) throws IOException {
    WholeFile.write(file, text.getBytes(StandardCharsets.UTF_8));
  }

  /**
   * Writes a file that is not there yet, otherwise as {@link #write} does.
   *
   * @param file to write; its directory must exist
   * @param text the whole content
   * @throws IOException naming the file, if it cannot be written or if something is there already
   */
  public static void create(Path file, String text) throws IOException {
    WholeFile.create(file, text.getBytes(StandardCharsets.UTF_8));
  }
}
