package simbad.bench.capture;

import java.io.Closeable;
import java.io.IOException;
import java.io.InterruptedIOException;
import java.nio.channels.FileChannel;
import java.util.OptionalLong;
import org.jspecify.annotations.Nullable;

/**
 * Brings what is written to a file onto the disk, in a thread of its own and as fast as the disk
 * does it: what is written while one sync is under way shares the next one. Thread-safe.
 */
final class DiskSync implements Closeable {
  private final FileChannel channel;
  private final Thread thread = new Thread(this::follow, "journal to disk");
  private long written;
  private long synced;
  private boolean closed;
  private @Nullable IOException failure;

  private DiskSync(FileChannel channel, long lines) {
    this.channel = channel;
    written = lines;
    synced = lines;
  }

  /** Begins to follow a file in which so many lines are on the disk. */
  static DiskSync of(FileChannel channel, long lines) {
    DiskSync sync = new DiskSync(channel, lines);
    sync.thread.setDaemon(true);
    sync.thread.start();
    return sync;
  }

  private void follow() {
    try {
      for (OptionalLong upTo = due(); upTo.isPresent(); upTo = due()) {
        channel.force(false);
        reached(upTo.getAsLong());
      }
    } catch (IOException e) {
      fail(e);
    } catch (InterruptedException e) {
      fail(new InterruptedIOException("interrupted"));
    }
  }

  /** How many lines there are that are not all synced; waits for some. Empty at the end. */
  private synchronized OptionalLong due() throws InterruptedException {
    while (written == synced && !closed) {
      wait();
    }
    return written == synced ? OptionalLong.empty() : OptionalLong.of(written);
  }

  private synchronized void reached(long lines) {
    synced = lines;
    notifyAll();
  }

  private synchronized void fail(IOException e) {
    failure = e;
    notifyAll();
  }

  /** Says that so many lines are written in all. */
  synchronized void written(long lines) {
    written = lines;
    notifyAll();
  }

  /** Returns how many lines are on the disk. */
  synchronized long synced() {
    return synced;
  }

  /**
   * Waits until all that is written is on the disk.
   *
   * @throws IOException if the disk failed
   */
  synchronized void await() throws IOException {
    try {
      while (written != synced && failure == null) {
        wait();
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new InterruptedIOException("interrupted");
    }
    if (failure != null) {
      throw new IOException(failure.getMessage(), failure);
    }
  }

  /** Ends the thread, after what is written already. */
  @Override
  public void close() {
    synchronized (this) {
      closed = true;
      notifyAll();
    }
    try {
      thread.join();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
