package simbad.experiments.fidelity;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import simbad.experiments.run.RunResult;

/**
 * Whether a sensor model was faithful to one table.
 *
 * @param failings what it did not reach, in words; empty when it passes
 */
public record FidelityVerdict(List<String> failings) {
  private static final double CM = 100;

  /** Copies the list. */
  public FidelityVerdict {
    failings = List.copyOf(failings);
  }

  /**
   * Judges a run.
   *
   * @param result map, trace and errors of one model round one obstacle
   * @param limits to reach
   */
  public static FidelityVerdict of(RunResult result, FidelityLimits limits) {
    List<String> failings = new ArrayList<>();
    if (!result.trace().isClosed()) {
      failings.add("the robot did not get round");
    }
    double agreement = result.map().agreement();
    if (agreement < limits.leastAgreement()) {
      failings.add(text("agrees at %.2f %% of the poses", 100 * agreement));
    }
    OptionalDouble radial = result.errors().meanM();
    if (radial.isEmpty() || radial.getAsDouble() > limits.greatestRadialMeanM()) {
      failings.add(
          radial.isPresent()
              ? text("radial error %.2f cm in the mean", CM * radial.getAsDouble())
              : "crosses no bearing");
    }
    double lateral = result.errors().lateralMeanM();
    if (!(result.hasLateralErrors() && lateral <= limits.greatestLateralMeanM())) {
      failings.add(text("%.2f cm beside the edge in the mean", CM * lateral));
    }
    int unreached = result.errors().unreachedBearings();
    if (unreached > limits.mostUnreached()) {
      failings.add(unreached + " bearings not reached");
    }
    return new FidelityVerdict(failings);
  }

  private static String text(String format, double value) {
    return String.format(Locale.ROOT, format, value);
  }

  /**
   * Returns a run's errors in one line, whatever the limits.
   *
   * @param result map, trace and errors of one model round one obstacle
   */
  public static String figures(RunResult result) {
    OptionalDouble radial = result.errors().meanM();
    return String.join(
        "; ",
        String.format(
            Locale.ROOT,
            "agrees at %.2f %% of %,d poses",
            100 * result.map().agreement(),
            result.map().poses()),
        radial.isPresent()
            ? text("radial error %.2f cm in the mean", CM * radial.getAsDouble())
            : "crosses no bearing",
        result.hasLateralErrors()
            ? text("%.2f cm beside the edge in the mean", CM * result.errors().lateralMeanM())
            : "no trace to measure",
        result.errors().unreachedBearings() + " bearings not reached");
  }

  /** Tells whether the model is faithful. */
  public boolean passes() {
    return failings.isEmpty();
  }

  /** Returns the verdict in one line. */
  public String sentence() {
    return passes() ? "faithful" : "not faithful: " + String.join("; ", failings);
  }
}
