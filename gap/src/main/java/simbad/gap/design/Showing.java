package simbad.gap.design;

import java.util.OptionalDouble;
import java.util.stream.Stream;
import simbad.definition.Parameter;
import simbad.gap.fit.Hypothesis;
import simbad.sonar.effect.Probe;

/**
 * Makes an effect larger by its probe until it shows.
 *
 * @param probe by what
 */
record Showing(Probe probe) {
  private static final int WIDENINGS = 8;
  private static final int HALVINGS = 6;

  /** How far the log likelihood falls when a form is put beside the explanation. */
  @FunctionalInterface
  interface Fall {
    /** Returns nats. */
    double nats(Hypothesis added);
  }

  Parameter parameter() {
    return probe.parameter();
  }

  private boolean growing() {
    return Math.abs(parameter().neutral()) < Double.POSITIVE_INFINITY;
  }

  private double most() {
    Parameter main = parameter();
    return growing()
        ? Math.max(main.high() - main.neutral(), main.neutral() - main.low())
        : main.low();
  }

  /** Returns whether the effect shows at its practical size. */
  boolean showsInPractice(Fall fall, double nats) {
    return shows(probe.practical(), fall, nats);
  }

  /**
   * Finds the least size beyond the practical one that shows: in even ratios until one does, then
   * halving the ratio.
   *
   * @return empty where none within the parameter's bounds does
   */
  OptionalDouble leastSize(Fall fall, double nats) {
    double ratio = Math.pow(most() / probe.practical(), 1.0 / WIDENINGS);
    for (int i = 1; i <= WIDENINGS; i++) {
      double size = i == WIDENINGS ? most() : probe.practical() * Math.pow(ratio, i);
      if (shows(size, fall, nats)) {
        return OptionalDouble.of(
            between(probe.practical() * Math.pow(ratio, i - 1), size, fall, nats));
      }
    }
    return OptionalDouble.empty();
  }

  private double between(double hidden, double shown, Fall fall, double nats) {
    double low = hidden;
    double high = shown;
    for (int i = 0; i < HALVINGS; i++) {
      double middle = Math.sqrt(low * high);
      if (shows(middle, fall, nats)) {
        high = middle;
      } else {
        low = middle;
      }
    }
    return high;
  }

  private boolean shows(double size, Fall fall, double nats) {
    return at(size).anyMatch(added -> fall.nats(added) >= nats);
  }

  private Stream<Hypothesis> at(double size) {
    double neutral = parameter().neutral();
    Stream<Double> values = growing() ? Stream.of(neutral + size, neutral - size) : Stream.of(size);
    return values
        .filter(value -> parameter().clamp(value) == value)
        .flatMap(value -> probe.others().stream().map(rest -> with(rest, value)));
  }

  private Hypothesis with(double[] rest, double value) {
    double[] values = rest.clone();
    values[probe.index()] = value;
    return Hypothesis.NONE.and(probe.form(), values);
  }
}
