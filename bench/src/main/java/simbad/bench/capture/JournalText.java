package simbad.bench.capture;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.Optional;
import simbad.sonar.format.DataFormatException;

/**
 * A journal as it was read.
 *
 * @param file it was read from
 * @param entries in their order; the first one says how it was begun
 * @param wholeBytes length of the lines that are whole
 * @param torn what comes after them, a character for each byte: a last line that was cut off; empty
 *     when there is none
 * @param sha256 of the whole lines, hexadecimal
 */
public record JournalText(
    Path file, List<Entry> entries, long wholeBytes, String torn, String sha256) {
  /** Copies the list. */
  public JournalText {
    entries = List.copyOf(entries);
  }

  /** Returns how the capture was begun. */
  public Entry.Begun begun() {
    return (Entry.Begun) entries.get(0);
  }

  /**
   * Reads a journal.
   *
   * @param file journal
   * @throws DataFormatException naming the line, if one before the last is damaged, missing or
   *     there twice, or if the file is no journal
   */
  public static JournalText read(Path file) throws DataFormatException {
    byte[] bytes;
    try {
      bytes = Files.readAllBytes(file);
    } catch (NoSuchFileException e) {
      throw DataFormatException.inFile(file, "no such file");
    } catch (IOException e) {
      throw DataFormatException.inFile(file, "cannot be read: " + e.getMessage());
    }
    return parse(file, bytes);
  }

  static JournalText parse(Path file, byte[] bytes) throws DataFormatException {
    List<Entry> entries = new ArrayList<>();
    int begin = 0;
    while (begin < bytes.length) {
      int end = lineEnd(bytes, begin);
      Optional<Entry> entry = entry(bytes, begin, end, entries.size() + 1);
      boolean isLast = end + 1 >= bytes.length;
      if (entry.isEmpty() && !isLast) {
        throw DataFormatException.inField(
            file, entries.size() + 1, "line", "damaged: number or checksum does not fit");
      }
      if (entry.isEmpty()) {
        break;
      }
      entries.add(entry.get());
      begin = end + 1;
    }
    if (entries.isEmpty() || !(entries.get(0) instanceof Entry.Begun)) {
      throw DataFormatException.inFile(file, "is no journal of a capture");
    }
    String torn = new String(bytes, begin, bytes.length - begin, StandardCharsets.ISO_8859_1);
    return new JournalText(file, entries, begin, torn, hash(bytes, begin));
  }

  private static int lineEnd(byte[] bytes, int begin) {
    int end = begin;
    while (end < bytes.length && bytes[end] != '\n') {
      end++;
    }
    return end;
  }

  private static Optional<Entry> entry(byte[] bytes, int begin, int end, long number) {
    if (end == bytes.length) {
      // Without its end it is torn, however well it reads.
      return Optional.empty();
    }
    return JournalLine.parse(new String(bytes, begin, end - begin, StandardCharsets.UTF_8))
        .filter(line -> line.number() == number)
        .flatMap(Entry::of);
  }

  private static String hash(byte[] bytes, int length) {
    try {
      MessageDigest digest = MessageDigest.getInstance("SHA-256");
      digest.update(bytes, 0, length);
      return HexFormat.of().formatHex(digest.digest());
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException(e);
    }
  }
}
