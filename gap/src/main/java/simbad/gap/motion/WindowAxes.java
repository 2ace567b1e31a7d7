package simbad.gap.motion;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.ToDoubleFunction;
import simbad.motion.Command;
import simbad.motion.MotionRun;
import simbad.motion.forecast.Window;

/** What a window of a drive is cut by where a diagnosis of motion looks for places of the gap. */
public final class WindowAxes {
  /** A change of command counts so long before a window. */
  private static final double RECENT_S = 0.5;

  private final List<MotionRun> runs;

  /** Of the windows of some runs. */
  public WindowAxes(List<MotionRun> runs) {
    this.runs = List.copyOf(runs);
  }

  /** Returns the value of a window along each axis, by the names of files, in a fixed order. */
  public Map<String, ToDoubleFunction<Window>> byName() {
    Map<String, ToDoubleFunction<Window>> axes = new LinkedHashMap<>();
    axes.put("speed_m_s", window -> window.way().alongM() / window.horizonS());
    axes.put("turn_rad_s", window -> wrapped(window.way().turnRad()) / window.horizonS());
    axes.put("since_change_s", this::sinceChangeS);
    axes.put("speed_change_m_s", this::speedChangeMPerS);
    axes.put("t_s", Window::startS);
    axes.put("heading_deg", window -> Math.toDegrees(wrapped(window.headingRad())));
    axes.put("x_m", Window::xM);
    axes.put("z_m", window -> -window.yM());
    return axes;
  }

  /** Half a turn at most either way: a tracker's heading may jump by a whole one. */
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

  /** From the last change of command to the window's end. */
  private double sinceChangeS(Window window) {
    List<Command> commands = runs.get(window.run()).commands();
    return window.endS() - commands.get(command(window)).timeS();
  }

  /** How the commanded speed's size changed last: below 0 it brakes. */
  private double speedChangeMPerS(Window window) {
    List<Command> commands = runs.get(window.run()).commands();
    int at = command(window);
    boolean recent = at > 0 && commands.get(at).timeS() > window.startS() - RECENT_S;
    return recent
        ? Math.abs(commands.get(at).speedMPerS()) - Math.abs(commands.get(at - 1).speedMPerS())
        : 0;
  }
}
