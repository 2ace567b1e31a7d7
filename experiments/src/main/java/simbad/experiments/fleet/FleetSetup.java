package simbad.experiments.fleet;

import java.util.List;
import simbad.experiments.run.Neighbour;
import simbad.experiments.run.SensorKind;
import simbad.obstacles.ObstacleType;
import simbad.sonar.check.Checks;
import simbad.sonar.scene.SonarSpec;

/**
 * What every robot of a fleet finds.
 *
 * @param circled the obstacle at the origin, whose detection shadow has the edge that counts
 * @param around what else stands there
 * @param sensor of the robots, on the robot that it sits on
 * @param sonar figures of the sensor
 * @param mostSteps of an episode, at least 1
 * @param mostMPerS speed that a faster command is cut to, either way; positive
 * @param mostRadPerS turn rate that a faster command is cut to; positive
 * @param noEchoM what stands in the place of no echo, and of every longer range, metres; positive
 */
public record FleetSetup(
    ObstacleType circled,
    List<Neighbour> around,
    SensorKind sensor,
    SonarSpec sonar,
    int mostSteps,
    double mostMPerS,
    double mostRadPerS,
    double noEchoM) {

  /** Copies the list and checks the figures. */
  public FleetSetup {
    around = List.copyOf(around);
    if (mostSteps < 1) {
      throw new IllegalArgumentException("mostSteps = " + mostSteps + " is not at least 1");
    }
    Checks.positive("mostMPerS", mostMPerS);
    Checks.positive("mostRadPerS", mostRadPerS);
    Checks.positive("noEchoM", noEchoM);
  }
}
