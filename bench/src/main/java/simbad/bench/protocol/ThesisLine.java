package simbad.bench.protocol;

import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.regex.Pattern;

/** A line of the firmware's thesis mode: a number in steps of 2 cm, or {@code ?}. */
public final class ThesisLine {
  /** Of a step, in metres. */
  public static final double STEP_M = 0.02;

  /** What the thesis's program divided by: twice 59 us/cm. */
  public static final double STEP_US = 118;

  /** From here on the sensor's pulse is its 36 ms of no echo. */
  private static final int NO_ECHO_STEPS = 212;

  private static final Pattern NUMBER = Pattern.compile("\\d{1,3}");

  private ThesisLine() {}

  /**
   * Reads a line.
   *
   * @param line without its line end
   * @return steps of 2 cm; empty for all that is no number of at most three digits
   */
  public static OptionalInt steps(String line) {
    return NUMBER.matcher(line).matches()
        ? OptionalInt.of(Integer.parseInt(line))
        : OptionalInt.empty();
  }

  /**
   * Returns the length of the sensor's pulse that a number stands for.
   *
   * @param steps at least 0
   * @return microseconds, the middle of the step; empty when nothing was heard
   */
  public static OptionalDouble echoUs(int steps) {
    return steps >= NO_ECHO_STEPS
        ? OptionalDouble.empty()
        : OptionalDouble.of((steps + 0.5) * STEP_US);
  }
}
