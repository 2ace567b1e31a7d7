package simbad.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import simbad.experiments.control.Tuning;
import simbad.experiments.report.RunOrigin;
import simbad.experiments.run.Experiment;
import simbad.experiments.run.Pace;
import simbad.experiments.run.RobotKind;
import simbad.experiments.run.RunResult;
import simbad.experiments.run.RunSettings;
import simbad.experiments.run.SensorKind;
import simbad.figures.report.RunReport;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.TextFile;
import simbad.sonar.frame.Point;
import simbad.sonar.shape.ThresholdTable;

/** {@code simbad run}: the main job. */
@Command(
    name = "run",
    description = {
      "Let a robot circle obstacles at the limit of detection, once with each "
          + "sensor, and compare its traces with the obstacles' threshold tables.",
      "Writes traces, errors, pictures and a page to --out."
    },
    footer = {
      "",
      "Example: simbad run",
      "Example: simbad run angle my-table.csv --sensor original,shadow,ray --out results",
      "Example: simbad run angle --sensor shadow,diagnosed:diagnoses/bench-3",
      "Example: simbad run angle --sensor shadow --speed 0.2 --readings --out my-run",
      "Example: simbad run angle --sensor shadow --speed 0.1 --robot diagnosed:diagnoses/my-robot"
    })
final class RunCommand extends Subcommand {
  /** What help says of a robot. */
  static final String ROBOT =
      "diagnosed:DIR (the folder that simbad diagnose made of a motion folder), or a robot.json";

  private static final String DEFAULT_OUT = "simbad-run";

  @Parameters(
      paramLabel = "OBSTACLE",
      arity = "0..*",
      description = ObstacleArgument.MEANING + " Default: the thesis's square, round, angle.")
  private List<String> obstacles = List.of("square", "round", "angle");

  @Option(
      names = "--sensor",
      paramLabel = "SENSOR",
      split = ",",
      completionCandidates = SensorWords.class,
      description =
          "original (cone, 2.5 m), ray (Simbad's thin rays), shadow, overlap, noisy, level,"
              + " level-noisy (echoes with strength),"
              + " diagnosed:DIR (a diagnosis' folder with model.json and scene.json),"
              + " or a model that a jar brings (docs/guide/own-effect.md)."
              + " Default: original,shadow.")
  private List<String> sensors = List.of("original", "shadow");

  @Option(
      names = "--robot",
      paramLabel = "ROBOT",
      description =
          "Drive each sensor a second time, on a robot that does not do exactly what it "
              + "is told. Says how much of the error comes from hearing and how much from "
              + "moving. Takes "
              + ROBOT
              + ".")
  private @Nullable String robot;

  @Option(
      names = "--wait",
      paramLabel = "S",
      description =
          "Stand still for this many seconds after each step, so that a late robot has "
              + "done what it was told. Default: 0.")
  private double waitS;

  @Option(
      names = "--turn-rate",
      paramLabel = "RAD_PER_S",
      description =
          "How fast the robot is told to turn at most. A faster turn becomes a longer one on the "
              + "spot. Set it for a --robot that turns slowly. Default: 2 pi, one turn per second.")
  private double turnRateRadPerS = Tuning.TURN_RATE;

  @Mixin private DriveOptions drive = new DriveOptions();

  @Option(
      names = "--start",
      paramLabel = "X,Z",
      description =
          "Where the robot starts, in metres from the obstacle's axis. Default: on the "
              + "bearing of the greatest threshold, half-way out.")
  private @Nullable String start;

  @Option(
      names = "--seed",
      paramLabel = "N",
      description =
          "Seed of all random numbers; the same seed gives the same files. Default: ${DEFAULT-VALUE}.")
  private long seed = 1;

  @Option(
      names = "--readings",
      description =
          "Write what each sonar read in each step as well: a data set in OBSTACLE/readings-SENSOR,"
              + " of which simbad export bag makes a recording of ROS 2.")
  private boolean keepsReadings;

  @Option(
      names = "--out",
      paramLabel = "DIR",
      description =
          "A folder that does not exist yet. Default: simbad-run, or simbad-run-2 and so on.")
  private @Nullable Path out;

  @Override
  protected void run() throws Exception {
    Instant begun = Instant.now();
    RunSettings settings = settings();
    Path folder = out != null ? out : firstFree();
    try (StagedDirectory staged = StagedDirectory.beside(folder)) {
      List<RunResult> results = experiment(settings);
      RunReport.write(staged.path(), new RunOrigin(BuildVersion.text(), settings), results);
      TextFile.write(staged.path().resolve("run.log"), log(begun));
      staged.publish();
      RunSummary.print(out(), results);
      results.stream().filter(this::isLost).map(this::advice).forEach(err()::println);
      out().println();
      out().println("written to " + folder + " (open " + folder.resolve("report.html") + ")");
    }
  }

