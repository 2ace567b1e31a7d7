package simbad.sonar.level;

/**
 * What a ranger is taken for that does not say: a 40 kHz ranger of the SRF04's kind before upright
 * posts. Sources and derivations: docs/method/level-model.md.
 */
public final class LevelDefaults {
  /** Devantech's and Elecfreaks' sheets: 40 kHz. */
  public static final double FREQUENCY_HZ = 40_000;

  /** The same sheets: bursts of 8 cycles at 40 kHz. */
  public static final double PULSE_LENGTH_S = 0.0002;

  /** An upright post: a sphere's spreading on the way out, a cylinder's on the way back. */
  public static final double SPREADING_EXPONENT = 1.5;

  /** Of the SRF04 of Kranz (2014), as the prediction of tables from cross-sections fitted it. */
  public static final double LEVEL_DB = 33.75;

  /** Assumed: logs of calibrated physical models have 0.2 to 0.5 dB. */
  public static final double EXCESS_SD_DB = 0.5;

  /**
   * 20 log10(1 + 24 exp(-t / 1.75 ms)), t the time of flight at 20 degrees: how deaf the SRF04 of
   * Kranz (2014) still is, fitted with the level.
   */
  public static final Curve RECEIVER_THRESHOLD_DB = recovering(24, 0.00175, 343.2);

  /**
   * The envelope of a burst of 8 cycles rises over 8 cycles: an echo crosses a share of 10^(-excess
   * / 20) of the burst late.
   */
  public static final Curve WALK_M = risingBurst(8, 0.00429);

  /** From 0 to 3 m, by which all is recovered. */
  private static final int STEPS = 60;

  private static final double STEPS_PER_M = 20;
  private static final double ROUNDING_DB = 100;
  private static final double ROUNDING_M = 1e5;

  private LevelDefaults() {}

  private static Curve recovering(double multiple, double recoveryS, double speedMPerS) {
    double[] points = new double[2 * STEPS + 2];
    for (int i = 0; i <= STEPS; i++) {
      double distanceM = i / STEPS_PER_M;
      double raised = 1 + multiple * Math.exp(-2 * distanceM / (speedMPerS * recoveryS));
      points[2 * i] = distanceM;
      points[2 * i + 1] = Math.rint(20 * Math.log10(raised) * ROUNDING_DB) / ROUNDING_DB;
    }
    return Curve.of(points);
  }

  private static Curve risingBurst(int cycles, double cycleM) {
    int step = 3;
    int steps = 12;
    double[] points = new double[2 * steps + 2];
    for (int i = 0; i <= steps; i++) {
      double late = cycles * cycleM * Math.pow(10, -i * step / 20.0);
      points[2 * i] = i * step;
      points[2 * i + 1] = Math.rint(late * ROUNDING_M) / ROUNDING_M;
    }
    return Curve.of(points);
  }
}
