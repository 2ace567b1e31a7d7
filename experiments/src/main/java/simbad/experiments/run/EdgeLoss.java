package simbad.experiments.run;

import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;

/**
 * A drive that did not keep the shadow's edge, which errors along the drive alone do not show.
 *
 * @param result of the drive; part of the edge was kept, but too little
 */
public record EdgeLoss(RunResult result) {
  /** The longest pieces say where to look. */
  private static final int MOST_PIECES = 3;

  /**
   * Finds the drives that lost a part of the edge. The original sensor hears the same all round and
   * follows no edge of a table, so its drives are left out.
   *
   * @param results of a run
   */
  public static List<EdgeLoss> of(List<RunResult> results) {
    return results.stream()
        .filter(result -> !result.sensor().equals(SensorKind.ORIGINAL))
        .filter(result -> result.errors().edge().isLost())
        .map(EdgeLoss::new)
        .toList();
  }

  /** Says how much of the edge was kept, and which parts were not. */
  public String sentence() {
    EdgeKept edge = result.errors().edge();
    if (edge.share().orElse(0) == 0) {
      return String.format(
          Locale.ROOT,
          "%s, %s: the robot never came within %.0f cm of the edge after it had lost the first echo.",
          result.type().name(),
          result.sensor().word(),
          100 * EdgeKept.NEAR_M);
    }
    String pieces =
        edge.skipped().stream()
            .sorted(Comparator.comparingDouble(Arc::lengthM).reversed())
            .limit(MOST_PIECES)
            .map(EdgeLoss::words)
            .collect(Collectors.joining(", "));
    int more = Math.max(0, edge.skipped().size() - MOST_PIECES);
    return String.format(
        Locale.ROOT,
        "%s, %s: the robot did not keep the edge; it came within %.0f cm of %.1f %% of it, and missed"
            + " the part at bearing %s%s",
        result.type().name(),
        result.sensor().word(),
        100 * EdgeKept.NEAR_M,
        100 * edge.share().orElse(0),
        pieces,
        more == 0 ? "." : " and " + more + " shorter ones.");
  }

  private static String words(Arc arc) {
    return String.format(
        Locale.ROOT,
        "%.0f to %.0f degrees (%.0f cm long)",
        Math.toDegrees(arc.fromRad()),
        Math.toDegrees(arc.toRad()),
        100 * arc.lengthM());
  }
}
