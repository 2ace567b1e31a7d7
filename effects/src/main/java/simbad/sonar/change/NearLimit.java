package simbad.sonar.change;

import simbad.sonar.check.Checks;
import simbad.sonar.ping.OutputChange;
import simbad.sonar.ping.SensorChange;
import simbad.sonar.scene.SonarSpec;

/**
 * Whatever is nearer than a least value is heard and reported as that value, also what the sensor
 * was believed to be blind to.
 *
 * @param leastM metres; 0 is neutral
 */
public record NearLimit(double leastM) implements SensorChange, OutputChange {
  /** Checks the figure; NaN is refused. */
  public NearLimit {
    Checks.notNegative("leastM", leastM);
  }

  /** The cone stays as it is. */
  @Override
  public boolean changesGeometry() {
    return false;
  }

  @Override
  public SonarSpec apply(SonarSpec believed) {
    return leastM > 0 ? believed.withRange(0, believed.maxRangeM()) : believed;
  }

  @Override
  public int order() {
    return 0;
  }

  @Override
  public double reported(double rangeM) {
    return new NearClamp(leastM).reported(rangeM);
  }

  @Override
  public double leastRange(double reportedM) {
    return new NearClamp(leastM).leastRange(reportedM);
  }
}
