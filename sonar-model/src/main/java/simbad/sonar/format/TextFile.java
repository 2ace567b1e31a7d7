package simbad.sonar.format;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.AtomicMoveNotSupportedException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;

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
    if (!Files.exists(file)) {
      throw DataFormatException.inFile(file, "no such file");
    }
    if (Files.isDirectory(file)) {
      throw DataFormatException.inFile(file, "is a directory, expected a file");
    }
    if (!Files.isRegularFile(file)) {
      // A pipe may never end, a device never does.
      throw DataFormatException.inFile(file, "is no regular file");
    }
    if (!Files.isReadable(file)) {
      throw DataFormatException.inFile(file, "cannot be read: permission denied");
    }
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
   * Writes a file: beside the target, synced, then moved over it, so that nobody sees a half.
   *
   * @param file to write; its directory must exist
   * @param text the whole content
   * @throws IOException if it cannot be written; the target is then as it was
   */
  public static void write(Path file, String text) throws IOException {
    Path target = file.toAbsolutePath();
    Path beside = target.resolveSibling("." + target.getFileName() + ".part");
    try {
      try (FileChannel channel =
          FileChannel.open(
              beside,
              StandardOpenOption.CREATE,
              StandardOpenOption.TRUNCATE_EXISTING,
              StandardOpenOption.WRITE)) {
        ByteBuffer bytes = ByteBuffer.wrap(text.getBytes(StandardCharsets.UTF_8));
        while (bytes.hasRemaining()) {
          channel.write(bytes);
        }
        channel.force(true);
      }
      move(beside, target);
    } finally {
      Files.deleteIfExists(beside);
    }
  }

  private static void move(Path from, Path to) throws IOException {
    try {
      Files.move(from, to, StandardCopyOption.ATOMIC_MOVE);
    } catch (AtomicMoveNotSupportedException e) {
      Files.move(from, to, StandardCopyOption.REPLACE_EXISTING);
    }
  }
}
