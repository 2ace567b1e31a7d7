package simbad.gap.calibrate;

import java.util.Arrays;
import java.util.stream.IntStream;
import simbad.gap.fit.Hypothesis;
import simbad.gap.fit.NearestRange;
import simbad.gap.fit.Placements;
import simbad.sonar.catalogue.SetupForms;
import simbad.sonar.effect.Form;
import simbad.sonar.model.NominalModel;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SetupDetails;
import simbad.sonar.scene.SonarSpec;

/**
 * What poses that are known so well add to the scatter of ranges: the deviation of the place, and
 * by how much the nearest point in the cone comes nearer or goes away as the sensor turns by that
 * of the heading. In a drive each pose is off by something else; readings of one placement are off
 * together, which their clumping divides out, and only by their place.
 */
final class PoseScatter {
  private PoseScatter() {}

  /**
   * Returns a set-up with the scatter that it believes in and that of its poses; the bare one where
   * poses are exact.
   */
  static Hypothesis believed(SensingSetup setup, PingLog log) {
    SetupDetails details = setup.details();
    // Where a sensor was put in place its heading is asked for by itself.
    boolean aimed = details.headingSigmaRad() > 0 && !new Placements(log).areRepeated();
    if (details.poseSigmaM() == 0 && !aimed) {
      return Hypothesis.NONE;
    }
    double turned = aimed ? turnedM(setup, log) : 0;
    SonarSpec sensor = setup.sensor();
    Form scatter = SetupForms.find("scatter", setup, log.sensors()).orElseThrow();
    double noise = Math.hypot(sensor.rangeNoiseM(), Math.hypot(details.poseSigmaM(), turned));
    return Hypothesis.NONE.and(scatter, sensor.edgeWidthM(), noise, sensor.missRate());
  }

  /** The mean square, as a length. */
  private static double turnedM(SensingSetup setup, PingLog log) {
    NominalModel model = new NominalModel(setup.sensor(), setup.scene());
    double sigma = setup.details().headingSigmaRad();
    // Where a range changes by more, the audit leaves the row out.
    double most = Math.max(setup.sensor().rangeNoiseM(), setup.sensor().resolutionM());
    double[] squares =
        IntStream.range(0, log.size())
            .filter(log::echo)
            .mapToDouble(
                ping ->
                    NearestRange.turnedM(model, log, ping, sigma) / 2
                        - NearestRange.turnedM(model, log, ping, -sigma) / 2)
            .filter(change -> Math.abs(change) <= most)
            .map(change -> change * change)
            .toArray();
    return Math.sqrt(Arrays.stream(squares).average().orElse(0));
  }
}
