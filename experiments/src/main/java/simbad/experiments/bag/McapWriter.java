package simbad.experiments.bag;

import java.io.ByteArrayOutputStream;
import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;

/** Writes a recording in MCAP: plain records one after the other, without chunks and indexes. */
final class McapWriter implements Closeable {
  private static final int HEADER = 0x01;
  private static final int FOOTER = 0x02;
  private static final int SCHEMA = 0x03;
  private static final int CHANNEL = 0x04;
  private static final int MESSAGE = 0x05;
  private static final int DATA_END = 0x0f;

  private final OutputStream out;
  private int schemas;
  private int channels;

  /** Begins a file. */
  McapWriter(OutputStream out) throws IOException {
    this.out = out;
    out.write(Mcap.MAGIC);
    record(HEADER, new Fields().text("ros2").text("simbad-sonar"));
  }

  /** The fields of a record, one after the other. */
  private static final class Fields {
    private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();

    Fields number(int size, long value) {
      ByteBuffer number = ByteBuffer.allocate(Long.BYTES).order(ByteOrder.LITTLE_ENDIAN);
      bytes.write(number.putLong(value).array(), 0, size);
      return this;
    }

    Fields text(String text) {
      return block(text.getBytes(StandardCharsets.UTF_8));
    }

    Fields block(byte[] block) {
      number(Integer.BYTES, block.length);
      bytes.writeBytes(block);
      return this;
    }

    Fields raw(byte[] data) {
      bytes.writeBytes(data);
      return this;
    }
  }

  private void record(int opcode, Fields record) throws IOException {
    out.write(opcode);
    out.write(new Fields().number(Long.BYTES, record.bytes.size()).bytes.toByteArray());
    record.bytes.writeTo(out);
  }

  /** Tells a type; returns its number. */
  int schema(String type, String definition) throws IOException {
    schemas++;
    record(SCHEMA, new Fields().number(2, schemas).text(type).text("ros2msg").text(definition));
    return schemas;
  }

  /** Tells a topic; returns its number. */
  int channel(String topic, int schema) throws IOException {
    channels++;
    record(
        CHANNEL,
        new Fields().number(2, channels).number(2, schema).text(topic).text("cdr").number(4, 0));
    return channels;
  }

  void message(int channel, int number, long timeNs, byte[] data) throws IOException {
    record(
        MESSAGE,
        new Fields()
            .number(2, channel)
            .number(4, number)
            .number(8, timeNs)
            .number(8, timeNs)
            .raw(data));
  }

  @Override
  public void close() throws IOException {
    record(DATA_END, new Fields().number(4, 0));
    record(FOOTER, new Fields().number(8, 0).number(8, 0).number(4, 0));
    out.write(Mcap.MAGIC);
    out.close();
  }
}
