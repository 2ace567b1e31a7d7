package simbad.gap.calibrate;

import java.util.Arrays;
import java.util.stream.IntStream;
import simbad.gap.fit.Hypothesis;
import simbad.gap.fit.Placements;
import simbad.sonar.catalogue.SetupForms;
import simbad.sonar.effect.Form;
import simbad.sonar.model.NominalModel;
import simbad.sonar.model.TransducerPose;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SetupDetails;
import simbad.sonar.scene.SonarSpec;

/**
 * What poses that are known so well add to the scatter of ranges in a drive, where each pose is off
 * by something else: the deviation of the place, and by how much the nearest point in the cone
 * comes nearer or goes away as the sensor turns by that of the heading.
 */
final class PoseScatter {
  private final SensingSetup setup;
  private final PingLog log;
  private final NominalModel model;
  private final TransducerPose from = new TransducerPose();

  private PoseScatter(SensingSetup setup, PingLog log) {
    this.setup = setup;
    this.log = log;
    model = new NominalModel(setup.sensor(), setup.scene());
  }

  /**
   * Returns a set-up with the scatter that it believes in and that of its poses; the bare one where
   * poses are exact, or things were put in place.
   */
  static Hypothesis believed(SensingSetup setup, PingLog log) {
    SetupDetails details = setup.details();
    boolean exact = details.poseSigmaM() == 0 && details.headingSigmaRad() == 0;
    if (exact || new Placements(log).areRepeated()) {
      return Hypothesis.NONE;
    }
    double turned = new PoseScatter(setup, log).turnedM(details.headingSigmaRad());
    SonarSpec sensor = setup.sensor();
    Form scatter = SetupForms.find("scatter", setup, log.sensors()).orElseThrow();
    double noise = Math.hypot(sensor.rangeNoiseM(), Math.hypot(details.poseSigmaM(), turned));
    return Hypothesis.NONE.and(scatter, sensor.edgeWidthM(), noise, sensor.missRate());
  }

  /** The mean square, as a length. */
  private double turnedM(double sigmaRad) {
    // Where a range changes by more, the audit leaves the row out.
    double most = Math.max(setup.sensor().rangeNoiseM(), setup.sensor().resolutionM());
    double[] squares =
        IntStream.range(0, log.size())
            .filter(log::echo)
            .mapToDouble(ping -> nearestM(ping, sigmaRad) / 2 - nearestM(ping, -sigmaRad) / 2)
            .filter(change -> Math.abs(change) <= most)
            .map(change -> change * change)
            .toArray();
    return Math.sqrt(Arrays.stream(squares).average().orElse(0));
  }

  private double nearestM(int ping, double turnRad) {
    from.aim(log.xM(ping), log.zM(ping), log.headingRad(ping) + turnRad);
    return IntStream.range(0, model.size())
        .mapToDouble(target -> model.nearestM(target, from))
        .min()
        .orElse(Double.POSITIVE_INFINITY);
  }
}
