package simbad.bench.board;

import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Function;
import java.util.function.LongFunction;
import simbad.sonar.format.DataFormatException;

/**
 * The real program in gpsim, as fast as it goes: a test says what each ping meets, by its number,
 * and gets the pulses that the sensor gave.
 */
final class TestBoard implements AutoCloseable {
  static final BoardKit KIT = BoardKit.ofProject(Path.of(".."));

  private final World world;
  private final Board board;
  final SerialReader serial;

  /** Collects, and does what the test says. */
  static final class World implements BoardWorld {
    private final LongFunction<List<BoardOrder>> atPing;
    private final Function<Double, List<BoardOrder>> atWake;
    private final Map<Long, Double> pulseUs = new TreeMap<>();
    private final Map<Long, Double> pingS = new HashMap<>();
    private int refused;

    World(LongFunction<List<BoardOrder>> atPing, Function<Double, List<BoardOrder>> atWake) {
      this.atPing = atPing;
      this.atWake = atWake;
    }

    @Override
    public synchronized List<BoardOrder> ping(long number, double timeS) {
      pingS.put(number, timeS);
      return atPing.apply(number);
    }

    @Override
    public synchronized List<BoardOrder> wake(double timeS) {
      return atWake.apply(timeS);
    }

    @Override
    public synchronized void pulse(long number, double pulseS) {
      pulseUs.put(number, pulseS * 1e6);
    }

    @Override
    public synchronized void refused(double timeS, double triggerS) {
      refused++;
    }

    synchronized int refusals() {
      return refused;
    }

    synchronized Map<Long, Double> pulsesUs() {
      return new TreeMap<>(pulseUs);
    }
  }

  private TestBoard(World world, Board board) throws IOException {
    this.world = world;
    this.board = board;
    serial = new SerialReader(board.port());
  }

  /** What the board is made of, where this machine has it; otherwise the test is skipped. */
  static BoardKit kit() {
    assumeTrue(
        KIT.missingPackages().isEmpty(),
        () -> "no simulated board here: missing " + KIT.missingPackages());
    return KIT;
  }

  static TestBoard start(Path folder, LongFunction<List<BoardOrder>> atPing)
      throws IOException, DataFormatException, InterruptedException {
    return start(folder, new World(atPing, timeS -> List.of()));
  }

  static TestBoard start(Path folder, World world)
      throws IOException, DataFormatException, InterruptedException {
    // Real time until the reader is there: nothing is lost in between.
    Board board = Board.start(kit(), new BoardSetup(folder.resolve("tty"), 1), world);
    TestBoard test = new TestBoard(world, board);
    board.order(BoardOrder.pace(0));
    return test;
  }

  static List<BoardOrder> orders(BoardOrder... orders) {
    return new ArrayList<>(Arrays.asList(orders));
  }

  Board board() {
    return board;
  }

  World world() {
    return world;
  }

  @Override
  public void close() throws IOException {
    board.close();
    serial.close();
  }
}
