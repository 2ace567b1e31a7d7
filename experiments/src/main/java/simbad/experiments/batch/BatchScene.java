package simbad.experiments.batch;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import simbad.experiments.run.Neighbour;
import simbad.obstacles.ObstacleType;
import simbad.sonar.format.TableDocument;
import simbad.sonar.frame.Placement;
import simbad.sonar.frame.Point;
import simbad.sonar.scene.Detection;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.scene.TableDetection;
import simbad.sonar.shape.ThresholdTable;

/**
 * What a robot circles, and what else stands there.
 *
 * @param name of the scene's file; empty for an obstacle alone
 * @param circled the obstacle that is circled, which stands at the origin
 * @param around what else stands there
 * @param sonar of the scene's file
 */
record BatchScene(
    String name, ObstacleType circled, List<Neighbour> around, Optional<SonarSpec> sonar) {
  /** A circle as a polygon: with these many corners it is nowhere more than 0.004 % too near. */
  private static final int BEARINGS = 360;

  BatchScene {
    around = List.copyOf(around);
  }

  static BatchScene alone(ObstacleType type) {
    return new BatchScene("", type, List.of(), Optional.empty());
  }

  /** The first obstacle of a scene is circled: its own frame becomes the world's. */
  static BatchScene of(String name, SensingSetup setup) {
    List<Obstacle> obstacles = setup.scene().obstacles();
    Placement first = obstacles.get(0).worldFromObstacle();
    List<Neighbour> around = new ArrayList<>();
    for (Obstacle other : obstacles.subList(1, obstacles.size())) {
      around.add(new Neighbour(type(other), seenFrom(first, other.worldFromObstacle())));
    }
    return new BatchScene(name, type(obstacles.get(0)), around, Optional.of(setup.sensor()));
  }

  private static Placement seenFrom(Placement first, Placement other) {
    Point centre = first.obstacleFromWorld(new Point(other.xM(), other.zM()));
    return new Placement(centre.xM(), centre.zM(), other.turnRad() - first.turnRad());
  }

  private static ObstacleType type(Obstacle obstacle) {
    return new ObstacleType(
        obstacle.name(), obstacle.outline(), new TableDocument(table(obstacle), Map.of()));
  }

  private static ThresholdTable table(Obstacle obstacle) {
    Detection detection = obstacle.detection();
    return detection
        .findTable()
        .orElseGet(() -> ThresholdTable.uniform(BEARINGS, detection.greatestM()));
  }

  /** How a row names it. */
  String label() {
    return name.isEmpty() ? circled.name() : name;
  }

  /** The same for models of sensors. */
  Scene asSensed() {
    List<Obstacle> obstacles = new ArrayList<>();
    obstacles.add(sensed(circled, Placement.IDENTITY));
    around.forEach(other -> obstacles.add(sensed(other.type(), other.placement())));
    return new Scene(obstacles);
  }

  private static Obstacle sensed(ObstacleType type, Placement placement) {
    return new Obstacle(
        type.name(), placement, type.outline(), new TableDetection(type.thresholds().table()));
  }
}
