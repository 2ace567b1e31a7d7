package simbad.bench.capture;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.function.Consumer;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.TextFile;

/**
 * What is known of a journal when it has been read.
 *
 * @param file it was read from
 * @param begun its first entry, which says how it was begun
 * @param lines how many are whole
 * @param wholeBytes length of the lines that are whole
 * @param torn what comes after them, a character for each byte: a last line that was cut off; empty
 *     when there is none
 * @param sha256 of the whole lines, hexadecimal
 */
public record JournalText(
    Path file, Entry.Begun begun, long lines, long wholeBytes, String torn, String sha256) {
  /**
   * Reads a journal, in the same little memory however long it is.
   *
   * @param file journal
   * @param each is given every entry, in their order; before a fault in a later line is found, too
   * @throws DataFormatException naming the line, if one before the last is damaged, missing or
   *     there twice, or if the file is no journal
   */
  public static JournalText read(Path file, Consumer<Entry> each) throws DataFormatException {
    TextFile.requireFile(file);
    try (InputStream in = Files.newInputStream(file)) {
      return new JournalReader(file, each).read(new LineBytes(in));
    } catch (IOException e) {
      throw DataFormatException.inFile(file, "cannot be read: " + e.getMessage());
    }
  }
}
