package simbad.gap.locate;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.IntToDoubleFunction;
import java.util.function.IntUnaryOperator;
import java.util.stream.IntStream;
import simbad.gap.diagnosis.Interval;
import simbad.gap.diagnosis.Place;

/**
 * A variable by which pings are told apart, cut into bins: of a number, bins of a round width of
 * which any that adjoin make an interval; of a name, one for each name.
 */
final class Axis {
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

  /** Cuts by a name. */
  static Axis named(String variable, int pings, List<String> names, IntUnaryOperator of) {
    int[] bin = IntStream.range(0, pings).map(of).toArray();
    return new Axis(variable, bin, 0, 1, List.copyOf(names));
  }

  /** Cuts by a finite number, into at most some 40 bins between its extremes. */
  static Axis numbered(String variable, int pings, IntToDoubleFunction of) {
    double[] value = IntStream.range(0, pings).mapToDouble(of).toArray();
    double low = Arrays.stream(value).min().orElse(0);
    double high = Arrays.stream(value).max().orElse(0);
    double width = roundUp((high - low) / MOST_BINS);
    return cut(variable, value, Math.floor(low / width) * width, width);
  }

  /** Cuts by a number in [0, end). */
  static Axis numbered(String variable, int pings, double width, IntToDoubleFunction of) {
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
    if (!(least > 0)) {
      return 1;
    }
    double decade = Math.pow(10, Math.floor(Math.log10(least)));
    return Arrays.stream(ROUND)
        .map(factor -> factor * decade)
        .filter(width -> width >= least)
        .findFirst()
        .orElse(10 * decade);
  }

  /** Returns the bin of a ping. */
  int bin(int ping) {
    return bin[ping];
  }

  /** Returns the number of bins. */
  int count() {
    return count;
  }

  /** Returns whether bins that adjoin make an interval. */
  boolean ordered() {
    return names.isEmpty();
  }

  /** Says of the bins [from, to) what pings in them have in common. */
  Place.Condition condition(int from, int to) {
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
