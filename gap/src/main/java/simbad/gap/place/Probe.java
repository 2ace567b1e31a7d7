package simbad.gap.place;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.stream.Stream;
import simbad.gap.fit.Hypothesis;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Parameter;

/**
 * One parameter of a form of an effect, by which the effect is made larger until it shows.
 *
 * <p>Its size is the parameter's departure from neutral, either way; where neutral is infinite, as
 * for a time-out, it is the value itself, and the effect is the larger the smaller that is.
 *
 * @param form of the effect
 * @param index of the parameter
 * @param practical size from which on the effect matters in practice
 * @param others values that the form's other parameters take in turn; that at the index is ignored
 */
record Probe(Form form, int index, double practical, List<double[]> others) {
  private static final int WIDENINGS = 8;
  private static final int HALVINGS = 6;

  /** Copies the list. */
  Probe {
    others = List.copyOf(others);
  }

  /** The other parameters stay neutral. */
  static Probe alone(Form form, int index, double practical) {
    return new Probe(form, index, practical, List.of(form.neutral()));
  }

  /** The other parameters take all combinations of their tries. */
  static Probe tried(Form form, int index, double practical) {
    List<double[]> all = List.of(form.neutral());
    for (int i = 0; i < form.parameters().size(); i++) {
      if (i != index) {
        all = combined(all, i, form.parameters().get(i).tries());
      }
    }
    return new Probe(form, index, practical, all);
  }

  private static List<double[]> combined(List<double[]> begun, int index, List<Double> tries) {
    List<double[]> more = new ArrayList<>();
    for (double[] values : begun) {
      for (double value : tries) {
        double[] next = values.clone();
        next[index] = value;
        more.add(next);
      }
    }
    return more;
  }

  /** How far the log likelihood falls when a form is put beside the explanation. */
  @FunctionalInterface
  interface Fall {
    /** Returns nats. */
    double nats(Hypothesis added);
  }

  Parameter parameter() {
    return form.parameters().get(index);
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
    return shows(practical, fall, nats);
  }

  /**
   * Finds the least size beyond the practical one that shows: in even ratios until one does, then
   * halving the ratio.
   *
   * @return empty where none within the parameter's bounds does
   */
  OptionalDouble leastSize(Fall fall, double nats) {
    double ratio = Math.pow(most() / practical, 1.0 / WIDENINGS);
    for (int i = 1; i <= WIDENINGS; i++) {
      double size = i == WIDENINGS ? most() : practical * Math.pow(ratio, i);
      if (shows(size, fall, nats)) {
        return OptionalDouble.of(between(practical * Math.pow(ratio, i - 1), size, fall, nats));
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
        .flatMap(value -> others.stream().map(rest -> with(rest, value)));
  }

  private Hypothesis with(double[] rest, double value) {
    double[] values = rest.clone();
    values[index] = value;
    return Hypothesis.NONE.and(form, values);
  }
}
