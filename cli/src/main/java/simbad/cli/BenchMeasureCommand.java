package simbad.cli;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.file.Path;
import java.time.Clock;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import simbad.bench.capture.PoseMeasurement;
import simbad.bench.capture.Ranging;
import simbad.bench.capture.ReadingsLog;
import simbad.bench.link.PortLink;
import simbad.bench.protocol.FirmwareMode;
import simbad.bench.session.Disturbance;
import simbad.bench.session.SteadyRanger;
import simbad.experiments.bench.SimulatedBench;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.ReadingsFile;
import simbad.sonar.frame.Pose;
import simbad.sonar.sensing.ReadingRow;

/** {@code simbad bench measure}. */
@Command(
    name = "measure",
    description = {
      "Take one reading at each pose of a file, such as a diagnosis' " + "next-experiment.csv.",
      "Every row is on the disk before the next one. The same command continues "
          + "where the last call ended."
    },
    footer = {
      "",
      "Example: simbad bench measure diagnoses/my-bench/next-experiment.csv --port /dev/ttyUSB0"
          + " --out next.csv",
      "Example: simbad bench measure next-experiment.csv --auto --obstacle angle --out next.csv"
    })
final class BenchMeasureCommand extends Subcommand {
  /** Rows nearer to each other in time, at different poses, are a robot's way. */
  private static final double DRIVEN_S = 2;

  @Parameters(
      paramLabel = "POSES.csv",
      description =
          "run,sensor,t_s,x_m,z_m,heading_deg in the frame of the scene. A column "
              + "range_m is ignored.")
  private Path poses = Path.of("");

  @Option(
      names = "--out",
      paramLabel = "FILE",
      required = true,
      description = "File for the readings. Together with a scene.json they are a data set.")
  private Path file = Path.of("");

  @Option(
      names = "--port",
      paramLabel = "PORT",
      description = "Serial port of a real sensor. You place it.")
  private @Nullable Path port;

  @Option(
      names = "--auto",
      description = "Use the simulated board, with --obstacle at the origin and not turned.")
  private boolean auto;

  @Option(
      names = "--obstacle",
      paramLabel = "NAME",
      description = "With --auto. " + ObstacleArgument.MEANING)
  private @Nullable String obstacle;

  @Mixin private SimulatedSensor sensor = new SimulatedSensor();

  @Option(
      names = "--temperature",
      paramLabel = "CELSIUS",
      description = "Temperature of the air, degrees Celsius. Default: not known; 20 is assumed.")
  private @Nullable Double temperatureC;

  @Override
  protected void run() throws Exception {
    if (auto == (port != null)) {
      throw wrongUsage("exactly one of --port and --auto is needed");
    }
    sensor.requireSimulated(auto, this);
    if (auto != (obstacle != null)) {
      throw wrongUsage("--obstacle goes with --auto, which needs it");
    }
    List<ReadingRow> rows = ReadingsFile.readPoses(poses);
    Ranging ranging = ranging();
    Optional<SimulatedBench.Setup> simulated = simulated(ranging);
    try (ReadingsLog log = ReadingsLog.open(file)) {
      Optional<Integer> foreign = PoseMeasurement.findForeign(rows, log.before());
      if (foreign.isPresent()) {
        throw DataFormatException.inFile(
            file,
            "row "
                + (foreign.get() + 1)
                + " does not have the pose in "
                + poses
                + "; expected a new file, or the file of an earlier call");
      }
      int there = log.before().size();
      if (there < rows.size() && simulated.isPresent()) {
        bySimulation(rows, log, ranging, simulated.get().after(there));
      } else if (there < rows.size()) {
        byHand(rows, log, ranging);
      }
    }
    out()
        .println(
            file + ": " + rows.size() + " rows; together with the scene.json they are a data set");
  }

  private Ranging ranging() {
    try {
      return Ranging.of(
          temperatureC == null ? OptionalDouble.empty() : OptionalDouble.of(temperatureC),
          FirmwareMode.FRAME);
    } catch (IllegalArgumentException e) {
      throw wrongUsage(e);
    }
  }

  private Optional<SimulatedBench.Setup> simulated(Ranging ranging) throws DataFormatException {
    if (obstacle == null) {
      return Optional.empty();
    }
    return Optional.of(
        new SimulatedBench.Setup(
            ObstacleArgument.parse(obstacle),
            sensor.rule(this),
            sensor.seed(),
            ranging.temperatureC()));
  }

  private void bySimulation(
      List<ReadingRow> rows, ReadingsLog log, Ranging ranging, SimulatedBench.Setup setup)
      throws Exception {
    try (SimulatedBench bench = SimulatedBench.start(SimulatedBoard.kit(), setup);
        SteadyRanger ranger = bench.connect(FirmwareMode.FRAME, this::note);
        Progress progress = Progress.of("poses", rows.size())) {
      Ending ending = Ending.with(bench::close);
      PoseMeasurement measurement =
          new PoseMeasurement(
              rows,
              () -> {
                progress.step();
                return ranger.ping();
              },
              (row, pose) -> bench.look(pose),
              ranging);
      try {
        measurement.run(log, Optional.empty());
      } finally {
        ending.close();
      }
    }
  }

  private void byHand(List<ReadingRow> rows, ReadingsLog log, Ranging ranging) throws Exception {
    out()
        .println("x to the right, z down the page, headings counter-clockwise from x, from above;");
    out().println("the obstacles stand as in the scene. Enter takes a reading, q ends.");
    if (isDriven(rows)) {
      out()
          .println(
              "The poses are those of a driving robot. Taken by hand, each reading stands "
                  + "alone: an effect that depends on the time between pings does not show.");
    }
    BufferedReader in = BenchCaptureCommand.typed();
    try (SteadyRanger ranger = connected(Path.of(String.valueOf(port)))) {
      new PoseMeasurement(
              rows, ranger::ping, (row, pose) -> ask(in, row, rows.size(), pose), ranging)
          .run(log, Optional.of(Clock.systemUTC()));
    }
  }

  private SteadyRanger connected(Path device) throws IOException {
    try {
      return new SteadyRanger(() -> PortLink.open(device), SteadyRanger.Terms.BENCH, this::note);
    } catch (Disturbance e) {
      throw new IOException(device + ": " + e.getMessage(), e);
    }
  }

  private void note(String text) {
    err().println("bench: " + text);
  }

  private static boolean isDriven(List<ReadingRow> rows) {
    for (int i = 1; i < rows.size(); i++) {
      ReadingRow before = rows.get(i - 1);
      ReadingRow row = rows.get(i);
      if (row.run().equals(before.run())
          && !row.pose().equals(before.pose())
          && row.timeS() - before.timeS() < DRIVEN_S) {
        return true;
      }
    }
    return false;
  }

  private void ask(BufferedReader in, int row, int of, Pose pose) throws IOException {
    out()
        .printf(
            Locale.ROOT,
            "%d of %d: sensor at x %.3f m, z %.3f m, looking at %.1f degrees > ",
            row + 1,
            of,
            pose.position().xM(),
            pose.position().zM(),
            Math.toDegrees(pose.heading().radians()));
    out().flush();
    String typed = in.readLine();
    if (typed == null || typed.strip().equals("q")) {
      throw new IOException(
          "ended at row " + (row + 1) + " of " + of + "; the same command continues there");
    }
  }
}
