package simbad.experiments.dataset;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.function.ToDoubleFunction;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import simbad.motion.Command;
import simbad.motion.MotionChain;
import simbad.motion.MotionRun;
import simbad.motion.Robot;
import simbad.motion.TrackPose;
import simbad.motion.Unicycle;
import simbad.motion.format.MotionData;
import simbad.sonar.format.DataFormatException;

/**
 * A person's log of what a robot was told and where it then was, as motion data: columns by name or
 * number, units out of the names or said, wheels or speed and turn.
 */
public final class MotionImport {
  /** A rate in a column's name: v_m_s, w [rad/s], speed (cm/s). */
  private static final Pattern RATE =
      Pattern.compile("(m|cm|mm|in|ft|rad|deg|turn)\\s*[/_ ]\\s*s\\b");

  private static final Map<String, Double> ZEROS =
      Map.of("right", 0.0, "up", 90.0, "left", 180.0, "down", 270.0);

  private static final double GREATEST = 1e9;
  private static final double GREATEST_SIGMA = 1e6;

  /** What a tracker writes where it does not see the robot. */
  private static final Set<String> UNSEEN = Set.of("", "nan", "-nan", "na", "n/a", "null", "none");

  private final LogSettings settings;
  private final Assumptions assumptions = new Assumptions();
  private final Assumptions notes = new Assumptions();

  private MotionImport(LogSettings settings) {
    this.settings = settings;
  }

  /**
   * Motion data with what was decided.
   *
   * @param data the data
   * @param assumptions sentences, each once
   * @param notes sentences on rows that are not as they should be, each once
   * @param summary what was read, in one line
   */
  public record Made(
      MotionData data, List<String> assumptions, List<String> notes, String summary) {
    /** Copies the lists. */
    public Made {
      assumptions = List.copyOf(assumptions);
      notes = List.copyOf(notes);
    }
  }

  /**
   * Reads a log.
   *
   * @param commands what the robot was told
   * @param track where it was; may be the same file
   * @param said the options
   * @throws DataFormatException naming file, line and column of the first fault, or the option
   */
  public static Made of(Path commands, Path track, LogSettings said) throws DataFormatException {
    LogFormat format = LogFormats.of(said);
    LogTable told = LogTable.read(commands, format);
    LogTable seen = commands.equals(track) ? told : LogTable.read(track, format);
    Made made = new MotionImport(said).made(told, seen);
    said.refuseUnread();
    return made;
  }

  private Made made(LogTable told, LogTable seen) throws DataFormatException {
    double startS = Math.min(first(told, "time"), first(seen, trackTime()));
    Map<String, List<Command>> commands = commands(told, startS);
    Map<String, List<TrackPose>> track = track(seen, startS);
    List<MotionRun> runs = new ArrayList<>();
    for (Map.Entry<String, List<TrackPose>> run : track.entrySet()) {
      List<Command> ofRun = commands.get(run.getKey());
      if (ofRun == null) {
        throw seen.fault("has the run '" + run.getKey() + "', but there are no commands for it");
      }
      runs.add(new MotionRun(run.getKey(), ofRun, run.getValue()));
    }
    noteTimes("of the commands", commands.values(), Command::timeS);
    noteTimes("of the track", track.values(), TrackPose::timeS);
    String summary =
        String.format(
            "read %d commands and %d poses in %s",
            told.size(),
            track.values().stream().mapToInt(List::size).sum(),
            Assumptions.counted(runs.size(), "run"));
    MotionData data = new MotionData("log", robot(), runs, List.of());
    return new Made(data, assumptions.sentences(), notes.sentences(), summary);
  }

  private Robot robot() throws DataFormatException {
    double sigmaM = sigma("track-sigma", Unit.Kind.LENGTH, 0.001);
    double sigmaDeg = sigma("heading-sigma", Unit.Kind.ANGLE, 0.1);
    assume("track-sigma", "The track is exact to a millimetre (--track-sigma).");
    assume("heading-sigma", "Its headings are exact to 0.1 degrees (--heading-sigma).");
    boolean separate = settings.word("clocks", "one", "separate").equals("separate");
    assume("clocks", "Commands and track have one clock (--clocks separate).");
    return new Robot(false, 0, separate, sigmaM, Math.toRadians(sigmaDeg), MotionChain.EXACT);
  }

  private double sigma(String option, Unit.Kind kind, double usual) throws DataFormatException {
    double sigma = settings.findMeasure(option, kind).orElse(usual);
    if (!(sigma >= 0 && sigma <= GREATEST_SIGMA)) {
      throw LogSettings.fault(
          option,
          "'" + settings.find(option).orElse("") + "' is no deviation, expected one of at least 0");
    }
    return sigma;
  }

