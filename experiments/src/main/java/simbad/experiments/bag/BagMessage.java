package simbad.experiments.bag;

import io.airlift.compress.zstd.ZstdInputStream;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/**
 * One message as it is stored.
 *
 * @param topic on which it was sent
 * @param type such as sensor_msgs/msg/Range
 * @param timeNs when it was recorded, nanoseconds
 * @param data in CDR; valid during the call that brings it
 */
record BagMessage(String topic, String type, long timeNs, ByteBuffer data) {
  private static final int ZSTD = 0xfd2fb528;
  private static final int MOST_BYTES = 1 << 26;

  /** Returns the same with data that are not packed; rosbag2 can pack messages one by one. */
  BagMessage unpacked() throws IOException {
    ByteBuffer little = data.slice().order(ByteOrder.LITTLE_ENDIAN);
    if (little.remaining() < Integer.BYTES || little.getInt(0) != ZSTD) {
      return this;
    }
    byte[] packed = new byte[little.remaining()];
    little.get(packed);
    try (InputStream stream = new ZstdInputStream(new ByteArrayInputStream(packed))) {
      byte[] plain = stream.readNBytes(MOST_BYTES);
      return new BagMessage(topic, type, timeNs, ByteBuffer.wrap(plain));
    } catch (RuntimeException e) {
      throw new IOException("a message packed with zstd is broken", e);
    }
  }

  /** Takes the messages of a recording. */
  @FunctionalInterface
  interface Sink {
    /** Takes the next one. */
    void take(BagMessage message) throws IOException;
  }
}
