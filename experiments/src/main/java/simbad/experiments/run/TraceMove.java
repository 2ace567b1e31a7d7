package simbad.experiments.run;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Stream;
import simbad.sonar.check.Checks;
import simbad.sonar.shape.ThresholdTable;

/**
 * How far a diagnosed sensor's trace lies beside what the simulation had without the diagnosis.
 *
 * @param result of the diagnosed sensor
 * @param against what it is compared with: a sensor's trace, or the table
 * @param radii of both
 */
public record TraceMove(RunResult result, String against, Radii radii) {
  /**
   * How far two ways are from the obstacle's axis, in the mean over the bearings that both reached.
   *
   * @param meanM of the diagnosed trace, metres
   * @param againstM of what it is compared with, metres, above 0
   * @param bearings how many were reached by both, at least 1
   */
  public record Radii(double meanM, double againstM, int bearings) {
    /** Checks the distances. */
    public Radii {
      Checks.notNegative("meanM", meanM);
      Checks.notNegative("againstM", againstM);
    }

    static Optional<Radii> of(OptionalDouble[] mine, OptionalDouble[] theirs) {
      double sum = 0;
      double against = 0;
      int bearings = 0;
      for (int k = 0; k < mine.length; k++) {
        if (mine[k].isPresent() && theirs[k].orElse(0) > 0) {
          sum += mine[k].getAsDouble();
          against += theirs[k].getAsDouble();
          bearings++;
        }
      }
      return bearings == 0
          ? Optional.empty()
          : Optional.of(new Radii(sum / bearings, against / bearings, bearings));
    }

    /** Returns how far out the diagnosed trace moves, metres; negative where it is nearer. */
    double moveM() {
      return meanM - againstM;
    }

    /**
     * Returns the ratio of the means. The mean of the ratios could be above 1 where the way is
     * nearer: it counts short radii as much as long ones.
     */
    double ratio() {
      return meanM / againstM;
    }
  }

  /**
   * Compares each diagnosed sensor's trace with that of the shadow sensor round the same obstacle,
   * else with that of the noisy one, else with the table.
   *
   * @param results of a run
   */
  public static List<TraceMove> of(List<RunResult> results) {
    return results.stream()
        .filter(result -> result.sensor().model().isPresent())
        .flatMap(result -> against(result, results).stream())
        .toList();
  }

  private static Optional<TraceMove> against(RunResult result, List<RunResult> results) {
    ThresholdTable table = result.type().thresholds().table();
    return Stream.of(SensorKind.SHADOW, SensorKind.NOISY)
        .flatMap(
            kind ->
                results.stream()
                    .filter(other -> other.type().equals(result.type()))
                    .filter(other -> other.sensor().equals(kind)))
        .findFirst()
        .map(
            other ->
                between(
                    result,
                    "the " + other.sensor().word() + " sensor's trace",
                    TraceCrossings.meanRadiusM(other.trace(), table)))
        .orElseGet(
            () ->
                between(
                    result,
                    "the table",
                    Arrays.stream(table.valuesM())
                        .mapToObj(OptionalDouble::of)
                        .toArray(OptionalDouble[]::new)));
  }

  private static Optional<TraceMove> between(
      RunResult result, String against, OptionalDouble[] before) {
    return Radii.of(
            TraceCrossings.meanRadiusM(result.trace(), result.type().thresholds().table()), before)
        .map(radii -> new TraceMove(result, against, radii));
  }

  /** Returns it in a sentence. */
  public String sentence() {
    return String.format(
        Locale.ROOT,
        "%s, %s: on average the robot drives %.1f cm %s than %s, at %.2f "
            + "times its distance (%d of %d bearings)",
        result.sensor().word(),
        result.type().name(),
        100 * Math.abs(radii.moveM()),
        radii.moveM() < 0 ? "nearer" : "further out",
        against,
        radii.ratio(),
        radii.bearings(),
        result.type().thresholds().table().size());
  }
}