  /** Tells whether a robot that moves in its own way never found the edge. */
  private boolean isLost(RunResult result) {
    return result.sensor().robot().isPresent() && result.missesTheEdge();
  }

  private String advice(RunResult result) {
    return "note: "
        + result.sensor().word()
        + " never found the edge of "
        + result.type().name()
        + ": tell it to turn more slowly than "
        + String.format(Locale.ROOT, "%.3g", turnRateRadPerS)
        + " rad/s (--turn-rate), or give it time after each step (--wait, now "
        + waitS
        + " s)";
  }

  private List<RunResult> experiment(RunSettings settings) {
    int tasks = settings.obstacles().size() * settings.sensors().size();
    try (Progress progress = Progress.of("driving", tasks)) {
      return Experiment.run(settings, result -> progress.step());
    }
  }

  private static String log(Instant begun) {
    Duration taken = Duration.between(begun, Instant.now());
    return "begun "
        + begun
        + "\n"
        + "taken "
        + taken.toMillis() / 1e3
        + " s\n"
        + "java "
        + Runtime.version()
        + "\n"
        + "cores "
        + Runtime.getRuntime().availableProcessors()
        + "\n";
  }

  private static Path firstFree() throws IOException {
    Path folder = Path.of(DEFAULT_OUT);
    for (int i = 2; Files.exists(folder); i++) {
      folder = Path.of(DEFAULT_OUT + "-" + i);
    }
    return folder;
  }

  private RunSettings settings() throws DataFormatException {
    double speedMPerS = drive.speedMPerS(this);
    List<SensorKind> kinds = kinds();
    Optional<Point> place = start == null ? Optional.empty() : Optional.of(point(start));
    if (!(waitS >= 0 && waitS <= Pace.MOST_WAIT_S)) {
      throw wrongUsage("--wait: " + waitS + " is not in [0, " + Pace.MOST_WAIT_S + "] s");
    }
    double least = Pace.LEAST_TURN_RATE_RAD_PER_S;
    if (!(turnRateRadPerS >= least && turnRateRadPerS <= Tuning.TURN_RATE)) {
      throw wrongUsage(
          "--turn-rate: " + turnRateRadPerS + " is not in [" + least + ", 2 pi] rad/s");
    }
    RunSettings settings =
        new RunSettings(
                ObstacleArgument.distinct(obstacles), kinds, drive.sonar(), speedMPerS, place, seed)
            .at(new Pace(turnRateRadPerS, waitS));
    return keepsReadings ? settings.keepingReadings() : settings;
  }

  private List<SensorKind> kinds() throws DataFormatException {
    Set<SensorKind> kinds = new LinkedHashSet<>();
    for (String word : sensors) {
      SensorKind kind =
          SensorKind.read(word)
              .orElseThrow(() -> wrongUsage("--sensor: " + SensorArgument.unknown(word)));
      if (!kinds.add(kind)) {
        throw wrongUsage("--sensor: " + word + " appears twice");
      }
    }
    List<SensorKind> all = new ArrayList<>(kinds);
    if (robot != null) {
      RobotKind moving = RobotKind.read(robot);
      RobotKind.unchanged(robot).ifPresent(nothing -> err().println("note: --robot: " + nothing));
      moving
          .beyond(drive.speedMPerS(this), turnRateRadPerS)
          .ifPresent(beyond -> err().println("note: --robot: " + beyond));
      kinds.forEach(kind -> all.add(kind.on(moving)));
    }
    return all;
  }

  private Point point(String text) {
    String[] parts = text.split(",", -1);
    try {
      if (parts.length == 2) {
        return new Point(coordinate(parts[0]), coordinate(parts[1]));
      }
    } catch (IllegalArgumentException e) {
      // Said below.
    }
    throw wrongUsage(
        "--start: '"
            + text
            + "' is not X,Z in metres, such as 0,1.5, within "
            + ThresholdTable.GREATEST_THRESHOLD_M
            + " m");
  }

  /** Further away than any table can reach, the robot would drive for nothing. */
  private static double coordinate(String text) {
    double metres = Double.parseDouble(text);
    if (!(Math.abs(metres) <= ThresholdTable.GREATEST_THRESHOLD_M)) {
      throw new IllegalArgumentException(text);
    }
    return metres;
  }
}
