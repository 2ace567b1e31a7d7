package simbad.sonar.model;

import java.util.random.RandomGenerator;
import simbad.sonar.frame.Pose;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.Reading;
import simbad.sonar.sensing.Readings;
import simbad.sonar.sensing.Sensor;
import simbad.sonar.sensing.TransducerPoses;

/** See {@link DetectionRule#NOISY}. */
final class NoisySensor implements Sensor {
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
