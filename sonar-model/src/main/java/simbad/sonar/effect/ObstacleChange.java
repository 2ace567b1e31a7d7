package simbad.sonar.effect;

import java.util.List;
import java.util.Optional;

/** What a change says may be of one obstacle only. */
interface ObstacleChange {
  /** Returns the label of the one obstacle that the change is about; empty for all obstacles. */
  Optional<String> only();

  /** Tells whether it is about an obstacle. */
  default boolean isOf(String label) {
    return only().map(label::equals).orElse(true);
  }

  /** Tells whether it is about no obstacle of a scene. */
  default boolean isIdle(List<String> labels) {
    return only().filter(only -> !labels.contains(only)).isPresent();
  }
}
