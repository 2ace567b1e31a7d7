package simbad.experiments.dataset;

import java.util.Optional;
import java.util.OptionalDouble;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.frame.Placement;
import simbad.sonar.frame.Pose;
import simbad.sonar.sensing.MovedObstacle;

/**
 * Where sensor and target were at a row. The target stands at the origin, or where it was moved to;
 * the sensor stands at a place, or at a distance from the target, and looks along a heading, or at
 * the target.
 *
 * @param place of the sensor
 * @param heading degrees counter-clockwise from +x; empty for one that looks at the target
 * @param panned degrees further to the left
 * @param targetX of the first obstacle, metres
 * @param targetZ likewise
 * @param targetTurn degrees counter-clockwise
 * @param believed how the scene has the first obstacle
 */
record PoseRule(
    Place place,
    Optional<LoggedFigure> heading,
    Optional<LoggedFigure> panned,
    Optional<LoggedFigure> targetX,
    Optional<LoggedFigure> targetZ,
    Optional<LoggedFigure> targetTurn,
    Placement believed) {
  private static final double QUARTER_DEG = 90;

  /** How the sensor's place is known. */
  sealed interface Place {}

  /**
   * Beside the line before the target, which lies along +z.
   *
   * @param distance along it
   * @param aside to the right of it
   * @param frontM from the target's centre to where the distance counts from
   * @param targetMoves the sensor stays, the target is moved away from it
   */
  record Ladder(LoggedFigure distance, LoggedFigure aside, double frontM, boolean targetMoves)
      implements Place {}

  /**
   * Round the target.
   *
   * @param distance from where the distance counts
   * @param bearing degrees from +z towards +x
   * @param frontM from the target's centre to there
   */
  record Round(LoggedFigure distance, LoggedFigure bearing, double frontM) implements Place {}

  /** On the plane: x to the right, z down the page. */
  record OnPlane(LoggedFigure x, LoggedFigure z) implements Place {}

  /** A row's poses. */
  record Poses(Pose sensor, MovedObstacle obstacle) {}

  /** A sensor that faces a target at a distance. */
  static PoseRule ladder(LoggedFigure distance, LoggedFigure aside, double frontM) {
    return new PoseRule(
        new Ladder(distance, aside, frontM, false),
        Optional.empty(),
        Optional.empty(),
        Optional.empty(),
        Optional.empty(),
        Optional.empty(),
        Placement.IDENTITY);
  }

  /** Where a sensor is and what lies before it. */
  private record Spot(double xM, double zM, double facingDeg, OptionalDouble targetZM) {}

  /**
   * Returns a row's poses.
   *
   * @return empty where a cell that they need is empty
   * @throws DataFormatException if something else than a number stands there
   */
  Optional<Poses> of(LogTable log, int row) throws DataFormatException {
    Optional<Spot> spot = spot(log, row);
    Optional<OptionalDouble> looks = find(heading, log, row);
    Optional<OptionalDouble> pan = find(panned, log, row);
    Optional<OptionalDouble> x = find(targetX, log, row);
    Optional<OptionalDouble> z = find(targetZ, log, row);
    Optional<OptionalDouble> turn = find(targetTurn, log, row);
    if (spot.isEmpty()
        || looks.isEmpty()
        || pan.isEmpty()
        || x.isEmpty()
        || z.isEmpty()
        || turn.isEmpty()) {
      return Optional.empty();
    }
    double headingDeg = looks.get().orElse(spot.get().facingDeg()) + pan.get().orElse(0);
    OptionalDouble awayM = spot.get().targetZM();
    return Optional.of(
        new Poses(
            Pose.of(spot.get().xM(), spot.get().zM(), Math.toRadians(headingDeg)),
            moved(x.get(), awayM.isPresent() ? awayM : z.get(), turn.get())));
  }

  /** What is not said of a target that is moved is as in the scene. */
  private MovedObstacle moved(OptionalDouble x, OptionalDouble z, OptionalDouble turnDeg) {
    return x.isEmpty() && z.isEmpty() && turnDeg.isEmpty()
        ? MovedObstacle.UNMOVED
        : new MovedObstacle(
            OptionalDouble.of(x.orElse(believed.xM())),
            OptionalDouble.of(z.orElse(believed.zM())),
            OptionalDouble.of(
                turnDeg.isPresent() ? Math.toRadians(turnDeg.getAsDouble()) : believed.turnRad()));
  }

  /** Empty where the cell is; an empty number where there is no figure. */
  private static Optional<OptionalDouble> find(Optional<LoggedFigure> figure, LogTable log, int row)
      throws DataFormatException {
    if (figure.isEmpty()) {
      return Optional.of(OptionalDouble.empty());
    }
    OptionalDouble value = figure.get().of(log, row);
    return value.isPresent() ? Optional.of(value) : Optional.empty();
  }

  private Optional<Spot> spot(LogTable log, int row) throws DataFormatException {
    if (place instanceof Ladder ladder) {
      return ladder(ladder, log, row);
    }
    if (place instanceof Round round) {
      OptionalDouble distance = round.distance().of(log, row);
      OptionalDouble bearing = round.bearing().of(log, row);
      return distance.isEmpty() || bearing.isEmpty()
          ? Optional.empty()
          : Optional.of(round(distance.getAsDouble() + round.frontM(), bearing.getAsDouble()));
    }
    OnPlane plane = (OnPlane) place;
    OptionalDouble x = plane.x().of(log, row);
    OptionalDouble z = plane.z().of(log, row);
    return x.isEmpty() || z.isEmpty()
        ? Optional.empty()
        : Optional.of(facingOrigin(x.getAsDouble(), z.getAsDouble()));
  }

  private static Optional<Spot> ladder(Ladder ladder, LogTable log, int row)
      throws DataFormatException {
    OptionalDouble distance = ladder.distance().of(log, row);
    OptionalDouble aside = ladder.aside().of(log, row);
    if (distance.isEmpty() || aside.isEmpty()) {
      return Optional.empty();
    }
    double awayM = ladder.frontM() + distance.getAsDouble();
    return Optional.of(
        ladder.targetMoves()
            ? new Spot(aside.getAsDouble(), 0, QUARTER_DEG, OptionalDouble.of(-awayM))
            : new Spot(aside.getAsDouble(), awayM, QUARTER_DEG, OptionalDouble.empty()));
  }

  private static Spot round(double awayM, double bearingDeg) {
    double bearing = Math.toRadians(bearingDeg);
    return new Spot(
        awayM * Math.sin(bearing),
        awayM * Math.cos(bearing),
        bearingDeg + QUARTER_DEG,
        OptionalDouble.empty());
  }

  private static Spot facingOrigin(double xM, double zM) {
    double facing = xM == 0 && zM == 0 ? 0 : Math.toDegrees(Math.atan2(zM, -xM));
    return new Spot(xM, zM, facing, OptionalDouble.empty());
  }
}
