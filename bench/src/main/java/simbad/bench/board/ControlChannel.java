package simbad.bench.board;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.Writer;
import java.nio.channels.Channels;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;

/** The line to the gpsim modules; firmware-pic18/gpsim/driver.h describes it. */
final class ControlChannel {
  private static final double MICROSECONDS = 1e6;

  private final SocketChannel channel;
  private final BufferedReader in;
  private final Writer out;
  private final BoardWorld world;
  private final CountDownLatch portOpen = new CountDownLatch(1);
  private volatile boolean stopped;
  private volatile @Nullable Exception fault;

  ControlChannel(SocketChannel channel, BoardWorld world) {
    this.channel = channel;
    this.world = world;
    in = new BufferedReader(Channels.newReader(channel, StandardCharsets.UTF_8));
    out = Channels.newWriter(channel, StandardCharsets.UTF_8);
  }

  /** Answers until the other side ends. */
  void serve() {
    try {
      for (String line = in.readLine(); line != null; line = in.readLine()) {
        answer(line.split(" ", 3));
      }
    } catch (IOException e) {
      fault = stopped ? null : e;
    } catch (RuntimeException e) {
      fault = e;
    } finally {
      close();
    }
  }

  private void answer(String[] words) throws IOException {
    switch (words[0]) {
      case "port" -> {
        go(world.wake(0));
        portOpen.countDown();
      }
      case "ping" -> go(world.ping(Long.parseLong(words[1]), seconds(words[2].split(" ", 2)[0])));
      case "wake" -> go(world.wake(seconds(words[1])));
      case "echo" -> world.pulse(Long.parseLong(words[1]), seconds(words[2]));
      case "refused" -> world.refused(seconds(words[1]), seconds(words[2]));
      default -> throw new IOException("the gpsim modules said '" + words[0] + "'");
    }
  }

  private static double seconds(String microseconds) {
    return Double.parseDouble(microseconds) / MICROSECONDS;
  }

  private void go(List<BoardOrder> orders) throws IOException {
    write(orders, "go\n");
  }

  /** Sends orders that nobody asked for; they are lost when the other side has ended. */
  void send(List<BoardOrder> orders) {
    try {
      write(orders, "");
    } catch (IOException e) {
      // It has ended: there is nobody to tell.
    }
  }

  private synchronized void write(List<BoardOrder> orders, String end) throws IOException {
    StringBuilder lines = new StringBuilder();
    for (BoardOrder order : orders) {
      lines.append(order.text()).append('\n');
      stopped |= order.equals(BoardOrder.stop());
    }
    out.write(lines + end);
    out.flush();
  }

  /** Tells whether the serial port was opened in time. */
  boolean awaitPort(long limit, TimeUnit unit) throws InterruptedException {
    return portOpen.await(limit, unit);
  }

  boolean stopped() {
    return stopped;
  }

  /** Throws what the world threw. */
  void rethrowFailure() {
    if (fault instanceof RuntimeException failure) {
      throw failure;
    }
  }

  /** What was wrong with the line itself, for a message; empty when nothing was. */
  String complaint() {
    return fault instanceof IOException lost ? " (" + lost.getMessage() + ")" : "";
  }

  void close() {
    try {
      channel.close();
    } catch (IOException e) {
      // Closed it is, one way or another.
    }
  }
}
