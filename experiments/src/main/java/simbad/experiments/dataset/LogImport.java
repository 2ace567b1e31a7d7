package simbad.experiments.dataset;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import simbad.obstacles.Catalogue;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.SceneFile;
import simbad.sonar.frame.Placement;
import simbad.sonar.frame.Point;
import simbad.sonar.scene.Detection;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SetupDetails;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.scene.UniformDetection;
import simbad.sonar.sensing.ReadingRow;
import simbad.sonar.shape.Overlap;

/** A person's log as a data set of the second format. */
public final class LogImport {
  /** So many widths of a soft edge beyond it, nothing is lost. */
  private static final int EDGES = 10;

  private static final double GREATEST_S = 1e12;

  /** A dead band of 10 microseconds, as data sheets of small servos have, of 11 for a degree. */
  private static final double SERVO_DEG = 1;

  private static final int SCAN_HEADINGS = 5;

  private final LogSettings settings;
  private final List<LogTable> logs;
  private final Assumptions assumptions;
  private final SonarSpec sonar;

  private LogImport(
      LogSettings settings, List<LogTable> logs, Assumptions assumptions, SonarSpec sonar) {
    this.settings = settings;
    this.logs = logs;
    this.assumptions = assumptions;
    this.sonar = sonar;
  }

  /**
   * A data set with what is to be said of it.
   *
   * @param data the data set
   * @param settings as they were given and asked for: with them it is the same again
   * @param summary what was read, in one line
   * @param notes what looks odd, a line each
   */
  public record Made(MadeDataSet data, LogSettings settings, String summary, List<String> notes) {
    /** Copies the list. */
    public Made {
      notes = List.copyOf(notes);
    }
  }

  /**
   * Reads a log.
   *
   * @param files at least one, with the same columns
   * @param said the options
   * @param questions for what cannot be guessed
   * @throws DataFormatException naming file, line and column of the first fault, or the option
   */
  public static Made of(List<Path> files, LogSettings said, Questions questions)
      throws DataFormatException {
    LogFormat format = LogFormats.of(said);
    List<LogTable> logs = new ArrayList<>();
    for (Path file : files) {
      logs.add(LogTable.read(file, format));
    }
    Made made = ofTables(logs, said, questions);
    said.refuseUnread();
    return made;
  }

  /**
   * Reads a log that is no file of its own.
   *
   * @param name of what it was made of, for messages
   * @param text of the log
   * @param said the options
   * @param questions for what cannot be guessed
   * @throws DataFormatException naming line and column of the first fault, or the option
   */
  public static Made ofText(Path name, String text, LogSettings said, Questions questions)
      throws DataFormatException {
    return ofTables(List.of(LogTable.parse(name, text, LogFormats.of(said))), said, questions);
  }

  private static Made ofTables(List<LogTable> logs, LogSettings said, Questions questions)
      throws DataFormatException {
    LogPoses.requireOrigin(said);
    Assumptions assumptions = new Assumptions();
    LogGuess guess = new LogGuess(logs.get(0), questions, assumptions);
    LogSettings settings = sonarNamed(guess.complete(said), logs.get(0));
    if (settings.has("scene")) {
      requireAlone(settings);
      String word = settings.find("scene").orElse("");
      Optional<Path> file = LogSettings.findFile(word);
      if (file.isEmpty()) {
        throw LogSettings.fault("scene", "'" + word + "' is not a file");
      }
      SensingSetup scene = SceneFile.read(file.get());
      return new LogImport(settings, logs, assumptions, scene.sensor())
          .made(Optional.of(scene), guess.answered());
    }
    SonarSpec sonar = LogSonar.of(settings, assumptions);
    return new LogImport(settings, logs, assumptions, sonar)
        .made(Optional.empty(), guess.answered());
  }

  /** Whoever says "--sensor hcsr04" means the kind, if no column is called so. */
  private static LogSettings sonarNamed(LogSettings settings, LogTable log)
      throws DataFormatException {
    String word = settings.find("sensor").orElse("");
    boolean kind =
        !settings.has("sonar")
            && LogColumns.find(log, word).isEmpty()
            && Catalogue.findSonar(word).isPresent();
    return kind ? settings.renamed("sensor", "sonar") : settings;
  }

