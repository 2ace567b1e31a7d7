package simbad.experiments.bench;

import java.io.IOException;
import java.util.Optional;
import java.util.Random;
import java.util.function.Consumer;
import simbad.bench.board.BenchScene;
import simbad.bench.board.BenchTarget;
import simbad.bench.board.Board;
import simbad.bench.board.BoardKit;
import simbad.bench.board.BoardSetup;
import simbad.bench.board.TurntableBench;
import simbad.bench.capture.ObstacleStage;
import simbad.bench.link.PortLink;
import simbad.bench.protocol.FirmwareMode;
import simbad.bench.session.SteadyRanger;
import simbad.obstacles.Catalogue;
import simbad.obstacles.ObstacleType;
import simbad.sonar.check.Checks;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.TemporaryFolder;
import simbad.sonar.frame.Pose;
import simbad.sonar.model.SensorModel;

/**
 * A simulated board with an obstacle that a program moves, for a sweep without a person. Closing
 * ends it and leaves no file behind.
 */
public final class SimulatedBench implements AutoCloseable {
  private final TemporaryFolder folder;
  private final Board board;
  private final TurntableBench turntable;
  private final BenchTarget target;

  /**
   * What is simulated.
   *
   * @param obstacle that stands on the turntable
   * @param model when the sensor hears it
   * @param seed of the model's chance
   * @param temperatureC of the air, degrees Celsius
   */
  public record Setup(ObstacleType obstacle, SensorModel model, long seed, double temperatureC) {
    /** Checks the temperature. */
    public Setup {
      Checks.atLeast("temperatureC", temperatureC, -273);
    }

    /** Returns the same where so many pings are there already: chance does not begin again. */
    public Setup after(long pings) {
      return new Setup(obstacle, model, seed + pings, temperatureC);
    }
  }

  private SimulatedBench(
      TemporaryFolder folder, Board board, TurntableBench turntable, BenchTarget target) {
    this.folder = folder;
    this.board = board;
    this.turntable = turntable;
    this.target = target;
  }

  /**
   * Starts the board, as fast as it goes.
   *
   * @param kit what the board is made of
   * @param setup what is simulated
   * @throws IOException if a tool is missing, or gpsim does not start
   * @throws DataFormatException if the board's program cannot be read
   * @throws InterruptedException if the thread is interrupted meanwhile
   */
  public static SimulatedBench start(BoardKit kit, Setup setup)
      throws IOException, DataFormatException, InterruptedException {
    BenchTarget target =
        new BenchTarget(setup.obstacle().outline(), setup.obstacle().thresholds().table());
    TurntableBench turntable =
        new TurntableBench(
            setup.model(),
            Catalogue.srf04(),
            new Random(setup.seed()),
            new BenchScene(Optional.of(target), 1, 0, 0),
            setup.temperatureC());
    TemporaryFolder folder = TemporaryFolder.create("simbad-port");
    try {
      Board board = Board.start(kit, new BoardSetup(folder.path().resolve("tty"), 0), turntable);
      return new SimulatedBench(folder, board, turntable, target);
    } catch (IOException | DataFormatException | InterruptedException e) {
      folder.close();
      throw e;
    }
  }

  /** Returns what turns and moves the obstacle. */
  public ObstacleStage stage() {
    return (bearingDeg, distanceM) ->
        turntable.place(
            new BenchScene(Optional.of(target), distanceM, 0, Math.toRadians(bearingDeg)));
  }

  /**
   * Puts the obstacle where a sensor has it before it, the obstacle being at the origin and
   * unturned; nothing when it lies behind.
   *
   * @param sensor in the obstacle's frame
   */
  public void look(Pose sensor) {
    double heading = sensor.heading().radians();
    double xM = sensor.position().xM();
    double zM = sensor.position().zM();
    double ahead = zM * Math.sin(heading) - xM * Math.cos(heading);
    double aside = -xM * Math.sin(heading) - zM * Math.cos(heading);
    turntable.place(
        ahead < 0
            ? new BenchScene(Optional.empty(), 0, 0, 0)
            : new BenchScene(Optional.of(target), ahead, aside, heading - Math.PI / 2));
  }

  /**
   * Connects with the ranger.
   *
   * @param mode in which it shall report
   * @param told each disturbance
   * @throws IOException if it does not answer
   */
  public SteadyRanger connect(FirmwareMode mode, Consumer<String> told) throws IOException {
    return new SteadyRanger(
        () -> PortLink.open(board.port()), SteadyRanger.Terms.SIMULATED.in(mode), told);
  }

  /** Returns the board. */
  public Board board() {
    return board;
  }

  @Override
  public void close() {
    board.close();
    folder.close();
  }
}
