package simbad.sonar.format;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.channels.WritableByteChannel;
import java.nio.file.AccessDeniedException;
import java.nio.file.AtomicMoveNotSupportedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.util.Objects;
import java.util.Set;
import java.util.UUID;
import java.util.concurrent.ConcurrentHashMap;

/**
 * Writes files that appear under their names only when all of them is on the disk: beside the
 * target, synced, then moved over it.
 *
 * <p>The file beside the target has a name that nobody can know before, and is made by this process
 * or not at all: no link that somebody left there is followed. Thread-safe.
 */
public final class WholeFile {
  /** What others left is looked for once in a folder. */
  private static final Set<Path> SWEPT = ConcurrentHashMap.newKeySet();

  private WholeFile() {}

  /**
   * What a file shall hold.
   *
   * @param <E> what may go wrong besides the writing
   */
  @FunctionalInterface
  public interface Content<E extends Exception> {
    /**
     * Writes all of it.
     *
     * @param file to write to; may be closed
     * @throws IOException if it cannot be written
     * @throws E if what it is made of is not there
     */
    void writeTo(WritableByteChannel file) throws IOException, E;
  }

  /**
   * Writes a file, over one that may be there.
   *
   * @param file its directory must exist
   * @param content the whole content
   * @throws IOException naming the file, if it cannot be written; the target is then as it was
   */
  public static void write(Path file, byte[] content) throws IOException {
    write(file, channel -> writeAll(channel, content));
  }

  /**
   * Writes a file that is too large to be held as a whole, over one that may be there.
   *
   * @param file its directory must exist
   * @param content writes the whole content
   * @param <E> what may go wrong besides the writing
   * @throws IOException naming the file, if it cannot be written; the target is then as it was
   * @throws E as the content does; the target is then as it was, too
   */
  public static <E extends Exception> void write(Path file, Content<E> content)
      throws IOException, E {
    stage(file, content, true);
  }

  /**
   * Writes a file that is not there yet.
   *
   * @param file its directory must exist
   * @param content the whole content
   * @throws FileAlreadyExistsException if something is there, even if it came meanwhile
   * @throws IOException naming the file, if it cannot be written; nothing is there then
   */
  public static void create(Path file, byte[] content) throws IOException {
    stage(file, channel -> writeAll(channel, content), false);
  }

  private static <E extends Exception> void stage(Path file, Content<E> content, boolean over)
      throws IOException, E {
    Path target = file.toAbsolutePath();
    Path folder = Objects.requireNonNull(target.getParent(), "a file lies in a folder");
    if (SWEPT.add(folder)) {
      Leftovers.sweep(folder);
    }
    Path beside = folder.resolve(Leftovers.name(".unfinished-" + UUID.randomUUID()));
    try {
      fill(beside, content);
      if (over) {
        replace(beside, target);
      } else {
        // Refuses a target that is there.
        Files.move(beside, target);
      }
    } catch (UncheckedIOException e) {
      throw naming(file, Objects.requireNonNull(e.getCause()));
    } catch (IOException e) {
      throw naming(file, e);
    } finally {
      Files.deleteIfExists(beside);
    }
  }

  private static <E extends Exception> void fill(Path beside, Content<E> content)
      throws IOException, E {
    try (FileChannel channel =
        FileChannel.open(
            beside,
            StandardOpenOption.CREATE_NEW,
            StandardOpenOption.WRITE,
            LinkOption.NOFOLLOW_LINKS)) {
      content.writeTo(new Unclosed(channel));
      channel.force(true);
    }
  }

  /** What is written to it can still be synced when its writer is closed. */
  private record Unclosed(FileChannel channel) implements WritableByteChannel {
    @Override
    public int write(ByteBuffer bytes) throws IOException {
      return channel.write(bytes);
    }

    @Override
    public boolean isOpen() {
      return channel.isOpen();
    }

    @Override
    public void close() {
      // The file is not done yet.
    }
  }

  private static void replace(Path from, Path to) throws IOException {
    try {
      Files.move(from, to, StandardCopyOption.ATOMIC_MOVE);
    } catch (AtomicMoveNotSupportedException e) {
      Files.move(from, to, StandardCopyOption.REPLACE_EXISTING);
    }
  }

  /**
   * The same fault with the name of the file that was asked for: a full disk is reported without
   * any, other faults with that of the file beside it.
   *
   * @param file as the user named it
   * @param fault what came of writing it
   */
  public static IOException naming(Path file, IOException fault) {
    String name = file.toString();
    IOException named;
    if (fault instanceof AccessDeniedException) {
      named = new AccessDeniedException(name);
    } else if (fault instanceof FileAlreadyExistsException) {
      named = new FileAlreadyExistsException(name);
    } else if (fault instanceof NoSuchFileException) {
      named = new NoSuchFileException(String.valueOf(file.toAbsolutePath().getParent()));
    } else {
      named = new FileSystemException(name, null, reason(fault));
    }
    named.initCause(fault);
    return named;
  }

  private static String reason(IOException fault) {
    String reason =
        fault instanceof FileSystemException detailed ? detailed.getReason() : fault.getMessage();
    return reason == null ? fault.getClass().getSimpleName() : reason;
  }

  private static void writeAll(WritableByteChannel channel, byte[] content) throws IOException {
    ByteBuffer bytes = ByteBuffer.wrap(content);
    while (bytes.hasRemaining()) {
      channel.write(bytes);
    }
  }
}
