package simbad.experiments.bag;

import java.io.IOException;
import java.nio.BufferUnderflowException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;

/**
 * Reads a message in the Common Data Representation that ROS 2 stores (OMG DDSI-RTPS, version 1 of
 * the encoding): numbers stand at multiples of their size, counted from behind the four bytes that
 * say their order.
 */
final class Cdr {
  private static final int HEAD = 4;
  private static final int LONGEST_TEXT = 1 << 16;

  /** Farther apart no two frames are, metres; sums and squares of it are numbers still. */
  private static final double FARTHEST = 1e9;

  private final ByteBuffer bytes;

  /**
   * Begins to read.
   *
   * @param message with its four leading bytes
   * @throws IOException if these name no plain encoding
   */
  Cdr(ByteBuffer message) throws IOException {
    bytes = message.slice();
    if (bytes.remaining() < HEAD || bytes.get(0) != 0 || (bytes.get(1) & ~1) != 0) {
      throw new IOException("is not in plain CDR");
    }
    bytes.order(bytes.get(1) == 1 ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN);
    bytes.position(HEAD);
  }

  private void align(int size) throws IOException {
    int over = (bytes.position() - HEAD) % size;
    skip(over == 0 ? 0 : size - over);
  }

  /** Passes over bytes. */
  void skip(int count) throws IOException {
    if (count < 0 || count > bytes.remaining()) {
      throw new IOException("ends too soon");
    }
    bytes.position(bytes.position() + count);
  }

  int unsignedByte() throws IOException {
    try {
      return bytes.get() & 0xff;
    } catch (BufferUnderflowException e) {
      throw new IOException("ends too soon", e);
    }
  }

  int integer() throws IOException {
    align(Integer.BYTES);
    try {
      return bytes.getInt();
    } catch (BufferUnderflowException e) {
      throw new IOException("ends too soon", e);
    }
  }

  float single() throws IOException {
    return Float.intBitsToFloat(integer());
  }

  double real() throws IOException {
    align(Double.BYTES);
    try {
      return bytes.getDouble();
    } catch (BufferUnderflowException e) {
      throw new IOException("ends too soon", e);
    }
  }

  /** Reads a text, which is stored with its length and a zero behind. */
  String text() throws IOException {
    int length = integer();
    if (length < 0 || length > LONGEST_TEXT || length > bytes.remaining()) {
      throw new IOException("has a text of " + Integer.toUnsignedString(length) + " bytes");
    }
    byte[] text = new byte[length];
    bytes.get(text);
    int end = length > 0 && text[length - 1] == 0 ? length - 1 : length;
    return new String(text, 0, end, StandardCharsets.UTF_8);
  }

  /** Reads how many items follow, each of which takes some bytes at least. */
  int count(int leastBytes) throws IOException {
    int count = integer();
    if (count < 0 || (long) count * leastBytes > bytes.remaining()) {
      throw new IOException("has a list of " + Integer.toUnsignedString(count) + " items");
    }
    return count;
  }

  /** Reads a time stamp, nanoseconds since 1970. */
  long stampNs() throws IOException {
    long seconds = integer();
    return seconds * 1_000_000_000L + Integer.toUnsignedLong(integer());
  }

  /** Reads translation and rotation. */
  Rigid rigid() throws IOException {
    double[] numbers = new double[7];
    for (int i = 0; i < numbers.length; i++) {
      numbers[i] = real();
      if (!Double.isFinite(numbers[i])) {
        throw new IOException("has a pose that is not a number");
      }
      if (Math.abs(numbers[i]) > FARTHEST) {
        throw new IOException("has a pose with " + numbers[i] + ", expected at most " + FARTHEST);
      }
    }
    return Rigid.of(numbers);
  }
}
