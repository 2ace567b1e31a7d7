package simbad.bench.protocol;

import java.util.Optional;
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

  /** As the firmware has it: from nearer than 3 cm, and the time is that of the blanking. */
  private static final double NEAREST_US = 177;

  /** What the firmware says where the thesis's program would have repeated an old number. */
  private static final String STUCK = "?";

  private static final int LONG_AGO_MS = 65535;

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
   * Reads a line as a ping. The mode tells neither number nor spacing.
   *
   * @param line without its line end
   * @param sequence number that the ping shall have
   * @return empty for all that is neither a number of at most three digits nor a question mark
   */
  public static Optional<FrameLine.Ping> ping(String line, int sequence) {
    if (line.equals(STUCK)) {
      return Optional.of(
          new FrameLine.Ping(sequence, PingStatus.STUCK, OptionalInt.empty(), LONG_AGO_MS));
    }
    OptionalInt steps = steps(line);
    if (steps.isEmpty()) {
      return Optional.empty();
    }
    double us = middleUs(steps.getAsInt());
    PingStatus heard = us < NEAREST_US ? PingStatus.TOO_NEAR : PingStatus.ECHO;
    return Optional.of(
        new FrameLine.Ping(
            sequence,
            steps.getAsInt() >= NO_ECHO_STEPS ? PingStatus.NO_ECHO : heard,
            OptionalInt.of((int) us),
            LONG_AGO_MS));
  }

  private static double middleUs(int steps) {
    return (steps + 0.5) * STEP_US;
  }

  /**
   * Returns the length of the sensor's pulse that a number stands for.
   *
   * @param steps at least 0
   * @return microseconds, the middle of the step; empty when nothing was heard
   */
  public static OptionalDouble echoUs(int steps) {
    return steps >= NO_ECHO_STEPS ? OptionalDouble.empty() : OptionalDouble.of(middleUs(steps));
  }
}
