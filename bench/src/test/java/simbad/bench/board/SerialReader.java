package simbad.bench.board;

import java.io.Closeable;
import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.Stream;
import simbad.bench.protocol.FrameLine;

/** The other end of a board's serial port: collects what comes, in a thread, and can type. */
final class SerialReader implements Closeable {
  private static final long LIMIT_MS = 400_000;

  private final RandomAccessFile port;
  private final StringBuilder received = new StringBuilder();

  SerialReader(Path path) throws IOException {
    port = new RandomAccessFile(path.toFile(), "rw");
    Thread thread = new Thread(this::collect, "serial reader");
    thread.setDaemon(true);
    thread.start();
  }

  private void collect() {
    byte[] bytes = new byte[4096];
    try {
      for (int n = port.read(bytes); n >= 0; n = port.read(bytes)) {
        synchronized (received) {
          received.append(new String(bytes, 0, n, StandardCharsets.ISO_8859_1));
        }
      }
    } catch (IOException e) {
      // The board has ended.
    }
  }

  void type(String text) throws IOException {
    port.write(text.getBytes(StandardCharsets.ISO_8859_1));
  }

  void type(byte[] bytes) throws IOException {
    port.write(bytes);
  }

  String text() {
    synchronized (received) {
      return received.toString();
    }
  }

  void clear() {
    synchronized (received) {
      received.setLength(0);
    }
  }

  /** Waits until what came fulfils a condition. */
  String await(Predicate<String> condition) throws InterruptedException {
    long end = System.nanoTime() + LIMIT_MS * 1_000_000;
    synchronized (received) {
      while (!condition.test(received.toString())) {
        if (System.nanoTime() > end) {
          throw new AssertionError("waited in vain; came: " + received);
        }
        // Not woken by each byte: a long text would be looked through as often.
        received.wait(20);
      }
      return received.toString();
    }
  }

  /** All lines of frame mode with a checksum that fits. */
  static List<FrameLine> lines(String text) {
    return text.lines().map(FrameLine::parse).flatMap(Optional::stream).toList();
  }

  static List<FrameLine.Ping> pings(String text) {
    List<FrameLine.Ping> pings = new ArrayList<>();
    of(FrameLine.Ping.class, text).forEach(pings::add);
    return pings;
  }

  static <T extends FrameLine> Stream<T> of(Class<T> kind, String text) {
    return lines(text).stream().filter(kind::isInstance).map(kind::cast);
  }

  @Override
  public void close() throws IOException {
    port.close();
  }
}
