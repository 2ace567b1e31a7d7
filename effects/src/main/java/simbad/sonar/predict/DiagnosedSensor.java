package simbad.sonar.predict;

import java.util.List;
import java.util.random.RandomGenerator;
import simbad.sonar.ping.PoseTrack;
import simbad.sonar.ping.TruePose;
import simbad.sonar.sensing.Readings;
import simbad.sonar.sensing.Sensor;
import simbad.sonar.sensing.TransducerPoses;

/**
 * A sensor that draws its readings from a diagnosed model, each transducer with a memory of its
 * own. A run starts with the first ping.
 */
final class DiagnosedSensor implements Sensor {
  private final ChangedModel model;
  private final List<String> labels;
  private final RandomGenerator random;
  private final TruePose pose = new TruePose();
  private PingModel pings;
  private Transducer[] transducers = {};

  /**
   * Creates a sensor.
   *
   * @param model whose set-up's scene is the world's
   * @param labels of the transducers, in their order; those beyond the last have none
   * @param random source of chance
   */
  DiagnosedSensor(ChangedModel model, List<String> labels, RandomGenerator random) {
    this.model = model;
    this.labels = List.copyOf(labels);
    this.random = random;
    pings = model.pings(model.geometry(labels.size()));
  }

  @Override
  public void ping(TransducerPoses poses, double timeS, Readings readings) {
    if (transducers.length != poses.size()) {
      start(poses.size(), timeS);
    }
    for (int i = 0; i < poses.size(); i++) {
      pose.set(poses.xM(i), poses.zM(i), poses.headingRad(i));
      double range = transducers[i].ping(timeS, pose, random);
      if (range < Double.POSITIVE_INFINITY) {
        readings.setEcho(i, range);
      } else {
        readings.setNoEcho(i);
      }
    }
  }

  private void start(int size, double startS) {
    if (pings.geometry().pings() != size) {
      pings = model.pings(model.geometry(size));
    }
    pings.geometry().restart();
    transducers = new Transducer[size];
    for (int i = 0; i < size; i++) {
      String label = i < labels.size() ? labels.get(i) : "";
      PoseTrack track = new PoseTrack(model.changes(), label, startS);
      transducers[i] = new Transducer(i, model, pings, track, startS);
    }
  }

  @Override
  public void reset() {
    transducers = new Transducer[0];
  }
}
