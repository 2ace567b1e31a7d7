package simbad.bench.capture;

import java.nio.charset.StandardCharsets;
import java.util.HexFormat;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import java.util.zip.CRC32;

/**
 * A line of a journal: {@code NUMBER,KIND,FIELD,...*CRC32}. The number counts the lines from 1, the
 * checksum is that of all before the star.
 *
 * @param number of the line
 * @param kind what it tells
 * @param fields without commas and line breaks
 */
record JournalLine(long number, String kind, List<String> fields) {
  private static final int CRC_LENGTH = 8;
  private static final Pattern NUMBER = Pattern.compile("\\d{1,15}");

  JournalLine {
    fields = List.copyOf(fields);
  }

  /** Returns a text with which a field can be made of anything. */
  static String field(String text) {
    return text.replaceAll("[,*\\p{Cntrl}]", " ").strip();
  }

  /** The line with its end. */
  String text() {
    String told = number + "," + kind + (fields.isEmpty() ? "" : "," + String.join(",", fields));
    return told + "*" + checksum(told) + "\n";
  }

  private static String checksum(String text) {
    CRC32 crc = new CRC32();
    crc.update(text.getBytes(StandardCharsets.UTF_8));
    return HexFormat.of().toHexDigits((int) crc.getValue());
  }

  /** Reads a line without its end; empty when its checksum does not fit. */
  static Optional<JournalLine> parse(String line) {
    int star = line.length() - CRC_LENGTH - 1;
    if (star < 1 || line.charAt(star) != '*') {
      return Optional.empty();
    }
    String told = line.substring(0, star);
    String[] parts = told.split(",", -1);
    if (parts.length < 2
        || !checksum(told).equals(line.substring(star + 1))
        || !NUMBER.matcher(parts[0]).matches()) {
      return Optional.empty();
    }
    return Optional.of(
        new JournalLine(
            Long.parseLong(parts[0]), parts[1], List.of(parts).subList(2, parts.length)));
  }
}
