package simbad.bench.board;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.RandomAccessFile;
import java.nio.channels.Channels;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import simbad.bench.protocol.FrameLine;
import simbad.bench.protocol.FrameLine.Ping;
import simbad.sonar.format.DataFormatException;

/**
 * Every reading is of the pulse that there was, wherever in timer 0's range its two edges fall.
 *
 * <p>The timer runs from the program's start on and overflows every 65,536 us. gpsim clears the
 * latch of its high byte in that moment: a program that trusts the latch reads 256 us too much or
 * too little when an edge falls into one certain microsecond. So all edges that can be put near it
 * are, one microsecond further each time; the others fall anywhere.
 */
class EchoTimeTest {
  private static final long OVERFLOW_US = 65536;

  /**
   * Edges are placed so many microseconds, and fewer, after each 65,536th of the simulation: the
   * program starts the timer with its first instructions, and reads it some 25 after an edge. With
   * a program that trusts the latch it is the 43rd that goes wrong.
   */
  private static final int PHASES = 128;

  private static final int LEAST_US = 100;
  private static final int MOST_US = 19_000;
  private static final int NO_ECHO_US = 36_000;

  /** An instruction of two cycles that is under way holds an edge up by one. */
  private static final int MOST_OFF_US = 1;

  /** In which the sensor may answer the trigger. */
  private static final int MOST_BURST_US = 4000;

  private static final int USUAL_BURST_US = 200;
  private static final double SOUND_M_PER_US = 331.3 * Math.sqrt(1 + 20 / 273.15) * 1e-6;

  @TempDir Path folder = Path.of("");

  /** How many edges were placed, and what was read wrongly. */
  private record Outcome(long rises, long falls, List<String> wrong) {}

  /** Puts the edges of each pulse where they shall be, and remembers how long it was. */
  private static final class Edges implements BoardWorld {
    private final SplittableRandom random;
    private final int[] pulsesUs = new int[65536];
    private long rises;
    private long falls;

    Edges(long seed) {
      random = new SplittableRandom(seed);
    }

    /** How long an edge at a time has to wait for its phase. */
    private static long untilPhase(long timeUs, long count) {
      return Math.floorMod(count % PHASES - timeUs, OVERFLOW_US);
    }

    @Override
    public synchronized List<BoardOrder> ping(long number, double timeS) {
      long timeUs = Math.round(timeS * 1e6);
      int burstUs = burstUs(timeUs);
      int pulseUs = pulseUs(timeUs + burstUs);
      pulsesUs[(int) (number % pulsesUs.length)] = pulseUs;
      return List.of(
          new BoardOrder("burst " + burstUs),
          pulseUs == NO_ECHO_US
              ? BoardOrder.nothing()
              : BoardOrder.distance(pulseUs * SOUND_M_PER_US / 2));
    }

    private int burstUs(long timeUs) {
      long wait = untilPhase(timeUs, rises);
      if (wait < LEAST_US || wait > MOST_BURST_US) {
        return USUAL_BURST_US;
      }
      rises++;
      return (int) wait;
    }

    private int pulseUs(long riseUs) {
      long wait = untilPhase(riseUs, falls);
      if (wait == NO_ECHO_US || (wait >= LEAST_US && wait <= MOST_US)) {
        falls++;
        return (int) wait;
      }
      return random.nextInt(50) == 0 ? NO_ECHO_US : random.nextInt(LEAST_US, MOST_US + 1);
    }

    synchronized int pulseUs(Ping ping) {
      return pulsesUs[ping.sequence()];
    }

    synchronized Outcome outcome(List<String> wrong) {
      return new Outcome(rises, falls, wrong);
    }
  }

  /** Reads what a board says of so many pings. */
  private Outcome measure(int pings, long seed)
      throws IOException, InterruptedException, DataFormatException {
    Edges edges = new Edges(seed);
    Path place = Files.createDirectory(folder.resolve("board" + seed));
    List<String> wrong = new ArrayList<>();
    try (Board board =
            Board.start(TestBoard.kit(), new BoardSetup(place.resolve("tty"), 1), edges);
        RandomAccessFile port = new RandomAccessFile(board.port().toFile(), "rw");
        BufferedReader lines =
            new BufferedReader(
                new InputStreamReader(
                    Channels.newInputStream(port.getChannel()), StandardCharsets.ISO_8859_1))) {
      board.order(BoardOrder.pace(0));
      port.write("p20\r".getBytes(StandardCharsets.ISO_8859_1));
      int readings = 0;
      while (readings < pings) {
        if (FrameLine.parse(lines.readLine()).orElse(null) instanceof Ping ping) {
          readings++;
          int pulseUs = edges.pulseUs(ping);
          if (Math.abs(ping.echoUs().orElse(-1000) - pulseUs) > MOST_OFF_US) {
            wrong.add(ping + ", simulated " + pulseUs);
          }
        }
      }
      return edges.outcome(wrong);
    }
  }

  /** Each place of both edges at least once. */
  @Test
  @Timeout(600)
  void edgesAtTheTimersOverflow_areTimedRightly() throws Exception {
    Outcome outcome = measure(2600, 1);
    assertEquals(List.of(), outcome.wrong());
    assertTrue(outcome.rises() > PHASES, outcome.rises() + " rises placed");
    assertTrue(outcome.falls() > 4 * PHASES, outcome.falls() + " falls placed");
  }

  @Test
  @Tag("full")
  @Timeout(7200)
  void halfAMillionPings_areTimedRightly() throws Exception {
    int boards = 4;
    ExecutorService executor =
        Executors.newFixedThreadPool(Math.min(boards, Runtime.getRuntime().availableProcessors()));
    try {
      List<Future<Outcome>> outcomes = new ArrayList<>();
      for (int i = 1; i <= boards; i++) {
        long seed = i;
        outcomes.add(executor.submit(() -> measure(125_000, seed)));
      }
      for (Future<Outcome> outcome : outcomes) {
        assertEquals(List.of(), outcome.get().wrong());
        System.out.printf(
            "125,000 pings, %d rises and %d falls placed%n",
            outcome.get().rises(), outcome.get().falls());
      }
    } finally {
      executor.shutdownNow();
    }
  }
}
