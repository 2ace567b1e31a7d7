package simbad.cli;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Clock;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.util.LinkedHashMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import simbad.bench.capture.CaptureSettings;
import simbad.bench.capture.Journal;
import simbad.bench.capture.Recorder;
import simbad.bench.capture.SweepPlan;
import simbad.bench.capture.SweepState;
import simbad.bench.protocol.FirmwareMode;
import simbad.experiments.bench.CaptureFolder;
import simbad.experiments.bench.SimulatedBench;
import simbad.obstacles.ObstacleType;
import simbad.sonar.format.DataFormatException;

/** {@code simbad bench capture}. */
@Command(
    name = "capture",
    description = {
      "Measure an obstacle bearing by bearing: find the distance at which the echo is lost.",
      "Every reading is on the disk before the next one is taken. After any "
          + "interruption, simbad bench resume continues."
    },
    footer = {
      "",
      "Example: simbad bench capture --port /dev/ttyUSB0 --obstacle angle --out angle-capture",
      "Example: simbad bench capture --auto --obstacle angle --bearings 12 --out angle-capture"
    })
final class BenchCaptureCommand extends Subcommand {
  @Option(
      names = "--auto",
      description = "Use the simulated board. The program moves the obstacle.")
  private boolean auto;

  @Option(
      names = "--port",
      paramLabel = "PORT",
      description = "Serial port of a real sensor. You move the obstacle.")
  private @Nullable Path port;

  @Mixin private SweptObstacle obstacle = new SweptObstacle();

  @Option(
      names = "--out",
      paramLabel = "DIR",
      required = true,
      description = "Folder for the journal and the data set; new or empty.")
  private Path folder = Path.of("");

  @Option(
      names = "--bearings",
      paramLabel = "N",
      description =
          "Number of bearings, evenly spaced round the obstacle. Default: ${DEFAULT-VALUE}.")
  private int bearings = 72;

  @Option(
      names = "--pings",
      paramLabel = "N",
      description = "Pings at each distance. Default: ${DEFAULT-VALUE}.")
  private int pings = 10;

  @Option(
      names = "--misses",
      paramLabel = "K",
      description =
          "The echo counts as lost where at least K pings are missed. Default: half of "
              + "the pings.")
  private @Nullable Integer misses;

  @Option(
      names = "--step",
      paramLabel = "M",
      description = "Step between two distances, metres. Default: ${DEFAULT-VALUE}.")
  private double stepM = 0.02;

  @Option(
      names = "--mode",
      paramLabel = "MODE",
      description =
          "How the board reports ranges: frame (microseconds), or thesis (steps of 2 cm, "
              + "without a checksum). Default: frame.")
  private String mode = FirmwareMode.FRAME.word();

  @Mixin private SimulatedSensor sensor = new SimulatedSensor();

  @Mixin private WebOption web = new WebOption();

  @Override
  protected void run() throws Exception {
    if (auto == (port != null)) {
      throw wrongUsage("exactly one of --port and --auto is needed");
    }
    sensor.requireSimulated(auto, this);
    ObstacleType type = obstacle.type();
    CaptureSettings settings = settings(type);
    CaptureFolder target = new CaptureFolder(folder);
    target.requireFree();
    CaptureRun run = new CaptureRun(target, settings, type, out(), err());
    CaptureRun.Opening opening = known -> recorder(target, known);
    web.show(run);
    if (auto) {
      run.auto(simulated(type, settings), opening);
    } else {
      run.guided(typed(), Progress.onTerminal(), opening);
    }
  }

  /** What the person types; not closed, for the process has one only. */
  static BufferedReader typed() {
    return new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8));
  }

  private SimulatedBench.Setup simulated(ObstacleType type, CaptureSettings settings) {
    return new SimulatedBench.Setup(
        type, sensor.rule(this), sensor.seed(), settings.ranging().temperatureC());
  }

  private static Recorder recorder(CaptureFolder target, CaptureSettings known)
      throws IOException, DataFormatException {
    Journal journal = target.begin(known);
    return new Recorder(journal, new SweepState(), Clock.systemUTC(), known.temperatureC());
  }

  private CaptureSettings settings(ObstacleType type) throws IOException {
    Map<String, String> origin = new LinkedHashMap<>();
    origin.put("obstacle", kept("--obstacle", obstacle.name()));
    origin.put("object", type.thresholds().header("object").orElse(type.name()));
    if (port == null) {
      origin.put("sensor", "SRF04, simulated board (gpsim), " + sensor.word() + " model");
      origin.put("model", sensor.word());
      origin.put("seed", Long.toString(sensor.seed()));
    } else {
      origin.put("sensor", "Devantech SRF04");
      origin.put("port", kept("--port", port.toAbsolutePath().toString()));
    }
    origin.put(
        CaptureSettings.MODE,
        FirmwareMode.find(mode)
            .orElseThrow(() -> wrongUsage("--mode: '" + mode + "' is neither frame nor thesis"))
            .word());
    origin.put("date", LocalDate.now(ZoneOffset.UTC).toString());
    origin.put("version", BuildVersion.text());
    try {
      SweepPlan plan = SweepPlan.ofBearings(bearings).with(pings, half(), stepM);
      CaptureSettings settings = new CaptureSettings(plan, obstacle.temperatureC(), origin);
      settings.ranging();
      return settings;
    } catch (IllegalArgumentException e) {
      throw wrongUsage(e);
    }
  }

  /** What the capture goes on with later must be in the journal as it is. */
  private String kept(String option, String value) {
    if (!CaptureSettings.canHold(value)) {
      throw wrongUsage(
          option
              + ": '"
              + value
              + "' holds a comma, a star, a line break or blanks at an end, which no journal keeps;"
              + " name it otherwise");
    }
    return value;
  }

  private int half() {
    return misses == null ? (pings + 1) / 2 : misses;
  }
}
