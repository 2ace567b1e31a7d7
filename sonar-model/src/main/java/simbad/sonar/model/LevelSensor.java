package simbad.sonar.model;

import java.util.random.RandomGenerator;
import org.jspecify.annotations.Nullable;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.sensing.Readings;
import simbad.sonar.sensing.Sensor;
import simbad.sonar.sensing.TransducerPoses;

/** See {@link DetectionRule#LEVEL} and {@link DetectionRule#LEVEL_NOISY}. Allocates nothing. */
final class LevelSensor implements Sensor {
  /** With so many standard deviations less than the threshold asks nothing is heard: 5e-17. */
  private static final double DEVIATIONS = 8.3;

  private final LevelPlace place;
  private final Crossings crossings;
  private final TransducerPose pose = new TransducerPose();
  private final double resolutionM;
  private final @Nullable RandomGenerator random;

  private LevelSensor(LevelModel model, double leastDb, @Nullable RandomGenerator random) {
    SonarSpec sensor = model.sensor();
    place = new LevelPlace(model, leastDb);
    crossings = new Crossings(model.law(), sensor.missRate());
    resolutionM = sensor.resolutionM();
    this.random = random;
  }

  static LevelSensor certain(LevelModel model) {
    return new LevelSensor(model, 0, null);
  }

  static LevelSensor noisy(LevelModel model, RandomGenerator random) {
    return new LevelSensor(model, -DEVIATIONS * model.law().excessSdDb(), random);
  }

  @Override
  public void ping(TransducerPoses poses, double timeS, Readings readings) {
    for (int i = 0; i < poses.size(); i++) {
      pose.take(poses, i);
      hear();
      double range = random == null ? Math.max(0, crossings.firstM()) : draw(random);
      if (range < Double.POSITIVE_INFINITY) {
        readings.setEcho(i, range);
      } else {
        readings.setNoEcho(i);
      }
    }
  }

  private void hear() {
    place.moveTo(pose.xM, pose.zM);
    crossings.clear();
    for (int i = 0; i < place.size(); i++) {
      double energy = place.energy(i, pose);
      if (energy > 0) {
        crossings.add(place.nearestM(i), energy);
      }
    }
  }

  private double draw(RandomGenerator chance) {
    crossings.settle();
    double draw = chance.nextDouble();
    for (int i = 0; i < crossings.size(); i++) {
      if (draw >= crossings.silence(i)) {
        double deviation = crossings.deviationM(i);
        double noise = deviation > 0 ? deviation * NormalDistribution.draw(chance) : 0;
        double range = crossings.meanM(i) + noise;
        return Math.max(0, ReadingDistribution.roundedDown(range, resolutionM));
      }
    }
    return Double.POSITIVE_INFINITY;
  }
}
