package simbad.bench.link;

import java.io.IOException;
import java.time.Duration;
import java.util.ArrayDeque;
import java.util.Deque;

/**
 * One end of a line that is only memory. What one end writes the other one reads; once either is
 * closed both are gone. Thread-safe.
 */
public final class MemoryLink implements SerialLink {
  /** Both directions and whether the line still is; the lock of both ends. */
  private static final class Line {
    private boolean open = true;
  }

  private final Line line;
  private final Deque<Byte> incoming;
  private final Deque<Byte> outgoing;

  private MemoryLink(Line line, Deque<Byte> incoming, Deque<Byte> outgoing) {
    this.line = line;
    this.incoming = incoming;
    this.outgoing = outgoing;
  }

  /**
   * The two ends of a line.
   *
   * @param here one end
   * @param there the other end
   */
  public record Pair(MemoryLink here, MemoryLink there) {}

  /** Creates a line. */
  public static Pair pair() {
    Line line = new Line();
    Deque<Byte> forth = new ArrayDeque<>();
    Deque<Byte> back = new ArrayDeque<>();
    return new Pair(new MemoryLink(line, back, forth), new MemoryLink(line, forth, back));
  }

  @Override
  public int read(byte[] buffer, Duration limit) throws IOException {
    long endNs = System.nanoTime() + limit.toNanos();
    synchronized (line) {
      while (incoming.isEmpty()) {
        requireOpen();
        long leftMs = (endNs - System.nanoTime()) / 1_000_000;
        if (leftMs <= 0) {
          return 0;
        }
        await(leftMs);
      }
      int count = Math.min(buffer.length, incoming.size());
      for (int i = 0; i < count; i++) {
        buffer[i] = incoming.remove();
      }
      return count;
    }
  }

  private void await(long limitMs) throws IOException {
    try {
      line.wait(limitMs);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IOException("interrupted while waiting for the line", e);
    }
  }

  private void requireOpen() throws IOException {
    if (!line.open) {
      throw new IOException("the line is closed");
    }
  }

  @Override
  public void write(byte[] bytes) throws IOException {
    synchronized (line) {
      requireOpen();
      for (byte b : bytes) {
        outgoing.add(b);
      }
      line.notifyAll();
    }
  }

  @Override
  public void close() {
    synchronized (line) {
      line.open = false;
      line.notifyAll();
    }
  }
}
