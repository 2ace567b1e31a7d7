package simbad.sonar.change;

import simbad.sonar.check.Checks;
import simbad.sonar.ping.Geometry;
import simbad.sonar.ping.RangeChange;

/**
 * The sensor computes with one speed of sound, while the real one follows the air's temperature,
 * which the log knows ping by ping: 331.3 m/s at 0 degrees Celsius, in proportion to the root of
 * the absolute temperature (an ideal gas).
 *
 * @param scale range read over true range in air of 20 degrees Celsius; 1 is neutral
 * @param follows how much of the temperature's work is left in the readings: 0 for a sensor that
 *     takes account of it, which is neutral, 1 for one that does not; in [0, 1]
 */
public record AirTemperature(double scale, double follows) implements RangeChange {
  private static final double FREEZING_K = 273.15;
  private static final double USUAL_C = 20;

  /** Checks the figures; NaN is refused. */
  public AirTemperature {
    Checks.positive("scale", scale);
    Checks.share("follows", follows);
  }

  @Override
  public RangeChange at(Geometry geometry, int ping) {
    boolean isKnown =
        ping < geometry.log().size() && geometry.log().temperatureC(ping) > -FREEZING_K;
    return new SoundSpeed(isKnown ? scaleAt(geometry.log().temperatureC(ping)) : scale);
  }

  /**
   * Returns range read over true range.
   *
   * @param temperatureC of the air, degrees Celsius, over -273.15
   */
  public double scaleAt(double temperatureC) {
    double faster = Math.sqrt((FREEZING_K + temperatureC) / (FREEZING_K + USUAL_C));
    return scale / (1 + follows * (faster - 1));
  }

  @Override
  public int order() {
    return 0;
  }

  /** In air of 20 degrees Celsius. */
  @Override
  public double meanM(double rangeM) {
    return rangeM * scale;
  }

  @Override
  public double rangeM(double meanM) {
    return meanM / scale;
  }
}
