package simbad.experiments.dataset;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.Charset;
import java.nio.charset.CodingErrorAction;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Optional;
import java.util.zip.GZIPInputStream;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.TextFile;

/** The text of a log in whatever encoding it is: plain or gzip, with a byte order mark or not. */
final class LogText {
  private static final int MOST_BYTES = 256 << 20;
  private static final int SAMPLE = 1 << 16;
  private static final char BYTE_ORDER_MARK = '\uFEFF';

  /** Of a text's characters; a serial line leaves one or the other behind. */
  private static final double MOST_UNREADABLE = 0.1;

  private LogText() {}

  /**
   * Reads a log.
   *
   * @param file plain or gzip
   * @param encoding empty to find it: by a byte order mark, by the zeros of UTF-16, UTF-8 where it
   *     is valid, else Latin-1
   * @throws DataFormatException if it cannot be read, is no text or longer than 256 MB
   */
  static String read(Path file, Optional<Charset> encoding) throws DataFormatException {
    byte[] bytes = bytes(file);
    String text = new String(bytes, encoding.isPresent() ? encoding.get() : encoding(bytes));
    requireText(file, text);
    return !text.isEmpty() && text.charAt(0) == BYTE_ORDER_MARK ? text.substring(1) : text;
  }

  private static byte[] bytes(Path file) throws DataFormatException {
    TextFile.requireFile(file);
    try {
      if (Files.size(file) > MOST_BYTES) {
        throw tooLong(file);
      }
      byte[] bytes = Files.readAllBytes(file);
      return begins(bytes, 0x1f, 0x8b) ? unpacked(file, bytes) : bytes;
    } catch (IOException e) {
      throw DataFormatException.inFile(file, "cannot be read: " + e.getMessage());
    }
  }

  private static byte[] unpacked(Path file, byte[] packed) throws DataFormatException {
    try (GZIPInputStream in = new GZIPInputStream(new ByteArrayInputStream(packed))) {
      byte[] bytes = in.readNBytes(MOST_BYTES + 1);
      if (bytes.length > MOST_BYTES) {
        throw tooLong(file);
      }
      return bytes;
    } catch (IOException e) {
      throw DataFormatException.inFile(file, "is not a complete gzip file: " + e.getMessage());
    }
  }

  private static DataFormatException tooLong(Path file) {
    return DataFormatException.inFile(
        file, "is longer than " + (MOST_BYTES >> 20) + " MB, expected a log of readings");
  }

  private static boolean begins(byte[] bytes, int... with) {
    for (int i = 0; i < with.length; i++) {
      if (bytes.length <= i || (bytes[i] & 0xff) != with[i]) {
        return false;
      }
    }
    return true;
  }

  private static Charset encoding(byte[] bytes) {
    if (begins(bytes, 0xff, 0xfe)) {
      return StandardCharsets.UTF_16LE;
    }
    if (begins(bytes, 0xfe, 0xff)) {
      return StandardCharsets.UTF_16BE;
    }
    byte[] sample = Arrays.copyOf(bytes, Math.min(bytes.length, SAMPLE) & ~1);
    if (zeros(sample, 1) > sample.length / 4) {
      return StandardCharsets.UTF_16LE;
    }
    if (zeros(sample, 0) > sample.length / 4) {
      return StandardCharsets.UTF_16BE;
    }
    return isUtf8(bytes) ? StandardCharsets.UTF_8 : StandardCharsets.ISO_8859_1;
  }

  /** Of every second byte: most characters of a log are Latin. */
  private static int zeros(byte[] bytes, int from) {
    int zeros = 0;
    for (int i = from; i < bytes.length; i += 2) {
      zeros += bytes[i] == 0 && bytes[i ^ 1] != 0 ? 1 : 0;
    }
    return zeros;
  }

  private static boolean isUtf8(byte[] bytes) {
    try {
      StandardCharsets.UTF_8
          .newDecoder()
          .onMalformedInput(CodingErrorAction.REPORT)
          .decode(ByteBuffer.wrap(bytes));
      return true;
    } catch (CharacterCodingException e) {
      return false;
    }
  }

  private static void requireText(Path file, String text) throws DataFormatException {
    int length = Math.min(text.length(), SAMPLE);
    long unreadable = text.chars().limit(length).filter(LogText::isUnreadable).count();
    if (unreadable > MOST_UNREADABLE * length) {
      throw DataFormatException.inFile(
          file, "is not text: " + unreadable + " of " + length + " characters cannot be read");
    }
  }

  private static boolean isUnreadable(int character) {
    return character == '\uFFFD'
        || (Character.isISOControl(character) && !Character.isWhitespace(character));
  }
}
