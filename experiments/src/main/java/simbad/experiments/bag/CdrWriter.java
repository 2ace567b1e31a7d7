package simbad.experiments.bag;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;

/** Writes a message as {@link Cdr} reads it, in little-endian order. */
final class CdrWriter {
  private static final byte[] HEAD = {0, 1, 0, 0};
  private static final long NS = 1_000_000_000L;

  private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();

  CdrWriter() {
    bytes.writeBytes(HEAD);
  }

  private CdrWriter put(int size, long value) {
    while ((bytes.size() - HEAD.length) % size != 0) {
      bytes.write(0);
    }
    ByteBuffer number = ByteBuffer.allocate(Long.BYTES).order(ByteOrder.LITTLE_ENDIAN);
    bytes.write(number.putLong(value).array(), 0, size);
    return this;
  }

  CdrWriter unsignedByte(int value) {
    return put(1, value);
  }

  CdrWriter integer(int value) {
    return put(Integer.BYTES, value);
  }

  CdrWriter single(float value) {
    return put(Float.BYTES, Float.floatToIntBits(value));
  }

  CdrWriter real(double value) {
    return put(Double.BYTES, Double.doubleToLongBits(value));
  }

  CdrWriter text(String text) {
    byte[] letters = text.getBytes(StandardCharsets.UTF_8);
    integer(letters.length + 1);
    bytes.writeBytes(letters);
    bytes.write(0);
    return this;
  }

  CdrWriter stamp(long timeNs) {
    return integer((int) (timeNs / NS)).integer((int) (timeNs % NS));
  }

  byte[] bytes() {
    return bytes.toByteArray();
  }
}
