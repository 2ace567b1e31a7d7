package simbad.experiments.fidelity;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import simbad.experiments.run.EdgeKept;
import simbad.experiments.run.RunResult;

/**
 * Whether a sensor model was faithful to one table.
 *
 * @param checks every limit and what was reached of it; it passes when each is held
 */
public record FidelityVerdict(List<LimitCheck> checks) {
  private static final double CM = 100;
  private static final String NO_BEARING = "crosses no bearing";
  private static final String NO_TRACE = "no trace to measure";

  /** Copies the list. */
  public FidelityVerdict {
    checks = List.copyOf(checks);
  }

  /**
   * Judges a run.
   *
   * @param result map, trace and errors of one model round one obstacle
   * @param limits to reach
   */
  public static FidelityVerdict of(RunResult result, FidelityLimits limits) {
    return new FidelityVerdict(
        List.of(
            round(result),
            agreement(result, limits.leastAgreement()),
            radial(result.errors().meanM(), limits.greatestRadialMeanM()),
            lateral(result, limits.greatestLateralMeanM()),
            unreached(result, limits.mostUnreached()),
            kept(result.errors().edge())));
  }

  private static LimitCheck round(RunResult result) {
    boolean isClosed = result.trace().isClosed();
    return new LimitCheck(
        "the robot completes its round",
        "yes",
        isClosed ? "yes" : "no",
        "the robot did not complete its round",
        isClosed);
  }

  private static LimitCheck agreement(RunResult result, double least) {
    double agreement = result.map().agreement();
    return new LimitCheck(
        String.format(Locale.ROOT, "agrees with the table, of %,d poses", result.map().poses()),
        "at least " + plain(100 * least) + " %",
        text("%.2f %%", 100 * agreement),
        text("agrees at %.2f %% of the poses", 100 * agreement),
        agreement >= least);
  }

  private static LimitCheck radial(OptionalDouble mean, double greatest) {
    return new LimitCheck(
        "mean radial error |r - T|",
        atMost(greatest),
        mean.isPresent() ? centimetres(mean.getAsDouble()) : NO_BEARING,
        radialWords(mean),
        mean.isPresent() && mean.getAsDouble() <= greatest);
  }

  private static LimitCheck lateral(RunResult result, double greatest) {
    boolean isThere = result.hasLateralErrors();
    double mean = result.errors().lateralMeanM();
    return new LimitCheck(
        "mean distance from the edge",
        atMost(greatest),
        isThere ? centimetres(mean) : NO_TRACE,
        lateralWords(result),
        isThere && mean <= greatest);
  }

  private static LimitCheck unreached(RunResult result, int most) {
    int unreached = result.errors().unreachedBearings();
    return new LimitCheck(
        "bearings not reached",
        "at most " + most,
        unreached + " of " + result.errors().radialM().size(),
        unreached + " bearings not reached",
        unreached <= most);
  }

  /** Bearings are crossed beside a lobe that is cut off as well; its edge is not. */
  private static LimitCheck kept(EdgeKept edge) {
    double share = edge.share().orElse(1);
    return new LimitCheck(
        text("edge kept: the trace came within %.0f cm", CM * EdgeKept.NEAR_M),
        "at least " + plain(100 * EdgeKept.LEAST_SHARE) + " %",
        edge.share().isPresent() ? text("%.1f %%", 100 * share) : "there is no edge",
        text("keeps %.1f %% of the edge", 100 * share),
        !edge.isLost());
  }

  private static String radialWords(OptionalDouble mean) {
    return mean.isPresent()
        ? text("mean radial error %.2f cm", CM * mean.getAsDouble())
        : NO_BEARING;
  }

  private static String lateralWords(RunResult result) {
    return result.hasLateralErrors()
        ? text("mean distance from the edge %.2f cm", CM * result.errors().lateralMeanM())
        : NO_TRACE;
  }

  private static String atMost(double metres) {
    return "at most " + plain(CM * metres) + " cm";
  }

  /** Without zeros at its end: 3, not 3.000. */
  private static String plain(double value) {
    BigDecimal rounded = BigDecimal.valueOf(value).round(new MathContext(4));
    return rounded.stripTrailingZeros().toPlainString();
  }

  private static String centimetres(double metres) {
    return text("%.2f cm", CM * metres);
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
    return String.join(
        "; ",
        String.format(
            Locale.ROOT,
            "agrees at %.2f %% of %,d poses",
            100 * result.map().agreement(),
            result.map().poses()),
        radialWords(result.errors().meanM()),
        lateralWords(result),
        result.errors().unreachedBearings() + " bearings not reached");
  }

  /** Returns in words every limit that was missed; empty when the model is faithful. */
  public List<String> failings() {
    return checks.stream().filter(check -> !check.isHeld()).map(LimitCheck::failing).toList();
  }

  /** Tells whether the model is faithful. */
  public boolean passes() {
    return failings().isEmpty();
  }

  /** Returns the verdict in one line. */
  public String sentence() {
    return passes() ? "faithful" : "not faithful: " + String.join("; ", failings());
  }
}
