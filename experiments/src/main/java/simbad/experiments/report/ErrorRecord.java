package simbad.experiments.report;

import com.fasterxml.jackson.annotation.JsonProperty;
import java.util.OptionalDouble;
import simbad.experiments.run.RunResult;
import simbad.experiments.run.Trace;
import simbad.experiments.run.TraceErrors;
import simbad.sonar.check.Checks;

/**
 * One row of errors.csv and errors.json: centimetres, seconds, fractions; null where there is none.
 */
public record ErrorRecord(
    @JsonProperty("obstacle") String obstacle,
    @JsonProperty("provenance") String provenance,
    @JsonProperty("sensor") String sensor,
    @JsonProperty("mean_abs_cm") OptionalDouble meanAbsCm,
    @JsonProperty("rms_cm") OptionalDouble rmsCm,
    @JsonProperty("max_abs_cm") OptionalDouble maxAbsCm,
    @JsonProperty("median_abs_cm") OptionalDouble medianAbsCm,
    @JsonProperty("lateral_mean_cm") OptionalDouble lateralMeanCm,
    @JsonProperty("lateral_p95_cm") OptionalDouble lateralP95Cm,
    @JsonProperty("lateral_max_cm") OptionalDouble lateralMaxCm,
    @JsonProperty("edge_kept") OptionalDouble edgeKept,
    @JsonProperty("edge_to_trace_mean_cm") OptionalDouble edgeToTraceMeanCm,
    @JsonProperty("edge_to_trace_max_cm") OptionalDouble edgeToTraceMaxCm,
    @JsonProperty("bearings") int bearings,
    @JsonProperty("unreached_bearings") int unreachedBearings,
    @JsonProperty("reduction_vs_original") OptionalDouble reductionVsOriginal,
    @JsonProperty("map_agreement") double mapAgreement,
    @JsonProperty("closed") boolean closed,
    @JsonProperty("steps") int steps,
    @JsonProperty("simulated_s") double simulatedS) {
  /** Checks that all are numbers, where there are any. */
  public ErrorRecord {
    Checks.finite("meanAbsCm", meanAbsCm);
    Checks.finite("rmsCm", rmsCm);
    Checks.finite("maxAbsCm", maxAbsCm);
    Checks.finite("medianAbsCm", medianAbsCm);
    Checks.finite("lateralMeanCm", lateralMeanCm);
    Checks.finite("lateralP95Cm", lateralP95Cm);
    Checks.finite("lateralMaxCm", lateralMaxCm);
    Checks.finite("edgeKept", edgeKept);
    Checks.finite("edgeToTraceMeanCm", edgeToTraceMeanCm);
    Checks.finite("edgeToTraceMaxCm", edgeToTraceMaxCm);
    Checks.finite("reductionVsOriginal", reductionVsOriginal);
    Checks.finite("mapAgreement", mapAgreement);
    Checks.finite("simulatedS", simulatedS);
  }

  private static final double CM = 100;

  /** Returns the errors of a run; lengths in centimetres, as their names say. */
  public static ErrorRecord of(RunResult result) {
    TraceErrors errors = result.errors();
    Trace trace = result.trace();
    boolean onEdge = result.hasLateralErrors();
    return new ErrorRecord(
        result.type().name(),
        result.type().thresholds().provenanceWord(),
        result.sensor().word(),
        centimetres(errors.meanM()),
        centimetres(errors.rmsM()),
        centimetres(errors.maxM()),
        centimetres(errors.medianM()),
        centimetres(onEdge, errors.lateralMeanM()),
        centimetres(onEdge, errors.lateralP95M()),
        centimetres(onEdge, errors.lateralMaxM()),
        rounded(errors.edge().share(), 1e4),
        centimetres(errors.edge().meanM()),
        centimetres(errors.edge().maxM()),
        errors.radialM().size(),
        errors.unreachedBearings(),
        rounded(result.reductionVsOriginal(), 1e4),
        Math.rint(result.map().agreement() * 1e4) / 1e4,
        trace.isClosed(),
        trace.size(),
        trace.size() == 0 ? 0 : Math.rint(trace.timeS(trace.size() - 1) * CM) / CM);
  }

  private static OptionalDouble centimetres(boolean present, double metres) {
    return present ? centimetres(OptionalDouble.of(metres)) : OptionalDouble.empty();
  }

  private static OptionalDouble centimetres(OptionalDouble metres) {
    return metres.isPresent() ? rounded(OptionalDouble.of(metres.getAsDouble() * CM), 1e4) : metres;
  }

  private static OptionalDouble rounded(OptionalDouble value, double perUnit) {
    return value.isPresent()
        ? OptionalDouble.of(Math.rint(value.getAsDouble() * perUnit) / perUnit)
        : value;
  }
}
