package simbad.gap.audit;

import java.util.Arrays;
import java.util.Optional;
import simbad.sonar.scene.SonarSpec;

/** Numbers that sensors and their libraries give for no echo. */
final class Code {
  /** HC-SR04 and its like end their pulse after this time without an echo (data sheet). */
  private static final double TIME_OUT_S = 0.038;

  private static final double TIME_OUT_SPREAD_S = 0.0005;

  /** Full counts: bytes and words, MaxBotix' 765, round nines. */
  private static final double[] FULL = {255, 765, 999, 1023, 4095, 9999, 32767, 65535};

  /** Metres to centimetres, millimetres, tenths of them. */
  private static final int[] PER_METRE = {1, 10, 100, 1000, 10_000};

  /** As a share of the sensor's reach. */
  static final double NEAR_THE_MOST = 0.9;

  private Code() {}

  /**
   * Returns what a value is known to mean, if anything.
   *
   * @param value metres as they stand in the file
   * @param sensor before the scene
   * @param greatest of all readings, metres
   */
  static Optional<String> meaning(double value, SonarSpec sensor, double greatest) {
    if (value == 0) {
      return Optional.of("nought");
    }
    double step = Math.max(sensor.resolutionM(), 1e-3);
    boolean most = value == greatest && value >= NEAR_THE_MOST * sensor.maxRangeM();
    if (most || Math.abs(value - sensor.maxRangeM()) <= step) {
      return Optional.of("the most that the sensor reads");
    }
    double flightS = 2 * value / sensor.assumedSoundSpeedMPerS();
    if (Math.abs(flightS - TIME_OUT_S) <= TIME_OUT_SPREAD_S) {
      return Optional.of("38 ms of flight, the sensor's time-out");
    }
    return isFull(value) ? Optional.of("a counter's end") : Optional.empty();
  }

  private static boolean isFull(double value) {
    return Arrays.stream(PER_METRE)
        .anyMatch(
            per ->
                Arrays.stream(FULL).anyMatch(full -> Math.abs(value * per - full) <= 1e-6 * full));
  }
}
