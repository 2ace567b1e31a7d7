package simbad.sonar.ping;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;
import simbad.sonar.frame.Placement;
import simbad.sonar.scene.Detection;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.Scene;
import simbad.sonar.shape.Outline;

/** Scenes with some obstacles changed. */
public final class Scenes {
  private Scenes() {}

  /**
   * By what changes tell obstacles apart: their names; of several with one name each has its number
   * from 1 behind it.
   */
  public static List<String> labels(Scene scene) {
    List<String> names = scene.obstacles().stream().map(Obstacle::name).toList();
    return IntStream.range(0, names.size())
        .mapToObj(i -> isAlone(names.get(i), names) ? names.get(i) : names.get(i) + "#" + (i + 1))
        .toList();
  }

  private static boolean isAlone(String name, List<String> names) {
    return names.indexOf(name) == names.lastIndexOf(name);
  }

  /** Returns a scene in which an obstacle, or all where none is named, is moved. */
  public static Scene placed(Scene scene, Optional<String> only, UnaryOperator<Placement> change) {
    return changed(scene, only, o -> o.with(change.apply(o.worldFromObstacle())));
  }

  /** Returns a scene in which an obstacle, or all where none is named, is heard otherwise. */
  public static Scene detected(
      Scene scene, Optional<String> only, UnaryOperator<Detection> change) {
    return changed(scene, only, o -> o.with(change.apply(o.detection())));
  }

  /** Returns a scene in which an obstacle, or all where none is named, has another outline. */
  public static Scene shaped(Scene scene, Optional<String> only, UnaryOperator<Outline> change) {
    return changed(scene, only, o -> o.with(change.apply(o.outline())));
  }

  /** A label that no obstacle has changes none. */
  private static Scene changed(Scene scene, Optional<String> only, UnaryOperator<Obstacle> change) {
    List<String> labels = labels(scene);
    List<Obstacle> obstacles = new ArrayList<>();
    for (int i = 0; i < labels.size(); i++) {
      Obstacle obstacle = scene.obstacles().get(i);
      boolean meant = only.map(labels.get(i)::equals).orElse(true);
      obstacles.add(meant ? change.apply(obstacle) : obstacle);
    }
    return new Scene(obstacles);
  }
}
