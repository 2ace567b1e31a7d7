package simbad.experiments.run;

import java.util.List;
import java.util.Optional;
import simbad.experiments.control.Controller;
import simbad.obstacles.ObstacleType;
import simbad.sonar.frame.Point;
import simbad.sonar.scene.SonarSpec;

/**
 * What one robot shall do: once round an obstacle, by what a sensor says.
 *
 * @param type of the obstacle, which stands at the origin
 * @param around what else stands there
 * @param sensor of the robot
 * @param sonar figures of the sensor
 * @param speedMPerS of the robot, in (0, {@value RunSettings#GREATEST_SPEED_M_PER_S}]
 * @param start where the robot starts; by default on the bearing of the greatest threshold,
 *     half-way out
 * @param seed of all chance
 */
public record Circuit(
    ObstacleType type,
    List<Neighbour> around,
    SensorKind sensor,
    SonarSpec sonar,
    double speedMPerS,
    Optional<Point> start,
    long seed) {
  /** The simulator's step, seconds. */
  public static final double STEP_S = 0.05;

  /** Copies the list and checks the speed. */
  public Circuit {
    around = List.copyOf(around);
    RunSettings.requireSpeed(speedMPerS);
  }

  /** One of the circuits of a run. */
  static Circuit of(ObstacleType type, SensorKind sensor, RunSettings settings) {
    return new Circuit(
        type,
        List.of(),
        sensor,
        settings.sonar(),
        settings.speedMPerS(),
        settings.start(),
        settings.seed());
  }

  /**
   * Drives the robot until it is once round, or stuck, or lost.
   *
   * @param controller that has read nothing yet
   * @return where the robot was
   */
  public Trace drive(Controller controller) {
    return drive(controller, 1, false);
  }

  /**
   * Does the same with a controller that gives the robot time.
   *
   * @param controller that has read nothing yet
   * @param times how many steps it takes for one of a controller that never waits, at least 1
   */
  public Trace drive(Controller controller, int times) {
    return drive(controller, times, false);
  }

  /**
   * Does the same, and may keep what was read.
   *
   * @param controller that has read nothing yet
   * @param times how many steps it takes for one of a controller that never waits, at least 1
   * @param keepsReadings whether the trace shall have what the belt read
   */
  Trace drive(Controller controller, int times, boolean keepsReadings) {
    return new Circumnavigation(this, controller, keepsReadings).drive(times);
  }

  /**
   * Returns the robot that {@link #drive} drives, at its start, to be stepped by who looks on.
   *
   * @param controller that has read nothing yet
   */
  public FollowerRobot robot(Controller controller) {
    return Circumnavigation.robot(this, controller);
  }

  /** Compares a trace of this circuit with the obstacle's table. */
  public TraceErrors errors(Trace trace) {
    return TraceErrors.of(trace, type.thresholds().table());
  }
}
