package simbad.cli;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.Deque;
import java.util.List;
import java.util.Random;
import simbad.bench.board.Board;
import simbad.bench.board.BoardOrder;
import simbad.bench.board.ResetCause;
import simbad.bench.link.PortLink;

/**
 * A line between a board and a port of its own, on which something goes wrong with every few pings.
 */
final class FaultyLine implements AutoCloseable {
  /** What may go wrong. */
  enum Fault {
    /** Bytes that nobody sent come before a line. */
    GARBAGE,
    /** A line ends in the middle. */
    TRUNCATED,
    /** A line ends in the middle, and its end is missing too. */
    TORN,
    /** A line comes twice. */
    TWICE,
    /** A line with its number is missing. */
    MISSING,
    /** One digit of a line is another one. */
    CHANGED,
    /** The port vanishes for a second and comes back as another device. */
    VANISHING,
    /** The board is reset. */
    RESET,
    /** The board's line runs at another speed for a while. */
    WRONG_BAUD,
    /** Nothing comes for 10 s. */
    SILENCE
  }

  private final Board board;
  private final PortLink inner;
  private final Path link;
  private final int every;
  private final Deque<Fault> faults;
  private final Random random;
  private final StringBuilder begun = new StringBuilder();
  private final List<Thread> threads = new ArrayList<>();
  private volatile PseudoTerminal outer;
  private volatile boolean open = true;
  private volatile long muteUntilNs = System.nanoTime();
  private int pings;

  private FaultyLine(Board board, Path link, int every, List<Fault> faults, Random random)
      throws IOException, InterruptedException {
    this.board = board;
    this.link = link;
    this.every = every;
    this.faults = new ArrayDeque<>(faults);
    this.random = random;
    inner = PortLink.open(board.port());
    outer = PseudoTerminal.open();
    Files.createSymbolicLink(link, outer.path());
  }

  /** Opens the port at a link, with the faults in any order, one with every so many pings. */
  static FaultyLine open(Board board, Path link, int every, List<Fault> faults, Random random)
      throws IOException, InterruptedException {
    List<Fault> shuffled = new ArrayList<>(faults);
    Collections.shuffle(shuffled, random);
    FaultyLine line = new FaultyLine(board, link, every, shuffled, random);
    line.start(line::fromBoard, "from the board");
    line.listen(line.outer);
    return line;
  }

  /** How many faults are yet to come. */
  synchronized int left() {
    return faults.size();
  }

  private void start(Runnable work, String name) {
    Thread thread = new Thread(work, name);
    thread.setDaemon(true);
    thread.start();
    threads.add(thread);
  }

  /** Passes on what the program sends, until the port vanishes. */
  private void listen(PseudoTerminal port) {
    start(
        () -> {
          byte[] bytes = new byte[256];
          try {
            for (int n = port.in().read(bytes); n > 0; n = port.in().read(bytes)) {
              inner.write(Arrays.copyOf(bytes, n));
            }
          } catch (IOException e) {
            // The port has vanished, or all is over.
          }
        },
        "to the board");
  }

  private void fromBoard() {
    byte[] bytes = new byte[256];
    try {
      while (open) {
        int count = inner.read(bytes, Duration.ofMillis(50));
        String came = new String(bytes, 0, count, StandardCharsets.ISO_8859_1);
        for (int i = 0; i < count; i++) {
          begun.append(came.charAt(i));
          if (came.charAt(i) == '\n') {
            pass(begun.toString());
            begun.setLength(0);
          }
        }
      }
    } catch (IOException | InterruptedException e) {
      // The board has ended.
    }
  }

  private void pass(String line) throws IOException, InterruptedException {
    if (line.startsWith("P ")) {
      pings++;
      Fault fault = pings % every == 0 ? next() : null;
      if (fault != null) {
        spoil(fault, line);
        return;
      }
    }
    send(line);
  }

  private synchronized Fault next() {
    return faults.poll();
  }

  private void send(String text) {
    if (System.nanoTime() - muteUntilNs > 0) {
      outer.send(text);
    }
  }

  private void spoil(Fault fault, String line) throws IOException, InterruptedException {
    int middle = 1 + random.nextInt(line.length() - 3);
    switch (fault) {
      case GARBAGE -> send(garbage() + line);
      case TRUNCATED -> send(line.substring(0, middle) + "\r\n");
      case TORN -> send(line.substring(0, middle));
      case TWICE -> send(line + line);
      case MISSING -> muteUntilNs = System.nanoTime();
      case CHANGED -> send(line.replaceFirst("(\\d) (echo|none)", "7$1 $2"));
      case VANISHING -> vanish();
      case RESET -> board.order(BoardOrder.reset(ResetCause.BROWN_OUT, 0));
      case WRONG_BAUD -> {
        board.order(BoardOrder.baud(9600));
        start(() -> rightAgainIn(400), "speed");
      }
      case SILENCE -> muteUntilNs = System.nanoTime() + 10_000_000_000L;
    }
  }

  private void rightAgainIn(long ms) {
    try {
      Thread.sleep(ms);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    board.order(BoardOrder.baud(19_200));
  }

  private String garbage() {
    StringBuilder text = new StringBuilder();
    for (int i = 0; i < 40; i++) {
      text.append((char) random.nextInt(256));
    }
    return text.toString();
  }

  private void vanish() throws IOException, InterruptedException {
    Files.delete(link);
    outer.close();
    Thread.sleep(1000);
    outer = PseudoTerminal.open();
    listen(outer);
    Files.createSymbolicLink(link, outer.path());
  }

  @Override
  public void close() {
    open = false;
    try {
      threads.get(0).join(2000);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    outer.close();
    inner.close();
  }
}
