package simbad.bench.protocol;

import java.nio.charset.StandardCharsets;
import java.util.Locale;

/**
 * CRC-16/CCITT-FALSE: polynomial 0x1021, start 0xFFFF, neither reflected nor inverted; of {@code
 * 123456789} it is 29B1.
 */
final class Checksum {
  private static final int POLYNOMIAL = 0x1021;
  private static final int START = 0xFFFF;

  private Checksum() {}

  /** The checksum of a text in ASCII, as four hexadecimal digits. */
  static String of(String text) {
    int checksum = START;
    for (byte b : text.getBytes(StandardCharsets.ISO_8859_1)) {
      checksum ^= (b & 0xFF) << 8;
      for (int bit = 0; bit < 8; bit++) {
        checksum = (checksum & 0x8000) == 0 ? checksum << 1 : (checksum << 1) ^ POLYNOMIAL;
      }
    }
    return String.format(Locale.ROOT, "%04X", checksum & 0xFFFF);
  }
}
