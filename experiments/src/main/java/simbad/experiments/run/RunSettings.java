package simbad.experiments.run;

import java.util.List;
import java.util.Optional;
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
    double waitS,
    boolean keepsReadings) {
  /** Thesis, section 4.3. */
  public static final double THESIS_SPEED_M_PER_S = 0.01;

  /** Copies the lists. */
  public RunSettings {
    obstacles = List.copyOf(obstacles);
    sensors = List.copyOf(sensors);
    requireSpeed(speedMPerS);
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
    this(obstacles, sensors, sonar, speedMPerS, start, seed, 0, false);
  }

  /** Returns the same with a robot that stands still for so many seconds after each decision. */
  public RunSettings waiting(double seconds) {
    return new RunSettings(
        obstacles, sensors, sonar, speedMPerS, start, seed, seconds, keepsReadings);
  }

  /** Returns the same, and what the belt reads in each step is kept. */
  public RunSettings keepingReadings() {
    return new RunSettings(obstacles, sensors, sonar, speedMPerS, start, seed, waitS, true);
  }

  /** Returns the same in steps of the simulator. */
  int waitSteps() {
    return (int) Math.round(waitS / Circuit.STEP_S);
  }

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
