package simbad.sonar.effect;

import java.util.ArrayList;
import java.util.List;
import java.util.function.UnaryOperator;
import simbad.sonar.frame.Placement;
import simbad.sonar.scene.Detection;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.Scene;

/** Scenes with some obstacles changed. */
final class Scenes {
  private Scenes() {}

  /** An obstacle's name; of several with one name each has its number from 1 behind it. */
  static String label(Scene scene, int obstacle) {
    String name = scene.obstacles().get(obstacle).name();
    boolean alone = scene.obstacles().stream().filter(o -> o.name().equals(name)).count() == 1;
    return alone ? name : name + "#" + (obstacle + 1);
  }

  static Scene placed(Scene scene, int which, UnaryOperator<Placement> change) {
    return changed(
        scene,
        which,
        obstacle ->
            new Obstacle(
                obstacle.name(),
                change.apply(obstacle.worldFromObstacle()),
                obstacle.outline(),
                obstacle.detection()));
  }

  static Scene detected(Scene scene, int which, UnaryOperator<Detection> change) {
    return changed(
        scene,
        which,
        obstacle ->
            new Obstacle(
                obstacle.name(),
                obstacle.worldFromObstacle(),
                obstacle.outline(),
                change.apply(obstacle.detection())));
  }

  /** Changes one obstacle, or all for a negative index. */
  private static Scene changed(Scene scene, int which, UnaryOperator<Obstacle> change) {
    List<Obstacle> obstacles = new ArrayList<>();
    for (int i = 0; i < scene.obstacles().size(); i++) {
      Obstacle obstacle = scene.obstacles().get(i);
      obstacles.add(which < 0 || which == i ? change.apply(obstacle) : obstacle);
    }
    return new Scene(obstacles);
  }
}