  /** Rows are sorted by time: a clock that was set back, or two recordings in one, show here. */
  private <T> void noteTimes(String of, Collection<List<T>> runs, ToDoubleFunction<T> timeS) {
    int back = 0;
    int twice = 0;
    for (List<T> run : runs) {
      double[] times = run.stream().mapToDouble(timeS).toArray();
      for (int i = 1; i < times.length; i++) {
        back += times[i] < times[i - 1] ? 1 : 0;
      }
      twice += times.length - (int) Arrays.stream(times).distinct().count();
    }
    String all = "rows are sorted by time (--run).";
    note(back, of, "an earlier time than the row before; " + all);
    note(twice, of, "the time of another row (--run).");
  }

  private void note(int rows, String of, String have) {
    if (rows > 0) {
      notes.add(
          Assumptions.counted(rows, "row") + " " + of + (rows == 1 ? " has " : " have ") + have);
    }
  }

  private String trackTime() {
    return settings.has("track-time") ? "track-time" : "time";
  }

  private void assume(String option, String sentence) {
    if (!settings.has(option)) {
      assumptions.add(sentence);
    }
  }

  /** A column with what its numbers are multiplied by. */
  private record Column(LogTable log, int index, double times) {
    boolean isUnseen(int row) {
      return UNSEEN.contains(log.text(row, index).strip().toLowerCase(Locale.ROOT));
    }

    double value(int row) throws DataFormatException {
      Optional<LogNumber> number = log.findNumber(row, index);
      double value = number.map(LogNumber::value).orElse(Double.NaN) * times;
      if (!(Math.abs(value) <= GREATEST * Math.max(1, times))) {
        throw log.fault(row, index, "'" + log.text(row, index) + "' is not a finite number");
      }
      return value;
    }
  }

  private OptionalInt find(LogTable log, String option) throws DataFormatException {
    if (settings.has(option)) {
      return OptionalInt.of(LogColumns.require(log, settings.find(option).orElse("")));
    }
    OptionalInt found = MotionNames.find(log, option.replace("track-", ""));
    if (found.isPresent()) {
      assumptions.add(
          "'" + log.names().get(found.getAsInt()) + "' is the column for --" + option + ".");
    }
    return found;
  }

  private int require(LogTable log, String option) throws DataFormatException {
    OptionalInt found = find(log, option);
    if (found.isEmpty()) {
      throw log.fault("has no column that is known for --" + option + "; it has " + log.shown());
    }
    return found.getAsInt();
  }

  private Column column(LogTable log, String option, String unitOption, Unit.Kind kind, Unit usual)
      throws DataFormatException {
    int index = require(log, option);
    Optional<Unit> unit = said(unitOption, kind);
    if (unit.isEmpty()) {
      unit = Unit.inName(log.names().get(index)).filter(found -> found.kind() == kind);
    }
    if (unit.isEmpty()) {
      assumptions.add(
          "'" + log.names().get(index) + "' is in " + usual.word() + " (--" + unitOption + ").");
    }
    return new Column(log, index, unit.orElse(usual).si(1));
  }

  private Optional<Unit> said(String option, Unit.Kind kind) throws DataFormatException {
    Optional<String> word = settings.find(option);
    if (word.isEmpty()) {
      return Optional.empty();
    }
    Optional<Unit> unit = Unit.find(word.get()).filter(found -> found.kind() == kind);
    if (unit.isEmpty()) {
      throw LogSettings.fault(option, "'" + word.get() + "' is not one of " + Unit.words(kind));
    }
    return unit;
  }

  /** A speed in m/s, or a turn in degrees a second. */
  private Column rate(LogTable log, String option, String unitOption, Unit usual)
      throws DataFormatException {
    int index = require(log, option);
    String name = log.names().get(index);
    String word = settings.find(unitOption).orElse(name);
    Matcher rate = RATE.matcher(word.replaceFirst(".*?_(?=(m|cm|mm|in|ft|rad|deg|turn)_s$)", ""));
    Optional<Unit> unit =
        rate.find()
            ? Unit.find(rate.group(1)).filter(u -> u.kind() == usual.kind())
            : Optional.empty();
    if (unit.isEmpty() && settings.has(unitOption)) {
      throw LogSettings.fault(
          unitOption,
          "'" + word + "' is not a unit for this column; expected one like " + usual.word() + "/s");
    }
    if (unit.isEmpty()) {
      assumptions.add("'" + name + "' is in " + usual.word() + "/s (--" + unitOption + ").");
    }
    return new Column(log, index, unit.orElse(usual).si(1));
  }

