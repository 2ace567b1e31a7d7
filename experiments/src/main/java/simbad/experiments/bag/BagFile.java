package simbad.experiments.bag;

import io.airlift.compress.zstd.ZstdInputStream;
import java.io.BufferedInputStream;
import java.io.FilterInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.channels.Channels;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.TemporaryFolder;
import simbad.sonar.format.WholeFile;

/**
 * A recording: a file in MCAP or SQLite, or a folder of them as rosbag2 has it; each plain or
 * packed as a whole with zstd. What a file is, its first bytes say.
 */
final class BagFile {
  private static final byte[] ZSTD = {0x28, (byte) 0xb5, 0x2f, (byte) 0xfd};
  private static final int HEAD = 16;
  private static final long MOST_BYTES = 1L << 34;

  private BagFile() {}

  /**
   * Reads all messages in CDR.
   *
   * @param bag file or folder
   * @param sink takes them, file after file in the order of their names
   * @throws DataFormatException naming the file and what is wrong with it
   */
  static void read(Path bag, BagMessage.Sink sink) throws DataFormatException {
    List<Path> files = files(bag);
    if (files.isEmpty()) {
      throw DataFormatException.inFile(bag, "is a folder without a file in MCAP or SQLite");
    }
    for (Path file : files) {
      try {
        readOne(file, sink);
      } catch (IOException | RuntimeException e) {
        throw DataFormatException.inFile(file, reason(e));
      }
    }
  }

  private static String reason(Exception e) {
    return e.getMessage() == null ? "cannot be read" : e.getMessage();
  }

  private static List<Path> files(Path bag) throws DataFormatException {
    if (!Files.isDirectory(bag)) {
      return List.of(bag);
    }
    try (Stream<Path> names = Files.list(bag)) {
      return names
          .filter(name -> name.toString().matches(".*[.](mcap|db3)([.]zstd)?"))
          .sorted()
          .toList();
    } catch (IOException e) {
      throw DataFormatException.inFile(bag, "cannot be read");
    }
  }

  private static void readOne(Path file, BagMessage.Sink sink) throws IOException {
    byte[] head = head(file);
    if (startsWith(head, ZSTD)) {
      // What a killed process leaves of it, the next one sweeps.
      try (TemporaryFolder work = TemporaryFolder.create("simbad-bag")) {
        Path plain = work.path().resolve("plain");
        unpack(file, plain);
        readPlain(plain, head(plain), sink);
      }
    } else {
      readPlain(file, head, sink);
    }
  }

  private static void readPlain(Path file, byte[] head, BagMessage.Sink sink) throws IOException {
    if (startsWith(head, SqliteBag.MAGIC)) {
      SqliteBag.read(file, sink);
    } else if (startsWith(head, Mcap.MAGIC)) {
      try (InputStream stream = new BufferedInputStream(Files.newInputStream(file), 1 << 16)) {
        Mcap.read(stream, sink);
      }
    } else {
      throw new IOException("is neither MCAP nor SQLite");
    }
  }

  private static byte[] head(Path file) throws IOException {
    if (!Files.isRegularFile(file)) {
      throw new IOException("is neither a file nor a folder");
    }
    try (InputStream stream = Files.newInputStream(file)) {
      return stream.readNBytes(HEAD);
    }
  }

  private static boolean startsWith(byte[] head, byte[] magic) {
    return head.length >= magic.length
        && Arrays.equals(head, 0, magic.length, magic, 0, magic.length);
  }

  private static void unpack(Path packed, Path plain) throws IOException {
    try (InputStream stream =
        new Limited(new ZstdInputStream(new BufferedInputStream(Files.newInputStream(packed))))) {
      WholeFile.write(plain, channel -> stream.transferTo(Channels.newOutputStream(channel)));
    } catch (RuntimeException e) {
      throw new IOException("is packed with zstd, and broken", e);
    }
  }

  /** A small file may unpack to more than a disk holds. */
  private static final class Limited extends FilterInputStream {
    private long left = MOST_BYTES;

    Limited(InputStream stream) {
      super(stream);
    }

    @Override
    public int read() throws IOException {
      count(1);
      return super.read();
    }

    @Override
    public int read(byte[] bytes, int from, int length) throws IOException {
      int read = super.read(bytes, from, length);
      count(Math.max(0, read));
      return read;
    }

    private void count(int read) throws IOException {
      left -= read;
      if (left < 0) {
        throw new IOException("unpacks to more than " + MOST_BYTES + " bytes");
      }
    }
  }
}
