package simbad.studio.folders;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.List;
import java.util.Map;
import java.util.function.ToDoubleFunction;
import simbad.motion.Command;
import simbad.motion.MotionRun;
import simbad.motion.forecast.Window;

/** Which windows of a drive lie in a slice of its diagnosis: by the axes that slices have there. */
final class WindowSlices {
  /** A change of command counts so long before a window. */
  private static final double RECENT_S = 0.5;

  /** The ends of a slice have six digits in the file. */
  private static final double ROUNDING = 5.1e-6;

  private final List<MotionRun> runs;
  private final Map<String, ToDoubleFunction<Window>> axes =
      Map.of(
          "speed_m_s",
          window -> window.way().alongM() / window.horizonS(),
          "turn_rad_s",
          window -> wrapped(window.way().turnRad()) / window.horizonS(),
          "since_change_s",
          this::sinceChangeS,
          "speed_change_m_s",
          this::speedChangeMPerS,
          "t_s",
          Window::startS,
          "heading_deg",
          window -> Math.toDegrees(wrapped(window.headingRad())),
          "x_m",
          Window::xM,
          "z_m",
          window -> -window.yM());

  WindowSlices(List<MotionRun> runs) {
    this.runs = runs;
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

  private static double wrapped(double rad) {
    return Math.IEEEremainder(rad, 2 * Math.PI);
  }

  /** The last command that acts before a window ends. */
  private int command(Window window) {
    List<Command> commands = runs.get(window.run()).commands();
    int low = 0;
    int high = commands.size() - 1;
    while (low < high) {
      int middle = (low + high + 1) >>> 1;
      if (commands.get(middle).timeS() <= window.endS()) {
        low = middle;
      } else {
        high = middle - 1;
      }
    }
    return low;
  }

  private double sinceChangeS(Window window) {
    List<Command> commands = runs.get(window.run()).commands();
    return window.endS() - commands.get(command(window)).timeS();
  }

  private double speedChangeMPerS(Window window) {
    List<Command> commands = runs.get(window.run()).commands();
    int at = command(window);
    boolean recent = at > 0 && commands.get(at).timeS() > window.startS() - RECENT_S;
    return recent
        ? Math.abs(commands.get(at).speedMPerS()) - Math.abs(commands.get(at - 1).speedMPerS())
        : 0;
  }
}
