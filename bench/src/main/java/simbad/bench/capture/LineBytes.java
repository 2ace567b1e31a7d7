package simbad.bench.capture;

import java.io.IOException;
import java.io.InputStream;
import java.util.Arrays;

/** Takes a stream apart into lines, of whatever bytes, in little memory however long it is. */
final class LineBytes {
  /** A journal's line has some hundred bytes, its first one the lengths of a few paths more. */
  private static final int LONGEST = 1 << 16;

  private final InputStream in;
  private final byte[] buffer = new byte[LONGEST];
  private int begin;
  private int end;

  LineBytes(InputStream in) {
    this.in = in;
  }

  /**
   * Returns the next line with its end. What the stream ends in has none, nor has each part of a
   * line of more than 65536 bytes. Empty at the end of the stream.
   */
  byte[] next() throws IOException {
    int at = begin;
    while (true) {
      while (at < end && buffer[at] != '\n') {
        at++;
      }
      if (at < end) {
        return take(at + 1);
      }
      at -= begin;
      if (!fill()) {
        return take(end);
      }
    }
  }

  private byte[] take(int to) {
    byte[] line = Arrays.copyOfRange(buffer, begin, to);
    begin = to;
    return line;
  }

  /**
   * Moves what is left to the front and reads more behind it; false when there is none or no room.
   */
  private boolean fill() throws IOException {
    System.arraycopy(buffer, begin, buffer, 0, end - begin);
    end -= begin;
    begin = 0;
    int count = end == LONGEST ? 0 : in.read(buffer, end, LONGEST - end);
    end += Math.max(0, count);
    return count > 0;
  }
}
