package simbad.obstacles;

import java.util.function.Function;
import simbad.sim.World;
import simbad.sonar.sensing.Readings;
import simbad.sonar.sensing.Sensor;
import simbad.sonar.sensing.TransducerPoses;

/** A sensor that is bound anew whenever the world's static objects have changed. */
final class WorldSensor implements Sensor {
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
