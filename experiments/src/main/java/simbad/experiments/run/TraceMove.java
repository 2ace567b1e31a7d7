package simbad.experiments.run;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Stream;
import simbad.sonar.shape.ThresholdTable;

/**
 * How far a diagnosed sensor's trace lies beside what the simulation had without the diagnosis.
 *
 * @param result of the diagnosed sensor
 * @param against what it is compared with: a sensor's trace, or the table
 * @param meanM mean of the radii's difference over the bearings that both reached, metres; negative
 *     where the diagnosed trace is nearer
 * @param ratio mean of the radii's ratio over these bearings
 * @param bearings how many these are, at least 1
 */
public record TraceMove(
    RunResult result, String against, double meanM, double ratio, int bearings) {

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
                    Crossings.meanRadiusM(other.trace(), table)))
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
    OptionalDouble[] after =
        Crossings.meanRadiusM(result.trace(), result.type().thresholds().table());
    double sum = 0;
    double ratios = 0;
    int bearings = 0;
    for (int k = 0; k < after.length; k++) {
      if (after[k].isPresent() && before[k].orElse(0) > 0) {
        sum += after[k].getAsDouble() - before[k].getAsDouble();
        ratios += after[k].getAsDouble() / before[k].getAsDouble();
        bearings++;
      }
    }
    return bearings == 0
        ? Optional.empty()
        : Optional.of(new TraceMove(result, against, sum / bearings, ratios / bearings, bearings));
  }

  /** Returns it in a sentence. */
  public String sentence() {
    return String.format(
        Locale.ROOT,
        "%s, %s: the robot's way lies %.1f cm %s than %s on average, at %.2f of its distance"
            + " (%d of %d bearings)",
        result.sensor().word(),
        result.type().name(),
        100 * Math.abs(meanM),
        meanM < 0 ? "nearer" : "further out",
        against,
        ratio,
        bearings,
        result.type().thresholds().table().size());
  }
}
