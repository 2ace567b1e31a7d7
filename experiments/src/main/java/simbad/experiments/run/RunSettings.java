package simbad.experiments.run;

import java.util.List;
import java.util.Optional;
import simbad.obstacles.ObstacleType;
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
 * @param pace how much time the robot is given for each decision
 * @param keepsReadings whether what the belt reads in each step is kept
 */
public record RunSettings(
    List<ObstacleType> obstacles,
    List<SensorKind> sensors,
    SonarSpec sonar,
    double speedMPerS,
    Optional<Point> start,
    long seed,
    Pace pace,
    boolean keepsReadings) {
  /** Thesis, section 4.3. */
  public static final double THESIS_SPEED_M_PER_S = 0.01;

  /** Copies the lists. */
  public RunSettings {
    obstacles = List.copyOf(obstacles);
    sensors = List.copyOf(sensors);
    requireSpeed(speedMPerS);
  }

  /** Of a robot that never waits, and whose readings are not kept. */
  public RunSettings(
      List<ObstacleType> obstacles,
      List<SensorKind> sensors,
      SonarSpec sonar,
      double speedMPerS,
      Optional<Point> start,
      long seed) {
    this(obstacles, sensors, sonar, speedMPerS, start, seed, Pace.AT_ONCE, false);
  }

  /** Returns the same with a robot that is given so much time for each decision. */
  public RunSettings at(Pace other) {
    return new RunSettings(
        obstacles, sensors, sonar, speedMPerS, start, seed, other, keepsReadings);
  }

  /** Returns the same, and what the belt reads in each step is kept. */
  public RunSettings keepingReadings() {
    return new RunSettings(obstacles, sensors, sonar, speedMPerS, start, seed, pace, true);
  }

  /** A faster robot would pass by the obstacle between two steps. */
  public static final double GREATEST_SPEED_M_PER_S = 1;

  static void requireSpeed(double speedMPerS) {
    if (!(speedMPerS > 0 && speedMPerS <= GREATEST_SPEED_M_PER_S)) {
      throw new IllegalArgumentException(
          "speedMPerS = " + speedMPerS + " is not in (0, " + GREATEST_SPEED_M_PER_S + "]");
    }
  }
}
