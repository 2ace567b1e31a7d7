package simbad.experiments.dataset;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import simbad.sonar.format.DataFormatException;

/** Where a log's sensor and target were, as the options say it. */
final class LogPoses {
  /** Whose value in a ladder stands in the names of the range columns. */
  static final String HEADER = "header";

  private static final String DISTANCE = "distance";
  private static final double LEAST = -LoggedFigure.GREATEST;
  private static final Map<String, Double> ZEROS =
      Map.of("right", 0.0, "up", 90.0, "left", 180.0, "down", 270.0);

  private final LogTable log;
  private final LogSettings settings;
  private final LogFigures figures;
  private final Assumptions assumptions;
  private final Target target;

  LogPoses(LogTable log, LogSettings settings, Assumptions assumptions, Target target) {
    this.log = log;
    this.settings = settings;
    this.assumptions = assumptions;
    this.target = target;
    figures = new LogFigures(log, settings, assumptions);
  }

  /**
   * Returns the rule for a column of ranges.
   *
   * @param range the column
   * @param mounted whether poses are a robot's
   */
  PoseRule rule(int range, boolean mounted) throws DataFormatException {
    Optional<LoggedFigure> heading = heading();
    PoseRule.Place place = place(range);
    if (place instanceof PoseRule.OnPlane && heading.isEmpty()) {
      if (mounted) {
        throw LogSettings.fault(
            "heading", "is missing: with --mount the robot's heading; saw " + log.shown());
      }
      assumptions.add("The sensor looks at the target from wherever it stands (--heading).");
    }
    return new PoseRule(
        place,
        heading,
        figures.angle("pan"),
        targetX(),
        targetZ(),
        figures.angle("target-turn"),
        target.place());
  }

  private PoseRule.Place place(int range) throws DataFormatException {
    Optional<LoggedFigure> distance = distance(range);
    Optional<LoggedFigure> x =
        figures.length("x", "pose-unit", LEAST).map(is -> is.from(origin(0)));
    if (settings.has("bearing")) {
      if (distance.isEmpty()) {
        throw LogSettings.fault(DISTANCE, "is missing: --bearing needs the distance as well");
      }
      return new PoseRule.Round(
          distance.get(), figures.angle("bearing").orElseThrow(), frontM("centre"));
    }
    if (distance.isPresent()) {
      boolean turned = settings.has("target-turn");
      boolean targetMoves = settings.word("moves", "sensor", "target").equals("target");
      return new PoseRule.Ladder(
          distance.get(),
          x.orElse(LoggedFigure.constant(0, Unit.M)),
          frontM(turned ? "centre" : "surface"),
          targetMoves);
    }
    return onPlane(x);
  }

  private PoseRule.Place onPlane(Optional<LoggedFigure> x) throws DataFormatException {
    Optional<LoggedFigure> z = down("z", "y");
    boolean movedTarget =
        settings.has("target-x") || settings.has("target-z") || settings.has("target-y");
    if (x.isEmpty() && z.isEmpty() && movedTarget) {
      assumptions.add("The sensor stands at the origin of the target's places (--x, --z).");
      return new PoseRule.OnPlane(
          LoggedFigure.constant(0, Unit.M), LoggedFigure.constant(0, Unit.M));
    }
    if (x.isEmpty() || z.isEmpty()) {
      throw LogSettings.fault(
          x.isEmpty() ? "x" : "z",
          "is missing: a place is --x with --z (down the page) or --y (up); saw " + log.shown());
    }
    return new PoseRule.OnPlane(x.get(), z.get());
  }

  private Optional<LoggedFigure> distance(int range) throws DataFormatException {
    if (!settings.find(DISTANCE).filter(HEADER::equals).isPresent()
        || LogColumns.find(log, HEADER).isPresent()) {
      return figures.length(DISTANCE, "distance-unit", 0);
    }
    String name = log.names().get(range);
    Optional<LogNumber> number = LogNumber.find(name, log.decimalComma());
    if (number.isEmpty()) {
      throw LogSettings.fault(
          DISTANCE, "header: the column's name '" + name + "' is not a distance such as 30cm");
    }
    Optional<Unit> own = number.get().unit();
    Unit unit = own.isPresent() ? own.get() : figures.unit("distance-unit", Unit.Kind.LENGTH);
    return Optional.of(LoggedFigure.constant(unit.si(number.get().value()), Unit.M));
  }

  private double frontM(String usual) throws DataFormatException {
    String to = settings.find("distance-to").orElse(usual);
    if (!List.of("surface", "centre").contains(to)) {
      throw LogSettings.fault("distance-to", "'" + to + "' is not one of surface, centre");
    }
    double front = target.frontM();
    if (!settings.has("distance-to") && front != 0) {
      assumptions.add("Distances are measured to the target's " + to + " (--distance-to).");
    }
    return to.equals("surface") ? front : 0;
  }

  /** What is down the page under one name, or up under another. */
  private Optional<LoggedFigure> down(String down, String up) throws DataFormatException {
    if (settings.has(down) && settings.has(up)) {
      throw LogSettings.fault(up, "does not go with --" + down + ", expected one of them");
    }
    Optional<LoggedFigure> below = figures.length(down, "pose-unit", LEAST);
    return below.isPresent()
        ? below.map(figure -> figure.from(origin(1)))
        : figures.length(up, "pose-unit", LEAST).map(is -> is.from(origin(1)).turned(-1, 0));
  }

  private Optional<LoggedFigure> targetX() throws DataFormatException {
    return figures.length("target-x", "pose-unit", LEAST).map(is -> is.from(origin(0)));
  }

  private Optional<LoggedFigure> targetZ() throws DataFormatException {
    return down("target-z", "target-y");
  }

  /** Checked when the import begins. */
  private double origin(int axis) {
    String text = settings.find("origin").orElse("0,0");
    return LogNumber.find(text.split(",", -1)[axis].strip(), false).orElseThrow().value();
  }

  static void requireOrigin(LogSettings settings) throws DataFormatException {
    String text = settings.find("origin").orElse("0,0");
    String[] parts = text.split(",", -1);
    for (String part : parts) {
      Optional<LogNumber> number = LogNumber.find(part.strip(), false);
      if (parts.length != 2 || number.isEmpty() || number.get().unit().isPresent()) {
        throw LogSettings.fault(
            "origin", "'" + text + "' is not X,Z in the log's own unit, such as 88,76");
      }
    }
  }

  private Optional<LoggedFigure> heading() throws DataFormatException {
    if (settings.find("heading").filter("target"::equals).isPresent()) {
      return Optional.empty();
    }
    Optional<LoggedFigure> heading = figures.angle("heading");
    if (heading.isEmpty() || heading.get().column().isEmpty()) {
      return heading;
    }
    return Optional.of(heading.get().turned(heading.get().sign(), zero()));
  }

  private double zero() throws DataFormatException {
    Optional<String> zero = settings.find("angle-zero");
    if (zero.isEmpty()) {
      assumptions.add("A heading of 0 looks along +x, to the right (--angle-zero).");
      return 0;
    }
    Double known = ZEROS.get(zero.get());
    return known != null ? known : LogSettings.measure("angle-zero", zero.get(), Unit.Kind.ANGLE);
  }
}
