package simbad.sonar.model;

import java.util.random.RandomGenerator;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.sensing.Sensor;

/** The sensor models that need nothing but the scene: when does an obstacle echo? */
public enum DetectionRule implements SensorModel {
  /**
   * Some of the outline lies in the cone, between the sensor's least and greatest range, and the
   * sensor stands in the detection shadow; reads the nearest such point. Kranz (2014), section
   * 4.2.4.
   */
  SHADOW {
    @Override
    public Sensor bind(SonarSpec sensor, Scene scene, RandomGenerator random) {
      return new ShadowSensor(sensor, scene);
    }
  },
  /**
   * The cone, as long as the sensor's greatest range, and the shadow overlap anywhere; reads the
   * nearest point of the outline, in the cone or not.
   */
  OVERLAP {
    @Override
    public Sensor bind(SonarSpec sensor, Scene scene, RandomGenerator random) {
      return new OverlapSensor(sensor, scene);
    }
  },
  /**
   * Simbad's sensor as Kranz (2014, section 4.2.2) describes it: some of the outline lies in the
   * cone, no further than 2.5 m, whatever the obstacle's orientation; reads the nearest such point.
   */
  ORIGINAL {
    @Override
    public Sensor bind(SonarSpec sensor, Scene scene, RandomGenerator random) {
      return new OriginalSensor(sensor, scene);
    }
  },
  /** The nominal model with its misses, soft threshold, range noise and resolution. */
  NOISY {
    @Override
    public Sensor bind(SonarSpec sensor, Scene scene, RandomGenerator random) {
      return new NoisySensor(new NominalModel(sensor, scene), random);
    }
  },
  /**
   * The {@link LevelModel} without its scatter: an echo where its energy reaches the receiver's
   * threshold, which is where its chance, misses apart, is at least 1/2; reads the distance plus
   * the walk.
   */
  LEVEL {
    @Override
    public Sensor bind(SonarSpec sensor, Scene scene, RandomGenerator random) {
      return LevelSensor.certain(new LevelModel(sensor, scene));
    }
  },
  /** The {@link LevelModel} with its scatter, misses, range noise and resolution. */
  LEVEL_NOISY {
    @Override
    public Sensor bind(SonarSpec sensor, Scene scene, RandomGenerator random) {
      return LevelSensor.noisy(new LevelModel(sensor, scene), random);
    }
  };

  /** How far the original sensor hears, in metres: Kranz (2014), section 4.2.2. */
  public static final double ORIGINAL_RANGE_M = 2.5;
}
