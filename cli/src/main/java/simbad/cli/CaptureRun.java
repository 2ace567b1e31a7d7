package simbad.cli;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.PrintWriter;
import java.net.InetSocketAddress;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import simbad.bench.capture.CaptureSettings;
import simbad.bench.capture.CapturedReadings;
import simbad.bench.capture.GuidedSweep;
import simbad.bench.capture.Operator;
import simbad.bench.capture.PingSource;
import simbad.bench.capture.Recorder;
import simbad.bench.capture.Surface;
import simbad.bench.capture.Sweep;
import simbad.bench.capture.SweepListener;
import simbad.bench.capture.SweepPlan;
import simbad.bench.capture.SweepState;
import simbad.bench.capture.ThresholdFit;
import simbad.bench.link.PortLink;
import simbad.bench.protocol.FrameLine;
import simbad.bench.session.Disturbance;
import simbad.bench.session.SteadyRanger;
import simbad.experiments.bench.CaptureFolder;
import simbad.experiments.bench.SimulatedBench;
import simbad.obstacles.Catalogue;
import simbad.obstacles.ObstacleType;
import simbad.sonar.format.DataFormatException;
import simbad.studio.Studio;
import simbad.studio.bench.LiveState;

/** A capture from where its journal ends to where it is done or ends for another reason. */
final class CaptureRun {
  private final CaptureFolder folder;
  private final CaptureSettings settings;
  private final ObstacleType obstacle;
  private final PrintWriter out;
  private final PrintWriter err;
  private final LiveState live;
  private Optional<Recorder> recorder = Optional.empty();
  private Optional<Studio> page = Optional.empty();
  private volatile boolean interrupted;

  CaptureRun(
      CaptureFolder folder,
      CaptureSettings settings,
      ObstacleType obstacle,
      PrintWriter out,
      PrintWriter err) {
    this.folder = folder;
    this.settings = settings;
    this.obstacle = obstacle;
    this.out = out;
    this.err = err;
    live = new LiveState(obstacle.name(), settings.plan(), settings.ranging());
  }

  /** Opens the journal, once it is known who answers. */
  @FunctionalInterface
  interface Opening {
    Recorder open(CaptureSettings settings) throws IOException, DataFormatException;
  }

  /** The sweep that a program drives, before the simulated board. */
  void auto(SimulatedBench.Setup setup, Opening opening)
      throws IOException, DataFormatException, InterruptedException {
    concluded(
        () -> {
          try (SimulatedBench bench = SimulatedBench.start(SimulatedBoard.kit(), setup);
              Progress progress = Progress.of("bearings", settings.plan().bearings());
              SteadyRanger ranger = bench.connect(settings.mode(), this::note)) {
            Recorder known = open(ranger, opening);
            Sweep sweep = new Sweep(settings.plan(), known, shown(ranger), bench.stage());
            interruptible(() -> sweep.run(told(progress)), bench::close);
          }
        });
  }

  /** The sweep that a person does, at the port of the settings. */
  void guided(BufferedReader in, boolean terminal, Opening opening)
      throws IOException, DataFormatException, InterruptedException {
    Operator person = new TerminalOperator(in, out, settings, terminal);
    if (terminal) {
      // What was printed at the begin is cleared away.
      page.ifPresent(at -> person.say("page: " + at.url()));
    }
    concluded(
        () -> {
          try (SteadyRanger ranger = connected(Path.of(settings.of("port")))) {
            Recorder known = open(ranger, opening);
            GuidedSweep sweep =
                new GuidedSweep(settings.plan(), known, shown(ranger), person, surface());
            interruptible(sweep::run, () -> {});
          }
        });
  }

  private Surface surface() {
    return new Surface(obstacle.outline().reachM(0, 0), settings.ranging());
  }

  /** The part of a run that may fail. */
  @FunctionalInterface
  private interface Work {
    void run() throws IOException, DataFormatException, InterruptedException;
  }

  /** Ctrl-C ends it; that is said, and how it goes on. */
  private void interruptible(Work work, Runnable atTheEnd)
      throws IOException, DataFormatException, InterruptedException {
    Runnable farewell =
        () -> {
          interrupted = true;
          err.println(
              "bench: all readings are kept; to continue: simbad bench resume " + folder.path());
          atTheEnd.run();
        };
    Ending ending = Ending.with(farewell);
    try {
      work.run();
    } finally {
      ending.close();
    }
  }

  /** However it ends, what was read is kept and said; why it ended is what is complained about. */
  private void concluded(Work work) throws IOException, DataFormatException, InterruptedException {
    try {
      work.run();
    } catch (IOException | DataFormatException | InterruptedException e) {
      try {
        end();
      } catch (IOException | DataFormatException later) {
        e.addSuppressed(later);
      }
      throw e;
    }
    end();
  }

  private SteadyRanger connected(Path port) throws IOException {
    try {
      return new SteadyRanger(
          () -> PortLink.open(port), SteadyRanger.Terms.BENCH.in(settings.mode()), this::note);
    } catch (Disturbance e) {
      throw new IOException(port + ": " + e.getMessage(), e);
    }
  }

  private Recorder open(SteadyRanger ranger, Opening opening)
      throws IOException, DataFormatException {
    Recorder known = opening.open(settings.with("firmware", firmware(ranger.identity())));
    recorder = Optional.of(known);
    if (page.isPresent()) {
      live.show(known.state());
      known.tell(live::take);
    }
    return known;
  }

  private PingSource shown(SteadyRanger ranger) {
    return () -> {
      FrameLine.Ping ping = ranger.ping();
      live.read(ping);
      return ping;
    };
  }

  /** Shows the capture on a page as well, until it ends. */
  void showAt(InetSocketAddress address) throws IOException, DataFormatException {
    page = Optional.of(Studio.ofCapture(address, folder.path(), live));
    out.println("page: " + page.get().url());
  }

  private void end() throws IOException, DataFormatException {
    page.ifPresent(Studio::close);
    if (recorder.isPresent()) {
      recorder.get().close();
      conclude(folder.read());
    }
  }

  private static String firmware(FrameLine.Identity identity) {
    return identity.name() + " " + identity.version() + " " + identity.build();
  }

  private void note(String text) {
    if (interrupted) {
      // It is the end that disturbs the line.
      return;
    }
    err.println("bench: " + text);
    try {
      if (recorder.isPresent()) {
        recorder.get().note(text);
      }
    } catch (IOException e) {
      // The next reading fails for the same reason, and is said.
    }
  }

  private SweepListener told(Progress progress) {
    SweepPlan plan = settings.plan();
    return (bearing, fit, state) -> {
      progress.step();
      progress.clearLine();
      out.println(line(plan, bearing, fit));
    };
  }

  private static String line(SweepPlan plan, int bearing, ThresholdFit fit) {
    return String.format(Locale.ROOT, "bearing %5.1f: %s", plan.bearingDeg(bearing), fit.text());
  }

  /** Says how far it came, and writes the data set. */
  void conclude(CapturedReadings readings) throws IOException, DataFormatException {
    SweepState state = readings.state();
    int bearings = settings.plan().bearings();
    out.printf(
        Locale.ROOT,
        "%d of %d bearings, %d pings: %s%n",
        state.doneCount(),
        bearings,
        state.pings(),
        folder.path());
    out.println(
        state.doneCount() == bearings
            ? "now: simbad bench table " + folder.path() + " --out TABLE.csv"
            : "to continue: simbad bench resume " + folder.path());
    folder.writeDataSet(readings, obstacle, Catalogue.srf04());
  }
}
