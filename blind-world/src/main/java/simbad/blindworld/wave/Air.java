package simbad.blindworld.wave;

/**
 * Still air.
 *
 * @param temperatureC in degrees Celsius, above -273
 * @param humidityPercent relative, 0 to 100
 * @param pressureKPa of the atmosphere, above 0
 */
public record Air(double temperatureC, double humidityPercent, double pressureKPa) {

  private static final double REFERENCE_KPA = 101.325;
  private static final double REFERENCE_K = 293.15;
  private static final double TRIPLE_POINT_K = 273.16;

  /** Refuses what no air is. */
  public Air {
    if (!(temperatureC > -273 && pressureKPa > 0)) {
      throw new IllegalArgumentException(
          "air: " + temperatureC + " degC, " + pressureKPa + " kPa, expected above -273 and 0");
    }
    if (!(humidityPercent >= 0 && humidityPercent <= 100)) {
      throw new IllegalArgumentException(
          "humidity: " + humidityPercent + " %, expected in [0, 100]");
    }
  }

  /** The same air, warmer by so many kelvin at the same relative humidity. */
  public Air warmer(double byK) {
    return new Air(temperatureC + byK, humidityPercent, pressureKPa);
  }

  /** The same air with another relative humidity. */
  public Air withHumidity(double percent) {
    return new Air(temperatureC, percent, pressureKPa);
  }

  private double kelvin() {
    return temperatureC + 273.15;
  }

  /** The speed of sound in metres per second, 343.2 m/s at 20 degrees (ISO 9613-1:1993, 7.1). */
  public double soundSpeedMPerS() {
    return 343.2 * Math.sqrt(kelvin() / REFERENCE_K);
  }

  /**
   * The absorption of a tone in decibels per metre of its way, by ISO 9613-1:1993, equations 3 to 5
   * and B.2, B.3. The standard's tables end at 10 kHz; this is its formula carried further.
   */
  public double absorptionDbPerM(double frequencyHz) {
    double pressure = pressureKPa / REFERENCE_KPA;
    double warmth = kelvin() / REFERENCE_K;
    double h = moleShare();
    double oxygen = pressure * (24 + 4.04e4 * h * (0.02 + h) / (0.391 + h));
    double nitrogen =
        pressure
            / Math.sqrt(warmth)
            * (9 + 280 * h * StrictMath.exp(-4.17 * (StrictMath.cbrt(1 / warmth) - 1)));
    double square = frequencyHz * frequencyHz;
    double classical = 1.84e-11 / pressure * Math.sqrt(warmth);
    double relaxing =
        0.01275 * StrictMath.exp(-2239.1 / kelvin()) / (oxygen + square / oxygen)
            + 0.1068 * StrictMath.exp(-3352 / kelvin()) / (nitrogen + square / nitrogen);
    return 8.686 * square * (classical + StrictMath.pow(warmth, -2.5) * relaxing);
  }

  /** The molar concentration of water vapour, in per cent. */
  private double moleShare() {
    double exponent = 4.6151 - 6.8346 * StrictMath.pow(TRIPLE_POINT_K / kelvin(), 1.261);
    return humidityPercent * StrictMath.pow(10, exponent) * REFERENCE_KPA / pressureKPa;
  }
}
