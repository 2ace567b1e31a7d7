package simbad.scattering;

import java.util.List;
import simbad.sonar.check.Checks;
import simbad.sonar.level.Air;

/**
 * A ranger as fitted to known thresholds, with how far off the fit is.
 *
 * @param receiver the three figures that were fitted
 * @param spreadDb within so many decibels to either side the echo levels of {@value
 *     #COVERAGE_PERCENT} % of the known thresholds lie
 */
public record FittedReceiver(Receiver receiver, double spreadDb) {
  /** Share of known thresholds that a band of the spread holds. */
  public static final int COVERAGE_PERCENT = 80;

  /**
   * The SRF04 of Kranz (2014) in a room of 20 degrees and 50 %: fitted to the angle's measured
   * table, the round tube's 2 m and what is said of the square one (docs/method/scattering.md).
   */
  public static final FittedReceiver SRF04 =
      new FittedReceiver(new Receiver(33.75, 24.0, 0.00175), 4.25);

  /**
   * The same without the angle's table, to see how well a table is predicted that the calibration
   * has not seen. Its spread is that of {@link #SRF04}: a few words say nothing of scatter.
   */
  public static final FittedReceiver WITHOUT_ANGLE =
      new FittedReceiver(new Receiver(34.75, 27.5, 0.00175), 4.25);

  private static final double[] LEVEL_DB = {0, 60, 0.25};
  private static final double[] DESENSITISATION_LOG10 = {0.3, 2.7, 0.06};
  private static final double[] RECOVERY_MS = {0.5, 4, 0.25};
  private static final double SPREAD_STEP_DB = 0.25;
  private static final double MOST_SPREAD_DB = 60;

  /** Half of the thesis's step of 2 cm. */
  private static final double ROUNDING_M = 0.01;

  /** Checks the spread. */
  public FittedReceiver {
    Checks.notNegative("spreadDb", spreadDb);
  }

  /**
   * Fits the receiver: least squares of the logarithms of predicted over known thresholds, each
   * obstacle with the same weight, over a fixed grid, so that the same input gives the same
   * figures.
   *
   * @param known at least one obstacle
   * @param air in which they were measured
   * @param limits of the sensor
   */
  public static FittedReceiver fit(List<KnownThresholds> known, Air air, RangeLimits limits) {
    if (known.isEmpty()) {
      throw new IllegalArgumentException("known is empty; a calibration needs an obstacle");
    }
    double best = Double.POSITIVE_INFINITY;
    Receiver receiver = SRF04.receiver();
    for (double recoveryMs : steps(RECOVERY_MS)) {
      for (double exponent : steps(DESENSITISATION_LOG10)) {
        Receiver candidate = new Receiver(0, desensitisation(exponent), recoveryMs / 1000);
        SonarEquation equation = SonarEquation.of(candidate, air, limits);
        for (double levelDb : steps(LEVEL_DB)) {
          double misfit = misfit(known, equation, levelDb);
          if (misfit < best) {
            best = misfit;
            receiver = new Receiver(levelDb, candidate.desensitisation(), candidate.recoveryS());
          }
        }
      }
    }
    return new FittedReceiver(receiver, spread(known, SonarEquation.of(receiver, air, limits)));
  }

  /** To a tenth, so that what is printed is what was fitted. */
  private static double desensitisation(double exponent) {
    return Math.rint(10 * Math.pow(10, exponent)) / 10;
  }

  private static double[] steps(double[] range) {
    double[] steps = new double[(int) Math.round((range[1] - range[0]) / range[2]) + 1];
    for (int i = 0; i < steps.length; i++) {
      steps[i] = range[0] + i * range[2];
    }
    return steps;
  }

  private static double misfit(
      List<KnownThresholds> known, SonarEquation equation, double levelDb) {
    double sum = 0;
    for (KnownThresholds obstacle : known) {
      sum += obstacle.misfit(equation, levelDb);
    }
    return sum;
  }

  private static double spread(List<KnownThresholds> known, SonarEquation equation) {
    int all = known.stream().mapToInt(KnownThresholds::size).sum();
    double spreadDb = 0;
    while (spreadDb < MOST_SPREAD_DB) {
      double tried = spreadDb;
      int within = known.stream().mapToInt(one -> one.within(equation, tried, ROUNDING_M)).sum();
      if (100 * within >= COVERAGE_PERCENT * all) {
        return spreadDb;
      }
      spreadDb += SPREAD_STEP_DB;
    }
    return spreadDb;
  }
}
