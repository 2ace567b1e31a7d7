package simbad.motion;

import java.util.Arrays;
import java.util.List;
import java.util.function.IntToDoubleFunction;
import java.util.function.ToDoubleFunction;
import simbad.sonar.check.Checks;

/**
 * Which sizes of commands a log has, so that a fit starts where something can show. All are
 * distinct and ascending, 0 left out.
 *
 * @param speeds sizes of commanded speeds, m/s
 * @param turns sizes of commanded rates of turning, rad/s
 * @param rims sizes of the speeds of the wheels' rims, m/s; empty without wheels
 */
@SuppressWarnings("ArrayRecordComponent") // Numbers, never compared.
public record CommandUse(double[] speeds, double[] turns, double[] rims) {
  /** Checks that all are numbers. */
  public CommandUse {
    Checks.numbers("speeds", speeds);
    Checks.numbers("turns", turns);
    Checks.numbers("rims", rims);
  }

  /** Commands that differ by less are the same. */
  private static final double SAME = 1e-6;

  /** A step of twice the greatest command rounds all to 0. */
  private static final double ABOVE = 1.6;

  private static final double BELOW = 0.95;

  /**
   * Looks through commands.
   *
   * @param runs with the commands
   * @param wheelBaseM between the wheels, 0 without wheels
   */
  public static CommandUse of(List<MotionRun> runs, double wheelBaseM) {
    Checks.notNegative("wheelBaseM", wheelBaseM);
    double[] lefts = sizes(runs, c -> c.speedMPerS() - c.turnRadPerS() * wheelBaseM / 2);
    double[] rights = sizes(runs, c -> c.speedMPerS() + c.turnRadPerS() * wheelBaseM / 2);
    double[] both = Arrays.copyOf(lefts, lefts.length + rights.length);
    System.arraycopy(rights, 0, both, lefts.length, rights.length);
    Arrays.sort(both);
    return new CommandUse(
        sizes(runs, Command::speedMPerS),
        sizes(runs, Command::turnRadPerS),
        wheelBaseM > 0 ? distinct(both) : new double[0]);
  }

  private static double[] sizes(List<MotionRun> runs, ToDoubleFunction<Command> of) {
    double[] sizes =
        runs.stream()
            .flatMap(run -> run.commands().stream())
            .mapToDouble(command -> Math.abs(of.applyAsDouble(command)))
            .sorted()
            .toArray();
    return distinct(sizes);
  }

  private static double[] distinct(double[] sorted) {
    double[] kept = new double[sorted.length];
    int n = 0;
    for (double size : sorted) {
      if (size > SAME && (n == 0 || size > kept[n - 1] + SAME)) {
        kept[n++] = size;
      }
    }
    return Arrays.copyOf(kept, n);
  }

  /** Returns up to so many values, each between two neighbours of some sizes, the least below. */
  public static double[] between(double[] sizes, int most) {
    return spread(sizes, most, i -> i == 0 ? sizes[0] / 2 : (sizes[i - 1] + sizes[i]) / 2);
  }

  /** Returns up to so many of some sizes, and one a little below the greatest in its place. */
  public static double[] among(double[] sizes, int most) {
    if (sizes.length == 0) {
      return sizes;
    }
    double[] below = Arrays.copyOf(sizes, sizes.length - 1);
    double[] chosen = spread(below, most, i -> below[i]);
    double[] all = Arrays.copyOf(chosen, chosen.length + 1);
    all[chosen.length] = BELOW * sizes[sizes.length - 1];
    return all;
  }

  private static double[] spread(double[] sizes, int most, IntToDoubleFunction at) {
    int n = Math.min(most, sizes.length);
    double[] chosen = new double[n];
    for (int i = 0; i < n; i++) {
      chosen[i] = at.applyAsDouble((int) ((2L * i + 1) * sizes.length / (2L * n)));
    }
    return chosen;
  }

  /**
   * Returns values that fall by a factor from somewhat above the greatest of some sizes.
   *
   * @param sizes none gives none
   * @param factor from one to the next, in (0, 1)
   * @param count how many
   */
  public static double[] falling(double[] sizes, double factor, int count) {
    double[] values = new double[sizes.length == 0 ? 0 : count];
    for (int i = 0; i < values.length; i++) {
      values[i] = ABOVE * sizes[sizes.length - 1] * Math.pow(factor, i);
    }
    return values;
  }
}
