package simbad.bench.capture;

import java.io.Closeable;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.ReadingsFile;
import simbad.sonar.format.ReadingsWriter;
import simbad.sonar.format.WholeFile;
import simbad.sonar.sensing.ReadingRow;

/**
 * A file of readings that grows row by row, each on the disk before the next: readings.csv of a gap
 * data set, whole at any time. Held by one process at a time. Not thread-safe.
 */
public final class ReadingsLog implements Closeable {
  private static final String HEAD = ReadingsWriter.text(List.of());

  private final Path file;
  private final FileChannel channel;
  private final List<ReadingRow> before;

  private ReadingsLog(Path file, FileChannel channel, List<ReadingRow> before) {
    this.file = file;
    this.channel = channel;
    this.before = before;
  }

  /**
   * Opens a file, or makes it. A last line without its end is one that was being written when the
   * power went, and is cut off.
   *
   * @param file csv, of this class alone meanwhile
   * @throws DataFormatException if it is another file, which is left as it is
   * @throws IOException if it cannot be written, or another process holds it
   */
  public static ReadingsLog open(Path file) throws IOException, DataFormatException {
    boolean wasThere = Files.exists(file);
    FileChannel channel =
        Journal.held(
            file,
            FileChannel.open(
                file,
                StandardOpenOption.CREATE,
                StandardOpenOption.READ,
                StandardOpenOption.WRITE));
    try {
      requireOwn(file, channel);
      channel.truncate(wholeLines(channel));
      channel.position(channel.size());
      if (channel.size() == 0) {
        append(file, channel, HEAD);
      }
      return new ReadingsLog(file, channel, ReadingsFile.read(file));
    } catch (IOException | DataFormatException e) {
      channel.close();
      if (!wasThere) {
        Files.deleteIfExists(file);
      }
      throw e;
    }
  }

  private static void requireOwn(Path file, FileChannel channel)
      throws IOException, DataFormatException {
    ByteBuffer begin = ByteBuffer.allocate(HEAD.length());
    channel.read(begin, 0);
    String there = new String(begin.array(), 0, begin.position(), StandardCharsets.UTF_8);
    if (!HEAD.startsWith(there)) {
      throw DataFormatException.inFile(
          file, "does not begin with " + HEAD.strip() + ", expected readings to go on with");
    }
  }

  /** Returns how many bytes there are up to the end of the last line that has one. */
  private static long wholeLines(FileChannel channel) throws IOException {
    ByteBuffer one = ByteBuffer.allocate(1);
    for (long at = channel.size(); at > 0; at--) {
      one.clear();
      channel.read(one, at - 1);
      if (one.get(0) == '\n') {
        return at;
      }
    }
    return 0;
  }

  /** The text as a whole, or the file as it was. */
  private static void append(Path file, FileChannel channel, String text) throws IOException {
    long whole = channel.position();
    try {
      Journal.writeAll(channel, text.getBytes(StandardCharsets.UTF_8));
      channel.force(false);
    } catch (IOException e) {
      channel.truncate(whole);
      throw WholeFile.naming(file, e);
    }
  }

  /** Returns the rows that were there when it was opened. */
  public List<ReadingRow> before() {
    return before;
  }

  /**
   * Adds a row, which is on the disk afterwards.
   *
   * @throws IOException naming the file, if it cannot be written; the file is then as it was
   */
  public void add(ReadingRow row) throws IOException {
    append(file, channel, ReadingsWriter.text(List.of(row)).substring(HEAD.length()));
  }

  @Override
  public void close() throws IOException {
    channel.close();
  }
}
