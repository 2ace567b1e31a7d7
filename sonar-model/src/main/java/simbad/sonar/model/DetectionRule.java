package simbad.sonar.model;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.random.RandomGenerator;
import simbad.sonar.frame.Pose;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.Reading;
import simbad.sonar.sensing.Readings;
import simbad.sonar.sensing.Sensor;
import simbad.sonar.sensing.TransducerPoses;
import simbad.sonar.shape.Outline;

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

  private static final class ShadowSensor extends ConeSensor {
    private final double minRangeM;
    private final double maxRangeM;

    ShadowSensor(SonarSpec sensor, Scene scene) {
      super(sensor, scene, PlacedObstacle::greatestThresholdM);
      minRangeM = sensor.minRangeM();
      maxRangeM = sensor.maxRangeM();
    }

    @Override
    boolean isAudible(PlacedObstacle obstacle, double xM, double zM) {
      return obstacle.inShadow(xM, zM);
    }

    @Override
    double echoM(Audible audible, TransducerPose from) {
      return atLeast(minRangeM, audible.nearestM(cone, from, maxRangeM));
    }
  }

  private static final class OverlapSensor extends ConeSensor {
    private final double maxRangeM;
    private final Map<PlacedObstacle, Optional<Outline>> edges = new HashMap<>();

    OverlapSensor(SonarSpec sensor, Scene scene) {
      super(sensor, scene, obstacle -> sensor.maxRangeM() + obstacle.greatestThresholdM());
      maxRangeM = sensor.maxRangeM();
    }

    @Override
    boolean isAudible(PlacedObstacle obstacle, double xM, double zM) {
      return obstacle.centreDistanceM(xM, zM) <= maxRangeM + obstacle.greatestThresholdM();
    }

    @Override
    double echoM(Audible audible, TransducerPose from) {
      PlacedObstacle obstacle = audible.obstacle();
      // The tip in the shadow, or the shadow's edge in the cone: no other way to overlap.
      return obstacle.inShadow(from.xM, from.zM) || edgeM(obstacle, from) <= maxRangeM
          ? audible.distanceM()
          : Double.POSITIVE_INFINITY;
    }

    /**
     * The nearest point of the shadow's edge in the cone; infinity without one, or without shadow.
     */
    private double edgeM(PlacedObstacle obstacle, TransducerPose from) {
      Optional<Outline> edge = edges.computeIfAbsent(obstacle, PlacedObstacle::shadowEdge);
      return edge.isPresent()
          ? cone.nearestM(edge.get(), from.xM, from.zM, from.directionX, from.directionZ)
          : Double.POSITIVE_INFINITY;
    }
  }

  private static final class OriginalSensor extends ConeSensor {
    private final double minRangeM;

    OriginalSensor(SonarSpec sensor, Scene scene) {
      super(sensor, scene, obstacle -> ORIGINAL_RANGE_M + obstacle.reachM());
      minRangeM = sensor.minRangeM();
    }

    @Override
    boolean isAudible(PlacedObstacle obstacle, double xM, double zM) {
      return obstacle.centreDistanceM(xM, zM) - obstacle.reachM() <= ORIGINAL_RANGE_M;
    }

    @Override
    double echoM(Audible audible, TransducerPose from) {
      return atLeast(minRangeM, audible.nearestM(cone, from, ORIGINAL_RANGE_M));
    }
  }

  private static final class NoisySensor implements Sensor {
    private final NominalModel model;
    private final RandomGenerator random;

    NoisySensor(NominalModel model, RandomGenerator random) {
      this.model = model;
      this.random = random;
    }

    @Override
    public void ping(TransducerPoses poses, double timeS, Readings readings) {
      for (int i = 0; i < poses.size(); i++) {
        Pose pose = Pose.of(poses.xM(i), poses.zM(i), poses.headingRad(i));
        Reading reading = model.distribution(pose).sample(random);
        if (reading instanceof Echo echo) {
          readings.setEcho(i, echo.rangeM());
        } else {
          readings.setNoEcho(i);
        }
      }
    }
  }
}
