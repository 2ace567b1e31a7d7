package simbad.bench.capture;

import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import simbad.bench.protocol.FirmwareMode;
import simbad.bench.protocol.ThesisLine;
import simbad.sonar.check.Checks;

/**
 * Makes distances of times: the one place for the speed of sound and the step of the clock. Numbers
 * of the thesis's mode become times first, by the constant of 59 us/cm that its program divided by
 * ({@link simbad.bench.protocol.ThesisLine}).
 *
 * @param temperatureC of the air, degrees Celsius, in [-50, 80]
 * @param mode in which the times were reported
 */
public record Ranging(double temperatureC, FirmwareMode mode) {
  /** Taken when nobody says how warm it is. */
  public static final double ASSUMED_C = 20;

  static final double COLDEST_C = -50;
  static final double WARMEST_C = 80;

  private static final double SPEED_AT_ZERO_M_PER_S = 331.3;
  private static final double ZERO_K = 273.15;
  private static final double SECONDS_PER_US = 1e-6;

  /** Checks the temperature. */
  public Ranging {
    Checks.within("temperatureC", temperatureC, COLDEST_C, WARMEST_C);
  }

  /** Takes a temperature that may not be known. */
  public static Ranging of(OptionalDouble temperatureC, FirmwareMode mode) {
    return new Ranging(temperatureC.orElse(ASSUMED_C), mode);
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

  /** Returns the step of the ranges, that of the times that the firmware reports, in metres. */
  public double stepM() {
    return rangeM(mode.stepUs());
  }

  /**
   * Puts into a table's header how times became distances.
   *
   * @param header of the table
   * @param known whether the temperature was measured
   */
  void describe(Map<String, String> header, boolean known) {
    header.put(
        "temperature",
        String.format(
            Locale.ROOT,
            "%.1f degrees C%s: sound at %.1f m/s",
            temperatureC,
            known ? "" : " (assumed)",
            soundSpeedMPerS()));
    header.put(
        "clock",
        mode == FirmwareMode.FRAME
            ? String.format(Locale.ROOT, "1 us: %.2f mm", 1000 * stepM())
            : ThesisLine.STEP_US + " us a step, taken in its middle");
  }
}
