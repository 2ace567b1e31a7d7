package simbad.experiments.bag;

import io.airlift.compress.zstd.ZstdDecompressor;
import java.io.ByteArrayInputStream;
import java.io.DataInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.BufferUnderflowException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import java.util.zip.CRC32;
import org.apache.commons.compress.compressors.lz4.FramedLZ4CompressorInputStream;

/**
 * Reads a recording in MCAP, record after record, by the format's published specification (version
 * 0): chunks uncompressed, in lz4 frames or zstd. Indexes are passed over. Every length is checked
 * against what is there before anything is made of it.
 */
final class Mcap {
  static final byte[] MAGIC = {(byte) 0x89, 'M', 'C', 'A', 'P', '0', '\r', '\n'};

  private static final int SCHEMA = 0x03;
  private static final int CHANNEL = 0x04;
  private static final int MESSAGE = 0x05;
  private static final int CHUNK = 0x06;
  private static final int DATA_END = 0x0f;
  private static final int MOST_BYTES = 1 << 28;
  private static final int RECORD_HEAD = 9;

  private final BagMessage.Sink sink;
  private final Map<Integer, String> types = new HashMap<>();
  private final Map<Integer, Channel> channels = new HashMap<>();

  private record Channel(String topic, String type, boolean isCdr) {}

  private Mcap(BagMessage.Sink sink) {
    this.sink = sink;
  }

  /**
   * Reads all messages of channels in CDR.
   *
   * @param stream at the file's begin
   * @param sink takes them in the file's order
   * @throws IOException if it is no such file, or broken
   */
  static void read(InputStream stream, BagMessage.Sink sink) throws IOException {
    DataInputStream in = new DataInputStream(stream);
    byte[] magic = new byte[MAGIC.length];
    if (in.readNBytes(magic, 0, magic.length) < magic.length || !Arrays.equals(magic, MAGIC)) {
      throw new IOException("does not begin as MCAP");
    }
    new Mcap(sink).records(in);
  }

  private void records(DataInputStream in) throws IOException {
    long at = MAGIC.length;
    while (true) {
      int opcode;
      long length;
      try {
        opcode = in.readUnsignedByte();
        length = Long.reverseBytes(in.readLong());
      } catch (EOFException e) {
        throw new IOException("ends at byte " + at + " without its end mark", e);
      }
      if (opcode == DATA_END) {
        return;
      }
      if (length < 0 || length > MOST_BYTES) {
        throw new IOException(
            "byte "
                + at
                + ": a record of "
                + Long.toUnsignedString(length)
                + " bytes, expected at most "
                + MOST_BYTES);
      }
      if (opcode == CHUNK || isWanted(opcode)) {
        byte[] record = in.readNBytes((int) length);
        if (record.length < length) {
          throw new IOException("ends in the record at byte " + at);
        }
        take(opcode, little(record), at);
      } else {
        in.skipNBytes(length);
      }
      at += RECORD_HEAD + length;
    }
  }

  private static boolean isWanted(int opcode) {
    return opcode == SCHEMA || opcode == CHANNEL || opcode == MESSAGE;
  }

  private static ByteBuffer little(byte[] bytes) {
    return ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
  }

  private void take(int opcode, ByteBuffer record, long at) throws IOException {
    try {
      switch (opcode) {
        case SCHEMA -> schema(record);
        case CHANNEL -> channel(record);
        case MESSAGE -> message(record);
        default -> chunk(record);
      }
    } catch (BufferUnderflowException | IllegalArgumentException e) {
      throw new IOException("byte " + at + ": a record that is shorter than it says", e);
    } catch (IOException e) {
      throw new IOException("byte " + at + ": " + e.getMessage(), e);
    }
  }

  private void schema(ByteBuffer record) throws IOException {
    int id = Short.toUnsignedInt(record.getShort());
    types.put(id, text(record));
  }

  private void channel(ByteBuffer record) throws IOException {
    int id = Short.toUnsignedInt(record.getShort());
    int schema = Short.toUnsignedInt(record.getShort());
    String topic = text(record);
    boolean isCdr = text(record).equals("cdr");
    channels.put(id, new Channel(topic, types.getOrDefault(schema, ""), isCdr));
  }

  private void message(ByteBuffer record) throws IOException {
    Channel channel = channels.get(Short.toUnsignedInt(record.getShort()));
    record.getInt();
    long timeNs = record.getLong();
    record.getLong();
    if (channel != null && channel.isCdr()) {
      sink.take(new BagMessage(channel.topic(), channel.type(), timeNs, record.slice()));
    }
  }

  private void chunk(ByteBuffer record) throws IOException {
    record.getLong();
    record.getLong();
    long size = record.getLong();
    int crc = record.getInt();
    String compression = text(record);
    long length = record.getLong();
    if (size < 0 || size > MOST_BYTES || length < 0 || length > record.remaining()) {
      throw new IOException("a chunk of " + Long.toUnsignedString(size) + " bytes");
    }
    byte[] packed = new byte[(int) length];
    record.get(packed);
    byte[] plain = plain(compression, packed, (int) size);
    check(plain, crc);
    within(little(plain));
  }

  private static byte[] plain(String compression, byte[] packed, int size) throws IOException {
    byte[] plain =
        switch (compression) {
          case "" -> packed;
          case "lz4" -> lz4(packed, size);
          case "zstd" -> zstd(packed, size);
          default ->
              throw new IOException("a chunk in '" + compression + "', expected lz4, zstd or none");
        };
    if (plain.length != size) {
      throw new IOException("a chunk of " + plain.length + " bytes where it says " + size);
    }
    return plain;
  }

  private static byte[] lz4(byte[] packed, int size) throws IOException {
    try (InputStream stream =
        new FramedLZ4CompressorInputStream(new ByteArrayInputStream(packed))) {
      return stream.readNBytes(size + 1);
    } catch (IllegalArgumentException | IndexOutOfBoundsException e) {
      throw new IOException("a chunk that is not an lz4 frame", e);
    }
  }

  private static byte[] zstd(byte[] packed, int size) throws IOException {
    byte[] plain = new byte[size];
    try {
      int made =
          new ZstdDecompressor().decompress(packed, 0, packed.length, plain, 0, plain.length);
      return made == size ? plain : Arrays.copyOf(plain, made);
    } catch (RuntimeException e) {
      throw new IOException("a chunk that is not a zstd frame", e);
    }
  }

  /** A checksum of 0 is none. */
  private static void check(byte[] plain, int crc) throws IOException {
    if (crc != 0) {
      CRC32 sum = new CRC32();
      sum.update(plain);
      if ((int) sum.getValue() != crc) {
        throw new IOException("a chunk whose checksum is wrong");
      }
    }
  }

  private void within(ByteBuffer chunk) throws IOException {
    while (chunk.remaining() >= RECORD_HEAD) {
      int opcode = Byte.toUnsignedInt(chunk.get());
      long length = chunk.getLong();
      if (length < 0 || length > chunk.remaining()) {
        throw new IOException("a record that is longer than its chunk");
      }
      ByteBuffer record = chunk.slice(chunk.position(), (int) length).order(chunk.order());
      chunk.position(chunk.position() + (int) length);
      if (isWanted(opcode)) {
        take(opcode, record, chunk.position());
      }
    }
  }

  private static String text(ByteBuffer record) throws IOException {
    int length = record.getInt();
    if (length < 0 || length > record.remaining()) {
      throw new IOException("a text of " + Integer.toUnsignedString(length) + " bytes");
    }
    byte[] text = new byte[length];
    record.get(text);
    return new String(text, StandardCharsets.UTF_8);
  }
}
