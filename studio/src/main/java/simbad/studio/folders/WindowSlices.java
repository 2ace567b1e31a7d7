package simbad.studio.folders;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.List;
import java.util.Map;
import java.util.function.ToDoubleFunction;
import simbad.gap.motion.WindowAxes;
import simbad.motion.MotionRun;
import simbad.motion.forecast.Window;

/** Which windows of a drive lie in a slice of its diagnosis: by the axes that slices have there. */
final class WindowSlices {
  /** The ends of a slice have six digits in the file. */
  private static final double ROUNDING = 5.1e-6;

  private final List<MotionRun> runs;
  private final Map<String, ToDoubleFunction<Window>> axes;

  WindowSlices(List<MotionRun> runs) {
    this.runs = runs;
    axes = new WindowAxes(runs).byName();
  }

  /**
   * Returns the windows of a slice; there are none along an axis that is not known here.
   *
   * @param slice ends by axis, or the name of a run
   * @param closed whether windows at its upper end are in it
   */
  List<Window> of(JsonNode slice, List<Window> windows, boolean closed) {
    return windows.stream()
        .filter(
            window ->
                slice.properties().stream()
                    .allMatch(part -> has(part.getKey(), part.getValue(), window, closed)))
        .toList();
  }

  private boolean has(String axis, JsonNode part, Window window, boolean closed) {
    if (part.isTextual()) {
      return axis.equals("run") && runs.get(window.run()).name().equals(part.textValue());
    }
    ToDoubleFunction<Window> value = axes.get(axis);
    if (value == null) {
      return false;
    }
    double is = value.applyAsDouble(window);
    double low = end(part.path(0), Double.NEGATIVE_INFINITY);
    double high = end(part.path(1), Double.POSITIVE_INFINITY);
    return is >= low - slack(low) && is < high + (closed ? slack(high) : -slack(high));
  }

  private static double slack(double end) {
    return Double.isInfinite(end) ? 0 : ROUNDING * Math.max(1e-6, Math.abs(end));
  }

  private static double end(JsonNode end, double none) {
    return end.isNumber() ? end.doubleValue() : none;
  }
}