  private double first(LogTable log, String option) throws DataFormatException {
    Column time = column(log, option, "time-unit", Unit.Kind.TIME, Unit.S);
    double least = Double.POSITIVE_INFINITY;
    for (int row = 0; row < log.size(); row++) {
      least = Math.min(least, time.value(row));
    }
    return least;
  }

  private String run(LogTable log, OptionalInt column, int row) throws DataFormatException {
    return column.isEmpty() ? "log" : log.label(row, column.getAsInt());
  }

  private Map<String, List<Command>> commands(LogTable log, double startS)
      throws DataFormatException {
    Column time = column(log, "time", "time-unit", Unit.Kind.TIME, Unit.S);
    OptionalInt run = find(log, "run");
    boolean isWheels =
        settings.has("left") || (find(log, "speed").isEmpty() && find(log, "left").isPresent());
    Column first = rate(log, isWheels ? "left" : "speed", "speed-unit", Unit.M);
    Column second =
        isWheels
            ? rate(log, "right", "speed-unit", Unit.M)
            : rate(log, "turn", "turn-unit", Unit.find("rad").orElseThrow());
    double base = isWheels ? wheelBaseM() : 0;
    Map<String, List<Command>> commands = new LinkedHashMap<>();
    for (int row = 0; row < log.size(); row++) {
      double one = first.value(row);
      double other = second.value(row);
      double speed = isWheels ? Unicycle.speedOfWheels(one, other) : one;
      double turn = isWheels ? Unicycle.turnOfWheels(one, other, base) : Math.toRadians(other);
      commands
          .computeIfAbsent(run(log, run, row), name -> new ArrayList<>())
          .add(new Command(time.value(row) - startS, speed, turn));
    }
    return commands;
  }

  private double wheelBaseM() throws DataFormatException {
    double base = settings.findMeasure("wheel-base", Unit.Kind.LENGTH).orElse(0.0);
    if (!(base > 0 && base <= 100)) {
      throw LogSettings.fault(
          "wheel-base", "is missing, expected the wheels' distance, such as 20cm");
    }
    return base;
  }

  private Map<String, List<TrackPose>> track(LogTable log, double startS)
      throws DataFormatException {
    Column time = column(log, trackTime(), "time-unit", Unit.Kind.TIME, Unit.S);
    boolean isUp = settings.has("y") || (!settings.has("z") && find(log, "z").isEmpty());
    Column x = column(log, "x", "place-unit", Unit.Kind.LENGTH, Unit.M);
    Column y = column(log, isUp ? "y" : "z", "place-unit", Unit.Kind.LENGTH, Unit.M);
    Column heading = column(log, "heading", "angle-unit", Unit.Kind.ANGLE, Unit.DEG);
    OptionalInt run = find(log, "run");
    double sign = settings.word("angle-positive", "ccw", "cw").equals("cw") ? -1 : 1;
    assume("angle-positive", "Headings grow counter-clockwise (--angle-positive cw).");
    double zeroDeg = zeroDeg();
    Map<String, List<TrackPose>> track = new LinkedHashMap<>();
    int unseen = 0;
    for (int row = 0; row < log.size(); row++) {
      if (x.isUnseen(row) || y.isUnseen(row) || heading.isUnseen(row)) {
        unseen++;
        continue;
      }
      double headingRad = Math.toRadians(zeroDeg + sign * heading.value(row));
      double up = isUp ? y.value(row) : -y.value(row);
      track
          .computeIfAbsent(run(log, run, row), name -> new ArrayList<>())
          .add(new TrackPose(time.value(row) - startS, x.value(row), up, headingRad));
    }
    if (track.isEmpty()) {
      throw log.fault("has no row with a place and a heading");
    }
    if (unseen > 0) {
      notes.add(
          Assumptions.counted(unseen, "row")
              + (unseen == 1 ? " has" : " have")
              + " no pose (empty or NaN) and "
              + (unseen == 1 ? "is" : "are")
              + " left out of the track.");
    }
    return track;
  }

  private double zeroDeg() throws DataFormatException {
    Optional<String> word = settings.find("angle-zero");
    if (word.isEmpty()) {
      assumptions.add("A heading of 0 looks along +x (--angle-zero).");
      return 0;
    }
    Double known = ZEROS.get(word.get());
    return known != null ? known : LogSettings.measure("angle-zero", word.get(), Unit.Kind.ANGLE);
  }
}
