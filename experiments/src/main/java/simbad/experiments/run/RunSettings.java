package simbad.experiments.run;

import java.util.List;
import java.util.Optional;
import simbad.experiments.control.Tuning;
import simbad.obstacles.ObstacleType;
import simbad.sonar.check.Checks;
import simbad.sonar.frame.Point;
import simbad.sonar.scene.SonarSpec;

/**
 * What a run shall do.
 *
 * @param obstacles one circumnavigation of each per sensor; names distinct
 * @param sensors which sensors, distinct
 * @param sonar figures of the sensor
 * @param speedMPerS of the robot, positive
 * @param start where the robot starts, the obstacle at the origin; by default on the bearing of the
 *     greatest threshold, half-way out
 * @param seed of all chance
 * @param turnRateRadPerS how fast the robot is told to turn at most; what the controller wants to
 *     turn faster takes several steps on the spot
 * @param waitS how long the robot stands still after each decision, seconds, at least 0
 * @param keepsReadings whether what the belt reads in each step is kept
 */
public record RunSettings(
    List<ObstacleType> obstacles,
    List<SensorKind> sensors,
    SonarSpec sonar,
    double speedMPerS,
    Optional<Point> start,
    long seed,
    double turnRateRadPerS,
    double waitS,
    boolean keepsReadings) {
  /** Thesis, section 4.3. */
  public static final double THESIS_SPEED_M_PER_S = 0.01;

  /** Copies the lists. */
  public RunSettings {
    obstacles = List.copyOf(obstacles);
    sensors = List.copyOf(sensors);
    requireSpeed(speedMPerS);
    Checks.within("turnRateRadPerS", turnRateRadPerS, LEAST_TURN_RATE_RAD_PER_S, Tuning.TURN_RATE);
    Checks.within("waitS", waitS, 0, MOST_WAIT_S);
  }

  /** Of a robot that never waits, and whose readings are not kept. */
  public RunSettings(
      List<ObstacleType> obstacles,
      List<SensorKind> sensors,
      SonarSpec sonar,
      double speedMPerS,
      Optional<Point> start,
      long seed) {
    this(obstacles, sensors, sonar, speedMPerS, start, seed, Tuning.TURN_RATE, 0, false);
  }

  /** Returns the same with a robot that stands still for so many seconds after each decision. */
  public RunSettings waiting(double seconds) {
    return new RunSettings(
        obstacles,
        sensors,
        sonar,
        speedMPerS,
        start,
        seed,
        turnRateRadPerS,
        seconds,
        keepsReadings);
  }

  /** Returns the same with a robot that is told no faster turns, radians per second. */
  public RunSettings turningAtMost(double radPerS) {
    return new RunSettings(
        obstacles, sensors, sonar, speedMPerS, start, seed, radPerS, waitS, keepsReadings);
  }

  /** Returns the same, and what the belt reads in each step is kept. */
  public RunSettings keepingReadings() {
    return new RunSettings(
        obstacles, sensors, sonar, speedMPerS, start, seed, turnRateRadPerS, waitS, true);
  }

  /** Returns whether each decision of the controller takes one step. */
  boolean isAtOnce() {
    return waitSteps() == 0 && turnRateRadPerS == Tuning.TURN_RATE;
  }

  /** Returns the most steps that a decision of the controller takes. */
  int mostSteps() {
    return isAtOnce() ? 1 : 1 + waitSteps() + (int) Math.ceil(Tuning.TURN_RATE / turnRateRadPerS);
  }

  /** Returns how long the robot waits in steps of the simulator. */
  int waitSteps() {
    return (int) Math.round(waitS / Circuit.STEP_S);
  }

  /** A robot that turns more slowly takes an hour to turn back. */
  public static final double LEAST_TURN_RATE_RAD_PER_S = 0.001;

  /** A robot that waits longer takes a day round an obstacle. */
  public static final double MOST_WAIT_S = 5;

  /** A faster robot would pass by the obstacle between two steps. */
  public static final double GREATEST_SPEED_M_PER_S = 1;

  static void requireSpeed(double speedMPerS) {
    if (!(speedMPerS > 0 && speedMPerS <= GREATEST_SPEED_M_PER_S)) {
      throw new IllegalArgumentException(
          "speedMPerS = " + speedMPerS + " is not in (0, " + GREATEST_SPEED_M_PER_S + "]");
    }
  }
}
