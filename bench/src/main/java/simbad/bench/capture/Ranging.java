package simbad.bench.capture;

import java.util.OptionalDouble;

/**
 * Makes distances of times: the one place for the speed of sound and the step of the clock. Numbers
 * of the thesis's mode become times first ({@link simbad.bench.protocol.ThesisLine#echoUs}).
 *
 * @param temperatureC of the air, degrees Celsius, in [-50, 80]
 */
public record Ranging(double temperatureC) {
  /** Taken when nobody says how warm it is. */
  public static final double ASSUMED_C = 20;

  private static final double SPEED_AT_ZERO_M_PER_S = 331.3;
  private static final double ZERO_K = 273.15;
  private static final double SECONDS_PER_US = 1e-6;

  /** Checks the temperature. */
  public Ranging {
    if (!(temperatureC >= -50 && temperatureC <= 80)) {
      throw new IllegalArgumentException("temperatureC = " + temperatureC + " is not in [-50, 80]");
    }
  }

  /** Takes a temperature that may not be known. */
  public static Ranging of(OptionalDouble temperatureC) {
    return new Ranging(temperatureC.orElse(ASSUMED_C));
  }

  /** Returns the speed of sound in dry air, 331.3 sqrt(1 + T / 273.15) m/s. */
  public double soundSpeedMPerS() {
    return SPEED_AT_ZERO_M_PER_S * Math.sqrt(1 + temperatureC / ZERO_K);
  }

  /**
   * Returns the distance to what answered.
   *
   * @param echoUs length of the sensor's pulse in microseconds
   */
  public double rangeM(double echoUs) {
    return echoUs * SECONDS_PER_US * soundSpeedMPerS() / 2;
  }

  /** Returns the step of the ranges, that of the firmware's clock of 1 us, in metres. */
  public double stepM() {
    return rangeM(1);
  }
}
