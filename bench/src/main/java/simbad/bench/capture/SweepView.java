package simbad.bench.capture;

import java.time.Duration;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * What a person at the bench wants to see of a sweep.
 *
 * @param plan of the sweep
 * @param state of the sweep
 * @param bearing that is under way
 * @param left time that the rest takes, if it goes on as so far; empty before the first is done
 */
public record SweepView(SweepPlan plan, SweepState state, int bearing, Optional<Duration> left) {
  /** Returns what to do now, in a few lines. */
  public List<String> text() {
    String turn =
        bearing == 0
            ? "Place the obstacle with its mark towards the sensor: bearing 0 degrees."
            : "Turn it clockwise, seen from above, to bearing %s degrees, %s after the one before."
                .formatted(degrees(bearing), degrees(1));
    String progress =
        String.format(
            Locale.ROOT,
            "%d of %d bearings done%s, %d pings",
            state.doneCount(),
            plan.bearings(),
            left.map(time -> ", about " + (time.toMinutes() + 1) + " min left").orElse(""),
            state.pings());
    return List.of(
        progress,
        turn,
        "Threshold at this bearing so far: " + estimate(),
        "Move it away until the echo is lost, then back until it is there again.",
        "At each place type the distance from the sensor to the AXIS OF ROTATION in cm",
        "(not to its surface, as the reading is).",
        "Enter done · u undo · r DEG repeat · p pause · t CELSIUS · q quit, to resume");
  }

  private String degrees(int index) {
    return String.format(Locale.ROOT, "%.4f", plan.bearingDeg(index)).replaceFirst("\\.?0+$", "");
  }

  /** A threshold lies between what is heard and what is lost; one of them alone is none. */
  private String estimate() {
    List<Level> levels = state.levels(bearing);
    List<Level> lost = levels.stream().filter(plan::isLost).toList();
    if (levels.isEmpty()) {
      return "no reading yet";
    } else if (lost.isEmpty()) {
      return "not lost yet";
    } else if (lost.size() == levels.size()) {
      return "not heard yet";
    }
    return ThresholdFit.of(levels, plan).text();
  }
}
