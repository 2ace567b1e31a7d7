package simbad.sonar.level;

import java.util.stream.IntStream;

/**
 * Still air at one atmosphere.
 *
 * @param temperatureC degrees Celsius, in [-40, 60]
 * @param humidityPercent relative, in [0, 100]
 */
public record Air(double temperatureC, double humidityPercent) {
  /** A room: what is assumed of a bench that does not say. */
  public static final Air ROOM = new Air(20, 50);

  private static final double COLDEST_C = -40;
  private static final double WARMEST_C = 60;
  private static final double ZERO_C_IN_K = 273.15;
  private static final double REFERENCE_K = 293.15;
  private static final double TRIPLE_POINT_K = 273.16;
  private static final double SPEED_AT_ZERO_C = 331.3;
  private static final double NEPER_IN_DB = 20 / Math.log(10);

  /** Checks both figures. */
  public Air {
    require("temperatureC", temperatureC, COLDEST_C, WARMEST_C);
    require("humidityPercent", humidityPercent, 0, 100);
  }

  private static void require(String name, double value, double least, double most) {
    if (!(value >= least && value <= most)) {
      throw new IllegalArgumentException(
          name + " = " + value + " is not in [" + least + ", " + most + "]");
    }
  }

  /**
   * Returns the air in which sound has a speed; the coldest or warmest that this is for where no
   * air has it.
   *
   * @param soundSpeedMPerS metres per second, positive
   * @param humidityPercent relative, in [0, 100]
   */
  public static Air nearest(double soundSpeedMPerS, double humidityPercent) {
    double ratio = soundSpeedMPerS / SPEED_AT_ZERO_C;
    double temperatureC = ZERO_C_IN_K * (ratio * ratio - 1);
    return new Air(Math.max(COLDEST_C, Math.min(WARMEST_C, temperatureC)), humidityPercent);
  }

  /** Returns the speed of sound in metres per second, 331.3 sqrt(1 + t / 273.15). */
  public double soundSpeedMPerS() {
    return SPEED_AT_ZERO_C * Math.sqrt(1 + temperatureC / ZERO_C_IN_K);
  }

  /**
   * Returns k = 2 pi f / c in radians per metre.
   *
   * @param frequencyHz positive
   */
  public double wavenumberPerM(double frequencyHz) {
    return 2 * Math.PI * frequencyHz / soundSpeedMPerS();
  }

  /**
   * Returns what the air takes from a wave, in decibels per metre of its way: ISO 9613-1:1993,
   * equations (3) to (5) and B.2, B.3 for the water's share. The standard's tables end at 10 kHz;
   * above, this is the formula carried further.
   *
   * @param frequencyHz positive
   */
  public double absorptionDbPerM(double frequencyHz) {
    double kelvin = temperatureC + ZERO_C_IN_K;
    double ratio = kelvin / REFERENCE_K;
    double water = waterPercent(kelvin);
    double oxygenHz = 24 + 4.04e4 * water * (0.02 + water) / (0.391 + water);
    double nitrogenHz =
        Math.pow(ratio, -0.5)
            * (9 + 280 * water * Math.exp(-4.170 * (StrictMath.cbrt(1 / ratio) - 1)));
    double f2 = frequencyHz * frequencyHz;
    double oxygen = 0.01275 * Math.exp(-2239.1 / kelvin) / (oxygenHz + f2 / oxygenHz);
    double nitrogen = 0.1068 * Math.exp(-3352.0 / kelvin) / (nitrogenHz + f2 / nitrogenHz);
    double classical = 1.84e-11 * Math.sqrt(ratio);
    return NEPER_IN_DB * f2 * (classical + Math.pow(ratio, -2.5) * (oxygen + nitrogen));
  }

  /**
   * Returns what air takes at most, at any temperature and humidity that this formula is for: at 40
   * kHz 2.2 dB for each metre, at 60 degrees Celsius and 7 %.
   *
   * @param frequencyHz positive
   * @return decibels per metre of the way
   */
  public static double mostDbPerM(double frequencyHz) {
    return IntStream.rangeClosed(0, 100)
        .mapToDouble(percent -> new Air(WARMEST_C, percent).absorptionDbPerM(frequencyHz))
        .max()
        .orElseThrow();
  }

  /**
   * Returns what air takes at least, of the same: at 40 kHz 0.23 dB for each metre, in dry cold.
   *
   * @param frequencyHz positive
   * @return decibels per metre of the way
   */
  public static double leastDbPerM(double frequencyHz) {
    return new Air(COLDEST_C, 0).absorptionDbPerM(frequencyHz);
  }

  /** Molar concentration of water vapour in percent. */
  private double waterPercent(double kelvin) {
    double exponent = -6.8346 * Math.pow(TRIPLE_POINT_K / kelvin, 1.261) + 4.6151;
    return humidityPercent * Math.pow(10, exponent);
  }
}
