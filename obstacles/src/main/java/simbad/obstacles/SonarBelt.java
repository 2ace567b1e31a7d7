package simbad.obstacles;

import java.util.OptionalDouble;
import java.util.function.Function;
import java.util.random.RandomGenerator;
import simbad.sim.RangeSensorBelt;
import simbad.sim.World;
import simbad.sonar.model.SensorModel;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.sensing.Readings;
import simbad.sonar.sensing.Sensor;
import simbad.sonar.sensing.TransducerPoses;

/**
 * A ring of sonars at one point that hear obstacles as a sensor model says, by default the
 * shadows'.
 *
 * <p>It hears every {@link SonarObstacle} that is in the world when it pings, moved ones where they
 * are by then. Objects without a threshold table, such as boxes and other robots, it does not hear:
 * nothing was measured of them.
 */
public class SonarBelt extends RangeSensorBelt {
  private final SonarSpec spec;
  private final SensorModel model;
  private final RandomGenerator random;

  /**
   * Creates a belt.
   *
   * @param sonars number of sonars, evenly spaced counter-clockwise from straight ahead
   * @param spec figures of each sonar
   * @param model what a sonar hears of a scene
   * @param random source of chance for models with noise
   */
  public SonarBelt(int sonars, SonarSpec spec, SensorModel model, RandomGenerator random) {
    super(0, (float) spec.minRangeM(), (float) spec.maxRangeM(), sonars, TYPE_SONAR, 0);
    setName("sonars");
    this.spec = spec;
    this.model = model;
    this.random = random;
    setName("sonars");
  }

  @Override
  protected Sensor createSensor(World world) {
    return new WorldSensor(world, this::bind);
  }

  /** Returns the half angle of the cone in which the sonars hear. */
  @Override
  protected OptionalDouble findConeHalfAngleRad() {
    return OptionalDouble.of(spec.coneHalfAngleRad());
  }

  private Sensor bind(World world) {
    Scene scene =
        new Scene(
            world.getStaticObjects().stream()
                .filter(SonarObstacle.class::isInstance)
                .map(SonarObstacle.class::cast)
                .filter(obstacle -> obstacle.getSolid().isPresent())
                .map(SonarObstacle::asSensed)
                .toList());
    return model.bind(spec, scene, random);
  }

  /** A sensor that is bound anew whenever the world's static objects have changed. */
  private static final class WorldSensor implements Sensor {
    private final World world;
    private final Function<World, Sensor> binding;
    private Sensor bound;
    private long boundAt;

    WorldSensor(World world, Function<World, Sensor> binding) {
      this.world = world;
      this.binding = binding;
      bound = binding.apply(world);
      boundAt = world.getStaticRevision();
    }

    @Override
    public void ping(TransducerPoses poses, double timeS, Readings readings) {
      if (boundAt != world.getStaticRevision()) {
        bound = binding.apply(world);
        boundAt = world.getStaticRevision();
      }
      bound.ping(poses, timeS, readings);
    }

    @Override
    public void reset() {
      bound.reset();
    }
  }
}
