package simbad.bench.capture;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.Optional;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import simbad.sonar.format.DataFormatException;

/** Goes through a journal once, line by line. */
final class JournalReader {
  private final Path file;
  private final Consumer<Entry> each;
  private final MessageDigest digest = sha256();
  private Entry.@Nullable Begun begun;
  private int bearings = SweepPlan.MOST_BEARINGS;
  private long lines;
  private long wholeBytes;

  JournalReader(Path file, Consumer<Entry> each) {
    this.file = file;
    this.each = each;
  }

  private static MessageDigest sha256() {
    try {
      return MessageDigest.getInstance("SHA-256");
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException(e);
    }
  }

  JournalText read(LineBytes from) throws IOException, DataFormatException {
    byte[] line = from.next();
    while (line.length > 0) {
      Optional<JournalLine> whole = whole(line);
      byte[] following = from.next();
      if (whole.isEmpty()) {
        if (following.length > 0) {
          throw DataFormatException.inField(
              file, lines + 1, "line", "damaged: number or checksum does not fit");
        }
        break;
      }
      take(line, entry(whole.get()));
      line = following;
    }
    if (begun == null) {
      throw noJournal();
    }
    String torn = new String(line, StandardCharsets.ISO_8859_1);
    return new JournalText(
        file, begun, lines, wholeBytes, torn, HexFormat.of().formatHex(digest.digest()));
  }

  /** A line that was written to its end, and not changed since. */
  private Optional<JournalLine> whole(byte[] line) {
    int last = line.length - 1;
    if (line[last] != '\n') {
      // Without its end it is torn, however well it reads.
      return Optional.empty();
    }
    return JournalLine.parse(new String(line, 0, last, StandardCharsets.UTF_8))
        .filter(told -> told.number() == lines + 1);
  }

  /** A checksum can be computed anew: it does not say that the fields are what they should be. */
  private Entry entry(JournalLine line) throws DataFormatException {
    try {
      return Entry.of(line, bearings);
    } catch (JournalFieldException e) {
      throw DataFormatException.inField(file, lines + 1, e.field(), e.problem());
    }
  }

  private void take(byte[] line, Entry entry) throws DataFormatException {
    if (lines == 0) {
      if (!(entry instanceof Entry.Begun first)) {
        throw noJournal();
      }
      begun = first;
      bearings = bearings(first);
    }
    lines++;
    wholeBytes += line.length;
    digest.update(line);
    each.accept(entry);
  }

  /** As many as any capture may have where it does not say; {@link CaptureSettings} complains. */
  private static int bearings(Entry.Begun begun) {
    String bearings = begun.settings().getOrDefault("bearings", "");
    return bearings.matches("[1-9]\\d{0,3}")
        ? Math.min(Integer.parseInt(bearings), SweepPlan.MOST_BEARINGS)
        : SweepPlan.MOST_BEARINGS;
  }

  private DataFormatException noJournal() {
    return DataFormatException.inFile(file, "is not a journal of a capture");
  }
}
