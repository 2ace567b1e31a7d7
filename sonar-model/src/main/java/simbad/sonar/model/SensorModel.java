package simbad.sonar.model;

import java.util.random.RandomGenerator;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.sensing.Sensor;

/** A way of hearing, not yet bound to a scene: makes the sensor that a belt takes. */
@FunctionalInterface
public interface SensorModel {
  /**
   * Binds the model.
   *
   * @param sensor the sensor's figures
   * @param scene what may be heard
   * @param random source of chance, for models that have noise
   */
  Sensor bind(SonarSpec sensor, Scene scene, RandomGenerator random);
}
