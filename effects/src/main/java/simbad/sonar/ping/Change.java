package simbad.sonar.ping;

import java.util.ArrayList;
import java.util.List;

/**
 * One departure of the world from the nominal model, with its parameters.
 *
 * <p>Each kind of change acts at one stage of a ping: on the pose, on the scene, on the sensor's
 * figures, on thresholds, on what arrives, on what is read. At its neutral parameters a change
 * leaves the nominal model as it is to the last bit. Changes are immutable values, equal when their
 * parameters are.
 */
public sealed interface Change
    permits PoseChange,
        SceneChange,
        SensorChange,
        ThresholdChange,
        LevelChange,
        EchoChange,
        ArrivalChange,
        LossChange,
        MixtureChange,
        RangeChange,
        OutputChange,
        MemoryChange {

  /**
   * Tells whether what is computed of a log's geometry depends on it: poses, scene, cone or the law
   * of hearing.
   */
  default boolean changesGeometry() {
    return false;
  }

  /** Tells whether it asks what the transducer saw at its ping before. */
  default boolean looksBack() {
    return false;
  }

  /** Returns the changes of one kind, in a list that may be changed. */
  static <T> List<T> only(Class<T> kind, List<? extends Change> changes) {
    List<T> some = new ArrayList<>();
    for (Change change : changes) {
      if (kind.isInstance(change)) {
        some.add(kind.cast(change));
      }
    }
    return some;
  }
}
