package simbad.gap.slice;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.IntToDoubleFunction;
import java.util.function.IntUnaryOperator;
import java.util.stream.IntStream;
import simbad.gap.diagnosis.Interval;
import simbad.gap.diagnosis.Place;
import simbad.sonar.check.Checks;

/**
 * A variable by which pings are told apart, cut into bins: of a number, bins of a round width of
 * which any that adjoin make an interval, or bins of as many pings each; of a name, one for each
 * name.
 */
public final class Axis {
  private static final int MOST_BINS = 40;
  private static final double[] ROUND = {1, 2, 2.5, 5, 10};

  private final String variable;
  private final int[] bin;
  private final int count;
  private final double startAt;
  private final double width;
  private final List<String> names;

  private Axis(String variable, int[] bin, double startAt, double width, List<String> names) {
    this.variable = variable;
    this.bin = bin;
    this.startAt = startAt;
    this.width = width;
    this.names = names;
    count = names.isEmpty() ? Arrays.stream(bin).max().orElse(-1) + 1 : names.size();
  }

  /**
   * Cuts by a name.
   *
   * @param variable what it is called
   * @param pings in the log
   * @param names one for each bin
   * @param of the bin of a ping; negative where it belongs to none
   */
  public static Axis named(String variable, int pings, List<String> names, IntUnaryOperator of) {
    int[] bin = IntStream.range(0, pings).map(of).toArray();
    return new Axis(variable, bin, 0, 1, List.copyOf(names));
  }

  /**
   * Cuts by a bin's number.
   *
   * @param variable what it is called
   * @param pings in the log
   * @param bins how many there are
   * @param of the bin of a ping; negative where it belongs to none
   */
  public static Axis binned(String variable, int pings, int bins, IntUnaryOperator of) {
    return named(variable, pings, numbers(bins), of);
  }

  private static List<String> numbers(int count) {
    return IntStream.range(0, count).mapToObj(Integer::toString).toList();
  }

  /**
   * Cuts by a number into bins of as many pings each.
   *
   * @param variable what it is called
   * @param pings in the log
   * @param bins how many there are, positive
   * @param of the number of a ping; where it is not finite, the ping belongs to no bin
   */
  public static Axis quantiles(String variable, int pings, int bins, IntToDoubleFunction of) {
    double[] values = IntStream.range(0, pings).mapToDouble(of).toArray();
    double[] sorted = Arrays.stream(values).filter(Double::isFinite).sorted().toArray();
    double[] border = new double[bins - 1];
    for (int i = 0; i < border.length && sorted.length > 0; i++) {
      border[i] = sorted[(int) ((long) (i + 1) * sorted.length / bins)];
    }
    return binned(
        variable, pings, bins, i -> Double.isFinite(values[i]) ? below(border, values[i]) : -1);
  }

  /** How many borders a value is not below. */
  private static int below(double[] border, double value) {
    int at = 0;
    while (at < border.length && value >= border[at]) {
      at++;
    }
    return at;
  }

  /** Returns the axis of all pairs of bins of this and another of the same log. */
  public Axis times(Axis other) {
    return binned(
        variable + " x " + other.variable,
        bin.length,
        count * other.count,
        i -> bin[i] < 0 || other.bin[i] < 0 ? -1 : bin[i] * other.count + other.bin[i]);
  }

  /**
   * Cuts by a finite number, into at most some 40 bins between its extremes; into one where it is
   * the same everywhere.
   *
   * @param variable what it is called
   * @param pings in the log
   * @param of the number of a ping
   * @param least width of a bin, positive: numbers that differ by less are the same
   */
  public static Axis numbered(String variable, int pings, IntToDoubleFunction of, double least) {
    Checks.positive("least width", least);
    double[] value = IntStream.range(0, pings).mapToDouble(of).toArray();
    double low = Arrays.stream(value).min().orElse(0);
    double high = Arrays.stream(value).max().orElse(0);
    if (high - low < least) {
      // One bin, whatever the border of a round width lies between.
      return cut(
          variable, value, high < Math.floor(low) + 1 ? Math.floor(low) : low, Math.max(1, least));
    }
    double width = roundUp(Math.max(least, (high - low) / MOST_BINS));
    return cut(variable, value, Math.floor(low / width) * width, width);
  }

  /**
   * Cuts by a number in [0, end).
   *
   * @param variable what it is called
   * @param pings in the log
   * @param width of a bin, positive
   * @param of the number of a ping
   */
  public static Axis numbered(String variable, int pings, double width, IntToDoubleFunction of) {
    Checks.positive("width", width);
    return cut(variable, IntStream.range(0, pings).mapToDouble(of).toArray(), 0, width);
  }

  private static Axis cut(String variable, double[] value, double startAt, double width) {
    int[] bin = new int[value.length];
    for (int i = 0; i < bin.length; i++) {
      bin[i] = (int) Math.floor((value[i] - startAt) / width);
    }
    return new Axis(variable, bin, startAt, width, List.of());
  }

  /** The least round number that is not below. */
  private static double roundUp(double least) {
    double decade = Math.pow(10, Math.floor(Math.log10(least)));
    return Arrays.stream(ROUND)
        .map(factor -> factor * decade)
        .filter(width -> width >= least)
        .findFirst()
        .orElse(10 * decade);
  }

  /** Returns what the variable is called. */
  public String variable() {
    return variable;
  }

  /** Returns the bin of a ping; negative where it belongs to none. */
  public int bin(int ping) {
    return bin[ping];
  }

  /** Returns the number of bins. */
  public int count() {
    return count;
  }

  /** Returns whether bins that adjoin make an interval. */
  public boolean ordered() {
    return names.isEmpty();
  }

  /** Says of the bins [from, to) what pings in them have in common. */
  public Place.Condition condition(int from, int to) {
    return ordered()
        ? new Place.Condition(
            variable, Optional.of(new Interval(border(from), border(to))), Optional.empty())
        : new Place.Condition(variable, Optional.empty(), Optional.of(names.get(from)));
  }

  /** Without the last digits that binary fractions leave. */
  private double border(int at) {
    return Math.rint((startAt + at * width) * 1e6) / 1e6;
  }
}