  private static void requireAlone(LogSettings settings) throws DataFormatException {
    for (String option :
        List.of(
            "target",
            "detection",
            "sonar",
            "max-range",
            "min-range",
            "resolution",
            "cone",
            "height",
            "sound-speed",
            "mount")) {
      if (settings.has(option)) {
        throw LogSettings.fault(option, "does not go with --scene, which says the same");
      }
    }
  }

  private Made made(Optional<SensingSetup> scene, LogSettings again) throws DataFormatException {
    NoEchoCodes.requireFound(settings.find("no-echo"), logs, settings.find("range").orElse(""));
    List<Target> targets = new ArrayList<>();
    for (String target : settings.all("target")) {
      targets.add(Target.of(target));
    }
    scene.ifPresent(is -> is.scene().obstacles().forEach(one -> targets.add(Target.of(one))));
    if (targets.isEmpty()) {
      targets.add(new Target("", Placement.IDENTITY, Shapes.board(1), Optional.empty()));
    }
    Map<String, Placement> mounts =
        scene.isPresent() ? scene.get().details().robotFromSensor() : LogPlans.mounts(settings);
    LogRows taken = new LogRows();
    LogPlans plans = new LogPlans(settings, sonar, targets.get(0), mounts, assumptions);
    for (LogTable log : logs) {
      for (LogRows.Plan plan : plans.of(log)) {
        taken.take(log, plan, settings.has(LogSettings.SKIP_BAD));
      }
    }
    if (taken.rows().isEmpty()) {
      throw logs.get(0).fault("no row is left to read" + why(taken));
    }
    List<ReadingRow> rows = rows(taken);
    SensingSetup believed = scene.isPresent() ? scene.get() : setup(targets, mounts, rows);
    LogSummary summary = new LogSummary(logs, taken, rows, believed, settings);
    MadeDataSet data = new MadeDataSet(finished(believed), rows, taken.further());
    return new Made(data, again, summary.line(), summary.notes());
  }

  private static String why(LogRows taken) {
    return !taken.bad().isEmpty()
        ? ": " + taken.bad().get(0)
        : taken.poseless() > 0 ? ": no row says where something was" : "";
  }

  /** With the times that pauses between pings make, where the log has no others. */
  private List<ReadingRow> timed(LogRows taken) {
    List<ReadingRow> rows = taken.rows();
    Optional<List<ReadingRow>> paused =
        rows.get(0).isTimed() ? Optional.empty() : PausedTimes.of(rows, taken.follows(), sonar);
    if (paused.isPresent()) {
      assumptions.add(
          "Rows that follow each other are pings that followed each other: their times are the sums"
              + " of what --gap-ms and --pause-ms say.");
    }
    return paused.orElse(rows);
  }

  /** With placements; without times that order nothing. */
  private List<ReadingRow> rows(LogRows taken) throws DataFormatException {
    List<ReadingRow> rows = timed(taken);
    if (!taken.bad().isEmpty()) {
      assumptions.add(
          Assumptions.counted(taken.bad().size(), "row")
              + " left out that cannot be read, the first: "
              + taken.bad().get(0));
    }
    if (taken.poseless() > 0) {
      assumptions.add(
          Assumptions.counted(taken.poseless(), "row")
              + " left out: they do not say where sensor or target was.");
    }
    Optional<ReadingRow> repeated = LoggedPlacements.findRepeatedTime(rows);
    boolean far = rows.stream().anyMatch(row -> Math.abs(row.timeS()) > GREATEST_S);
    if (far) {
      throw LogSettings.fault("time-unit", "gives times beyond " + GREATEST_S + " s");
    }
    if (repeated.isPresent()) {
      assumptions.add(
          "Times are left out: "
              + repeated.get().timeS()
              + " s appears twice for one run and sensor, so the times do not order the "
              + "readings.");
      rows = LoggedPlacements.untimed(rows);
    } else if (!rows.get(0).isTimed()) {
      assumptions.add("The readings have no times, so no effect with a memory can be diagnosed.");
    }
    LoggedPlacements.Named named = LoggedPlacements.named(rows, settings.find("pan").isPresent());
    named.assumption().ifPresent(assumptions::add);
    return named.rows();
  }

