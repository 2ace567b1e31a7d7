package simbad.bench.capture;

import java.io.Closeable;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.channels.OverlappingFileLockException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.util.List;
import simbad.sonar.format.DataFormatException;

/**
 * The file that a capture writes to: only ever longer, each line with a number and a checksum. Held
 * by one process at a time. Not thread-safe.
 *
 * <p>When {@link #append} returns, the lines survive the end of this process, however it comes. The
 * disk follows at once, as fast as it is; when {@link #sync} returns, they survive a loss of power.
 */
public final class Journal implements Closeable {
  /** Of a line that was cut off, beside the journal. */
  private static final String TORN_SUFFIX = ".torn";

  private final Path file;
  private final FileChannel channel;
  private final DiskSync disk;
  private long lines;
  private boolean failed;

  private Journal(Path file, FileChannel channel, DiskSync disk, long lines) {
    this.file = file;
    this.channel = channel;
    this.disk = disk;
    this.lines = lines;
  }

  /**
   * Begins a journal: it is there when its first line is whole, and not before.
   *
   * @param file does not exist yet
   * @param begun its first entry
   * @throws IOException if it cannot be written
   */
  public static Journal create(Path file, Entry.Begun begun) throws IOException {
    if (Files.exists(file)) {
      throw new FileAlreadyExistsException(file.toString());
    }
    Path beginning = beginning(file);
    FileChannel channel =
        held(
            file,
            FileChannel.open(
                beginning,
                StandardOpenOption.CREATE,
                StandardOpenOption.TRUNCATE_EXISTING,
                StandardOpenOption.WRITE,
                // The file's name is known before: somebody may have left a link there.
                LinkOption.NOFOLLOW_LINKS));
    Journal journal = new Journal(file, channel, DiskSync.of(channel, 0), 0);
    try {
      journal.append(List.of(begun));
      journal.sync();
      Files.move(beginning, file, StandardCopyOption.ATOMIC_MOVE);
      syncFolder(file);
      return journal;
    } catch (IOException e) {
      journal.close();
      throw e;
    }
  }

  /** Returns where a journal is until its first line is whole; what is left there is nothing. */
  public static Path beginning(Path file) {
    return file.resolveSibling(file.getFileName() + ".beginning");
  }

  /** That the file is there must survive a power cut, too. */
  private static void syncFolder(Path file) throws IOException {
    try (FileChannel folder =
        FileChannel.open(file.toAbsolutePath().getParent(), StandardOpenOption.READ)) {
      folder.force(true);
    }
  }

  /**
   * Goes on with a journal. A last line that was torn is moved to a file beside it, whose name ends
   * in {@code .torn}.
   *
   * @param text what was read of it
   * @throws IOException if it cannot be written, or another process holds it
   * @throws DataFormatException if it has changed since it was read
   */
  public static Journal resume(JournalText text) throws IOException, DataFormatException {
    Path file = text.file();
    FileChannel channel = held(file, FileChannel.open(file, StandardOpenOption.WRITE));
    try {
      if (channel.size() != text.wholeBytes() + text.torn().length()) {
        throw DataFormatException.inFile(file, "another process is writing to it");
      }
      if (!text.torn().isEmpty()) {
        setAside(file, text.torn());
        channel.truncate(text.wholeBytes());
        channel.force(true);
      }
      channel.position(text.wholeBytes());
      return new Journal(file, channel, DiskSync.of(channel, text.lines()), text.lines());
    } catch (IOException | DataFormatException e) {
      channel.close();
      throw e;
    }
  }

  /** The same channel, as long as nobody else writes to the file. */
  static FileChannel held(Path file, FileChannel channel) throws IOException {
    try {
      if (channel.tryLock() != null) {
        return channel;
      }
    } catch (OverlappingFileLockException e) {
      // Held by this process.
    }
    channel.close();
    throw new IOException(file + ": another capture is writing to it");
  }

  private static void setAside(Path file, String torn) throws IOException {
    Path beside = file.resolveSibling(file.getFileName() + TORN_SUFFIX);
    try (FileChannel aside =
        FileChannel.open(
            beside,
            StandardOpenOption.CREATE,
            StandardOpenOption.WRITE,
            StandardOpenOption.APPEND,
            LinkOption.NOFOLLOW_LINKS)) {
      writeAll(aside, (torn + "\n").getBytes(StandardCharsets.ISO_8859_1));
      aside.force(true);
    }
  }

  /**
   * Appends entries: they are in the file when this returns, and soon on the disk. After a failure
   * nothing more is written: the journal ends in a torn line at worst.
   *
   * @param entries in their order
   * @throws IOException if they could not be written
   */
  public void append(List<Entry> entries) throws IOException {
    if (failed) {
      throw new IOException(file + ": writing failed before, so nothing more is written");
    }
    StringBuilder text = new StringBuilder();
    for (Entry entry : entries) {
      lines++;
      text.append(entry.line(lines).text());
    }
    failed = true;
    try {
      writeAll(channel, text.toString().getBytes(StandardCharsets.UTF_8));
    } catch (IOException e) {
      throw unwritable(e);
    }
    failed = false;
    disk.written(lines);
  }

  /**
   * Waits until all that was appended is on the disk.
   *
   * @throws IOException if the disk failed; nothing more is written then
   */
  public void sync() throws IOException {
    try {
      disk.await();
    } catch (IOException e) {
      failed = true;
      throw unwritable(e);
    }
  }

  /** Returns how many of the lines that were appended, the last ones, are not on the disk yet. */
  public long underWay() {
    return lines - disk.synced();
  }

  private IOException unwritable(IOException cause) {
    return new IOException(file + ": cannot be written: " + cause.getMessage(), cause);
  }

  static void writeAll(FileChannel channel, byte[] bytes) throws IOException {
    ByteBuffer buffer = ByteBuffer.wrap(bytes);
    while (buffer.hasRemaining()) {
      channel.write(buffer);
    }
  }

  /** Lets go of the file, once all of it is on the disk; without a word if the disk has failed. */
  @Override
  public void close() throws IOException {
    disk.close();
    channel.close();
  }
}
