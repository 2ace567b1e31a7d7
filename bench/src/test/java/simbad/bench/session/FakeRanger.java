package simbad.bench.session;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.Deque;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentLinkedDeque;
import org.jspecify.annotations.Nullable;
import simbad.bench.link.SerialLink;

/**
 * Speaks as the firmware does, at the far end of a line, and does wrong what a test tells it to do
 * wrong with the ping of a number. The time of echo n is 1000 + n microseconds: a reading that got
 * lost among others is seen.
 */
public final class FakeRanger implements AutoCloseable {
  /** What may go wrong with a ping. */
  public enum Fault {
    /** Bytes that nobody sent come before its line. */
    GARBAGE,
    /** Its line ends in the middle. */
    TRUNCATED,
    /** Its line comes twice. */
    TWICE,
    /** The number before it is left out. */
    SKIPPED,
    /** One digit of its line is another one. */
    FLIPPED,
    /** Nothing comes. */
    SILENT,
    /** The board is reset instead, and pings of itself from then on. */
    RESET,
    /** All bits come wrong, as at another speed. */
    WRONG_BAUD,
    /** The echo line is stuck. */
    STUCK
  }

  private final SerialLink link;
  private final Map<Integer, Fault> faults = new ConcurrentHashMap<>();
  private final Thread thread;
  private int asked;
  private int sequence;
  private boolean running = true;
  private volatile boolean mute;
  private boolean thesisMode;
  private final Deque<String> numbers = new ConcurrentLinkedDeque<>();

  /** Starts it, pinging of itself as after a reset. */
  public FakeRanger(SerialLink link, Map<Integer, Fault> faults) {
    this.link = link;
    this.faults.putAll(faults);
    thread = new Thread(this::serve, "fake ranger");
    thread.setDaemon(true);
    thread.start();
  }

  /** Lets it say nothing at all, or speak again. */
  public void mute(boolean silent) {
    mute = silent;
  }

  /** What it answers to the next pings while it is in the thesis's mode. */
  public void sayInThesisMode(String... lines) {
    numbers.addAll(List.of(lines));
  }

  private void serve() {
    byte[] bytes = new byte[64];
    try {
      say("\r\n");
      say(line("I fake 1.0 00000000 power-on"));
      while (true) {
        int count = link.read(bytes, Duration.ofMillis(40));
        if (count == 0 && running) {
          ping();
        }
        for (int i = 0; i < count; i++) {
          obey((char) bytes[i]);
        }
      }
    } catch (IOException e) {
      // The line is closed.
    }
  }

  private void obey(char command) throws IOException {
    switch (command) {
      case 'i' -> {
        answer(command);
        say(line("I fake 1.0 00000000 power-on"));
      }
      case 'h' -> {
        running = false;
        answer(command);
      }
      case 's' -> {
        running = false;
        answer(command);
        asked++;
        if (thesisMode) {
          say(numbers.remove() + "\n\r");
        } else {
          fail(faults.remove(asked));
        }
      }
      case 'f', 't' -> {
        thesisMode = command == 't';
        answer(command);
      }
      default -> answer(command);
    }
  }

  private void fail(@Nullable Fault fault) throws IOException {
    if (fault == null) {
      ping();
      return;
    }
    switch (fault) {
      case GARBAGE -> {
        link.write(new byte[] {'P', ' ', (byte) 200, 7, '*', '\r', '\n', 'x', '\n'});
        ping();
      }
      case TRUNCATED -> say(next().substring(0, 9) + "\r\n");
      case TWICE -> {
        String line = next();
        say(line + line);
      }
      case SKIPPED -> {
        sequence++;
        ping();
      }
      case FLIPPED -> say(next().replaceFirst(" 1", " 2"));
      case SILENT -> next();
      case RESET -> {
        sequence = 0;
        running = true;
        say("P 7 100");
        say("\r\n" + line("I fake 1.0 00000000 brown-out"));
      }
      case WRONG_BAUD -> link.write(new byte[] {(byte) 0xF8, 0, (byte) 0x78, (byte) 0x80, '\n'});
      case STUCK -> {
        sequence++;
        say(line("P " + sequence + " high stuck 100"));
      }
    }
  }

  private void ping() throws IOException {
    say(next());
  }

  private String next() {
    sequence = (sequence + 1) % 65536;
    return line("P " + sequence + " " + (1000 + sequence % 20_000) + " echo 100");
  }

  private void answer(char command) throws IOException {
    int code = "ihsftr\r\n ".indexOf(command) >= 0 ? 0 : 16;
    if (command > ' ') {
      say(line(String.format(Locale.ROOT, "A %d %02X 250", code, (int) command)));
    }
  }

  private void say(String text) throws IOException {
    if (!mute) {
      link.write(text.getBytes(StandardCharsets.ISO_8859_1));
    }
  }

  /** With the checksum of the firmware, computed here anew: bit by bit, most significant first. */
  static String line(String text) {
    int crc = 0xFFFF;
    for (int c : text.chars().toArray()) {
      for (int bit = 7; bit >= 0; bit--) {
        int top = ((crc >> 15) ^ (c >> bit)) & 1;
        crc = ((crc << 1) & 0xFFFF) ^ (top == 1 ? 0x1021 : 0);
      }
    }
    return text + String.format(Locale.ROOT, "*%04X\r\n", crc);
  }

  /** All faults, for a test that goes through them. */
  public static List<Fault> faults() {
    return List.of(Fault.values());
  }

  @Override
  public void close() {
    link.close();
  }
}
