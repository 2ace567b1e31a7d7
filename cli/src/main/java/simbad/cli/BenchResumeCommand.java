package simbad.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Clock;
import java.util.Locale;
import java.util.OptionalDouble;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import simbad.bench.capture.CaptureSettings;
import simbad.bench.capture.CapturedReadings;
import simbad.bench.capture.Journal;
import simbad.bench.capture.JournalText;
import simbad.bench.capture.Recorder;
import simbad.bench.capture.SweepState;
import simbad.experiments.bench.CaptureFolder;
import simbad.experiments.bench.SimulatedBench;
import simbad.obstacles.ObstacleType;
import simbad.sonar.format.DataFormatException;

/** {@code simbad bench resume}. */
@Command(
    name = "resume",
    description = {
      "Continue an interrupted capture at the bearing where it stopped.",
      "If the last line was written only in part, it is moved to journal.txt.torn."
    },
    footer = {"", "Example: simbad bench resume angle-capture"})
final class BenchResumeCommand extends Subcommand {
  @Mixin private CaptureArgument argument = new CaptureArgument();

  @Option(
      names = "--port",
      paramLabel = "PORT",
      description = "The sensor's port, if it is another one now.")
  private @Nullable Path port;

  @Mixin private WebOption web = new WebOption();

  @Override
  protected void run() throws Exception {
    CaptureFolder capture = argument.folder();
    CapturedReadings known = capture.read();
    JournalText text = known.text();
    CaptureSettings settings = settings(known.settings());
    ObstacleType type = ObstacleArgument.parse(settings.of("obstacle"));
    CaptureRun run = new CaptureRun(capture, settings, type, out(), err());
    SweepState state = known.state();
    say(text, settings, state);
    if (state.nextBearing(settings.plan()).isEmpty()) {
      run.conclude(known);
      return;
    }
    CaptureRun.Opening opening = firmware -> recorder(text, firmware, state);
    web.show(run);
    if (settings.of("port").isEmpty()) {
      run.auto(simulated(capture, settings, state, type), opening);
    } else {
      run.guided(BenchCaptureCommand.typed(), Progress.onTerminal(), opening);
    }
  }

  private static SimulatedBench.Setup simulated(
      CaptureFolder capture, CaptureSettings settings, SweepState state, ObstacleType type)
      throws DataFormatException {
    SimulatedBench.Setup begun =
        new SimulatedBench.Setup(
            type,
            RuleArgument.parse(settings.of("model"))
                .orElseThrow(() -> damaged(capture, "model", settings)),
            seed(capture, settings),
            settings.ranging().temperatureC());
    return begun.after(state.pings());
  }

  private CaptureSettings settings(CaptureSettings begun) {
    if (port == null) {
      return begun;
    }
    if (begun.of("port").isEmpty()) {
      throw wrongUsage(
          "--port: this capture was made with the simulated board, which needs no port");
    }
    return begun.with("port", port.toAbsolutePath().toString());
  }

  private void say(JournalText text, CaptureSettings settings, SweepState state) {
    if (!text.torn().isEmpty()) {
      err()
          .printf(
              Locale.ROOT,
              "bench: %s: a torn last line of %d bytes is set aside%n",
              text.file(),
              text.torn().length());
    }
    err()
        .printf(
            Locale.ROOT,
            "bench: %d readings are there, %d of %d bearings done%n",
            state.pings(),
            state.doneCount(),
            settings.plan().bearings());
  }

  private static Recorder recorder(JournalText text, CaptureSettings known, SweepState state)
      throws IOException, DataFormatException {
    // What the person said of the air last.
    OptionalDouble temperatureC =
        state.temperatureC().isPresent() ? state.temperatureC() : known.temperatureC();
    Recorder recorder = new Recorder(Journal.resume(text), state, Clock.systemUTC(), temperatureC);
    recorder.note("resumed with " + known.of("version") + " and firmware " + known.of("firmware"));
    return recorder;
  }

  private static long seed(CaptureFolder capture, CaptureSettings settings)
      throws DataFormatException {
    try {
      return Long.parseLong(settings.of("seed"));
    } catch (NumberFormatException e) {
      throw damaged(capture, "seed", settings);
    }
  }

  private static DataFormatException damaged(
      CaptureFolder capture, String field, CaptureSettings settings) {
    return DataFormatException.inField(
        capture.journal(), 1, field, "'" + settings.of(field) + "' is none");
  }
}