  private SensingSetup setup(
      List<Target> targets, Map<String, Placement> mounts, List<ReadingRow> rows)
      throws DataFormatException {
    double resolutionM = resolutionM();
    SonarSpec spec = LogSonar.withResolution(sonar, resolutionM);
    List<Obstacle> obstacles = new ArrayList<>();
    for (Target target : targets) {
      Obstacle obstacle = target.obstacle(detection(target), spec.mountHeightM());
      if (target.heightM().isPresent()) {
        assumptions.add("The target's middle is as high as the sonar.");
      }
      for (Obstacle other : obstacles) {
        if (Overlap.of(other.worldOutline(), obstacle.worldOutline())) {
          throw LogSettings.fault(
              "target", obstacle.name() + " overlaps " + other.name() + "; @X,Z,TURN places it");
        }
      }
      obstacles.add(obstacle);
    }
    SetupDetails details =
        new SetupDetails(
            LogSonar.length(settings, "pose-sigma", 0).orElse(0.0),
            Math.toRadians(sigmaDeg(mounts.isEmpty() && isScan(rows))),
            mounts,
            settings.has("compensated")
                ? Optional.of(settings.word("compensated", "true", "false").equals("true"))
                : Optional.empty(),
            List.of());
    if (!settings.has("pose-sigma")) {
      assumptions.add("Places are exact (--pose-sigma says how well they are known).");
    }
    return new SensingSetup(spec, new Scene(obstacles), spec.maxRangeM(), details);
  }

  /** Of a servo, where nothing else is said of a scan. */
  private double sigmaDeg(boolean isScan) throws DataFormatException {
    Optional<Double> said = settings.findMeasure("heading-sigma", Unit.Kind.ANGLE);
    if (said.isEmpty() && isScan) {
      assumptions.add(
          "Headings are known to "
              + SERVO_DEG
              + " degree, as a hobby servo turns (--heading-sigma).");
    }
    double sigma = said.orElse(isScan ? SERVO_DEG : 0);
    if (!(sigma >= 0 && sigma <= 180)) {
      throw LogSettings.fault("heading-sigma", sigma + " degrees is not in [0, 180]");
    }
    return sigma;
  }

  /** Whether a sensor stood at one place and looked around. */
  private static boolean isScan(List<ReadingRow> rows) {
    Point first = rows.get(0).pose().position();
    return rows.stream().allMatch(row -> row.pose().position().equals(first))
        && rows.stream().map(row -> row.pose().heading()).distinct().count() >= SCAN_HEADINGS;
  }

  /**
   * Distances at which something is lost count from its centre, and the sonar's greatest range from
   * its nearest point: so the first may be so much longer that only the second ends what is heard.
   */
  private Detection detection(Target target) throws DataFormatException {
    if (settings.has("detection")) {
      return Target.detection(settings.find("detection").orElse(""));
    }
    assumptions.add(
        "The target is heard from every side up to the sonar's greatest range of "
            + sonar.maxRangeM()
            + " m (--detection, --max-range).");
    double reachM = target.outline().reachM(0, 0) + EDGES * sonar.edgeWidthM();
    return new UniformDetection(sonar.maxRangeM() + reachM);
  }

  private double resolutionM() throws DataFormatException {
    Optional<Double> said = LogSonar.length(settings, "resolution", 0);
    if (said.isPresent()) {
      return said.get();
    }
    Unit unit = Unit.find(settings.find("range-unit").orElse("")).orElse(Unit.M);
    double stepM = Resolution.stepM(logs, settings.find("range").orElse(""), unit);
    assumptions.add(
        stepM > 0
            ? "Ranges come in steps of " + stepM + " m, as in the log (--resolution)."
            : "The steps of the ranges are too small to matter (--resolution).");
    return stepM;
  }

  private SensingSetup finished(SensingSetup setup) {
    SetupDetails details = setup.details();
    return new SensingSetup(
        setup.sensor(),
        setup.scene(),
        setup.noEchoM(),
        new SetupDetails(
            details.poseSigmaM(),
            details.headingSigmaRad(),
            details.robotFromSensor(),
            details.temperatureCompensated(),
            assumptions.sentences()));
  }
}
