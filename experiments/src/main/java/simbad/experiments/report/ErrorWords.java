package simbad.experiments.report;

import java.util.List;

/**
 * What the figures of a drive are called, on the console and on pages alike; in files they have the
 * names of {@link ErrorRecord}'s JSON.
 */
public final class ErrorWords {
  /** Radial, the mean over the bearings: {@code mean_abs_cm}. */
  public static final String MEAN = "mean cm";

  /** Radial, root mean square: {@code rms_cm}. */
  public static final String RMS = "RMS cm";

  /** Radial, the greatest: {@code max_abs_cm}. */
  public static final String MAX = "max cm";

  /** From the edge, in the mean: {@code lateral_mean_cm}. */
  public static final String BESIDE = "beside cm";

  /** Share of the edge that was kept: {@code edge_kept}. */
  public static final String EDGE_KEPT = "edge kept";

  /** Greatest distance from the edge to the trace: {@code edge_to_trace_max_cm}. */
  public static final String FROM_EDGE = "from edge";

  /** Bearings that were never reached: {@code unreached_bearings}. */
  public static final String UNREACHED = "unreached";

  /** Share by which the mean is smaller than the original sensor's. */
  public static final String REDUCTION = "reduction";

  /** What they mean, in lines as wide as a console. */
  public static final List<String> MEANINGS =
      List.of(
          "mean, RMS, max: radial error |r - T| over the bearings; beside: mean distance from",
          "the shadow's edge; edge kept: share of the edge that the trace came within 5 "
              + "cm of;",
          "from edge: greatest distance in cm from the edge to the trace;",
          "reduction: how much smaller the mean is than with the original sensor.");

  private ErrorWords() {}
}
