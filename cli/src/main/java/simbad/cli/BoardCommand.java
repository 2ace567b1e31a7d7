package simbad.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import simbad.bench.board.BenchScene;
import simbad.bench.board.BenchTarget;
import simbad.bench.board.Board;
import simbad.bench.board.BoardEvent;
import simbad.bench.board.BoardScript;
import simbad.bench.board.BoardSetup;
import simbad.bench.board.ScriptedBench;
import simbad.obstacles.Catalogue;
import simbad.obstacles.ObstacleType;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.SensorFile;
import simbad.sonar.format.TemporaryFolder;
import simbad.sonar.model.DetectionRule;
import simbad.sonar.scene.SonarSpec;

/** {@code simbad board}: the simulated board. */
@Command(
    name = "board",
    description = {
      "Run the ranger's real firmware in gpsim, with a simulated bench in front of it.",
      "Prints the path of its serial port (19200 8N1).",
      "Ends after --for, or with Ctrl-C."
    },
    footer = {
      "",
      "Example: simbad board --obstacle angle --distance 1.5 --clockwise 45",
      "Example: simbad board --script docs/guide/board-session.csv --pace 0 --for 60"
    })
final class BoardCommand extends Subcommand {
  @Option(
      names = "--script",
      paramLabel = "FILE",
      description = "A session to play: a csv file (docs/guide/board.md).")
  private @Nullable Path script;

  @Option(
      names = "--obstacle",
      paramLabel = "OBSTACLE",
      description = "Without a script: square, round, angle, TABLE.csv, or none. Default: round.")
  private @Nullable String obstacle;

  @Option(
      names = "--distance",
      paramLabel = "M",
      description = "Without a script: distance to the obstacle's axis, metres. Default: 1.")
  private @Nullable Double distanceM;

  @Option(
      names = "--clockwise",
      paramLabel = "DEG",
      description =
          "Without a script: how far the obstacle is turned clockwise, seen from above. "
              + "Default: 0.")
  private @Nullable Double clockwiseDeg;

  @Option(
      names = "--temperature",
      paramLabel = "CELSIUS",
      description = "Without a script: temperature of the air, degrees Celsius. Default: 20.")
  private @Nullable Double temperatureC;

  @Option(
      names = "--sensor",
      paramLabel = "SENSOR",
      description =
          "The model that decides when the sensor hears: "
              + RuleArgument.NAMES
              + ". Default: shadow.")
  private String sensor = "shadow";

  @Option(
      names = "--sensor-file",
      paramLabel = "FILE",
      description = "The sensor's file. Default: data/sensors/srf04.json.")
  private @Nullable Path sensorFile;

  @Option(names = "--seed", paramLabel = "N", description = "Seed of the noisy sensor. Default: 1.")
  private long seed = 1;

  @Option(
      names = "--pace",
      paramLabel = "X",
      description = "Simulated seconds per real second; 0: as fast as possible. Default: 1.")
  private double pace = 1;

  @Option(
      names = "--for",
      paramLabel = "S",
      description = "Stop after this many simulated seconds.")
  private @Nullable Double endS;

  @Option(
      names = "--link",
      paramLabel = "PATH",
      description = "Path at which the serial port appears. Default: a free one, which is printed.")
  private @Nullable Path link;

  @Override
  protected void run() throws IOException, DataFormatException, InterruptedException {
    requireRange("--pace", pace);
    if (endS != null) {
      requireRange("--for", endS);
    }
    SonarSpec spec = sensorFile == null ? Catalogue.srf04() : SensorFile.read(sensorFile);
    ScriptedBench bench =
        new ScriptedBench(
            session(),
            rule(),
            spec,
            new Random(seed),
            endS == null ? OptionalDouble.empty() : OptionalDouble.of(endS));
    if (link == null) {
      try (TemporaryFolder folder = TemporaryFolder.create("simbad-port")) {
        play(bench, new BoardSetup(folder.path().resolve("tty"), pace));
      }
    } else {
      play(bench, new BoardSetup(link, pace));
    }
  }

  private void play(ScriptedBench bench, BoardSetup setup)
      throws IOException, DataFormatException, InterruptedException {
    try (Board board = Board.start(SimulatedBoard.kit(), setup, bench)) {
      // Ctrl-C ends the process while this waits: then nobody else would end gpsim and its files.
      Ending ending = Ending.with(board::close);
      try {
        out().println("serial port: " + board.port());
        board.awaitEnd();
      } finally {
        ending.close();
      }
      out().println("pings: " + bench.pings());
    }
  }

  private BoardScript session() throws DataFormatException {
    if (script == null) {
      return standing();
    }
    if (obstacle != null || distanceM != null || clockwiseDeg != null || temperatureC != null) {
      throw wrongUsage(
          "--script says where things stand; it does not go with --obstacle, --distance, "
              + "--clockwise, --temperature");
    }
    return BoardScript.read(script, BoardCommand::target);
  }

  /** A session in which nothing changes, by the same rules as one that is read. */
  private BoardScript standing() throws DataFormatException {
    String name = obstacle == null ? "round" : obstacle;
    double ahead = distanceM == null ? 1 : distanceM;
    double turned = clockwiseDeg == null ? 0 : clockwiseDeg;
    double celsius = temperatureC == null ? 20 : temperatureC;
    requireRange("--distance", ahead);
    if (!(celsius >= -50 && celsius <= 80)) {
      throw wrongUsage("--temperature: " + celsius + " is not in [-50, 80] degrees Celsius");
    }
    if (!Double.isFinite(turned)) {
      throw wrongUsage("--clockwise: " + turned + " is not a number of degrees");
    }
    BenchScene bench =
        new BenchScene(
            name.equals(BoardScript.NOTHING) ? Optional.empty() : Optional.of(target(name)),
            ahead,
            0,
            Math.toRadians(turned));
    return new BoardScript(List.of(new BoardScript.Row(0, bench, celsius, BoardEvent.NONE)));
  }

  private static BenchTarget target(String name) throws DataFormatException {
    ObstacleType type = ObstacleArgument.parse(name);
    return new BenchTarget(type.outline(), type.thresholds().table());
  }

  private DetectionRule rule() {
    return RuleArgument.require(sensor, this);
  }

  private void requireRange(String option, double value) {
    if (!(value >= 0 && value < Double.POSITIVE_INFINITY)) {
      throw wrongUsage(option + ": " + value + " is not a number of at least 0");
    }
  }
}
