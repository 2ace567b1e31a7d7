package simbad.sonar.effect;

import simbad.sonar.check.Checks;
import simbad.sonar.scene.SonarSpec;

/**
 * The sensor scatters otherwise than believed: a calibration of the set-up, in absolute figures.
 *
 * @param edgeWidthM softness of the threshold, metres; at least 0
 * @param rangeNoiseM standard deviation of a range, metres; at least 0
 * @param missRate share of echoes that are lost, in [0, 1]
 */
public record SensorScatter(double edgeWidthM, double rangeNoiseM, double missRate)
    implements SensorChange {
  /** Checks the figures; NaN is refused. */
  public SensorScatter {
    Checks.notNegative("edgeWidthM", edgeWidthM);
    Checks.notNegative("rangeNoiseM", rangeNoiseM);
    Checks.share("missRate", missRate);
  }

  @Override
  public boolean changesGeometry() {
    return false;
  }

  @Override
  public SonarSpec apply(SonarSpec believed) {
    return believed.withScatter(rangeNoiseM, missRate, edgeWidthM);
  }
}
