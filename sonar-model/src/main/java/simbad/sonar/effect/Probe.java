package simbad.sonar.effect;

import java.util.ArrayList;
import java.util.List;

/**
 * One parameter of a form of an effect, by which the effect is made larger until it shows.
 *
 * <p>Its size is the parameter's departure from neutral, either way; where neutral is infinite, as
 * for a time-out, it is the value itself, and the effect is the larger the smaller that is.
 *
 * @param form of the effect
 * @param index of the parameter
 * @param practical size from which on the effect matters in practice, over 0
 * @param others values that the form's other parameters take in turn; that at the index is ignored
 */
public record Probe(Form form, int index, double practical, List<double[]> others) {
  /** Copies the list. */
  public Probe {
    others = List.copyOf(others);
    if (!(index >= 0 && index < form.parameters().size())) {
      throw new IllegalArgumentException(form + " has no parameter " + index);
    }
    if (!(practical > 0)) {
      throw new IllegalArgumentException(form + ": a size of " + practical + " is none");
    }
  }

  /** Returns one whose other parameters stay neutral. */
  public static Probe alone(Form form, int index, double practical) {
    return new Probe(form, index, practical, List.of(form.neutral()));
  }

  /** Returns one whose other parameters take all combinations of their tries. */
  public static Probe tried(Form form, int index, double practical) {
    List<double[]> all = List.of(form.neutral());
    for (int i = 0; i < form.parameters().size(); i++) {
      if (i != index) {
        all = combined(all, i, form.parameters().get(i).tries());
      }
    }
    return new Probe(form, index, practical, all);
  }

  /** Returns that of a form's first parameter, from the smallest of its tries on. */
  static Probe ofTries(Form form) {
    Parameter first = form.parameters().get(0);
    boolean growing = Double.isFinite(first.neutral());
    double smallest =
        first.tries().stream()
            .mapToDouble(value -> growing ? Math.abs(value - first.neutral()) : value)
            .filter(size -> size > 0)
            .min()
            .orElse(first.high() - first.low());
    return tried(form, 0, smallest);
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

  /** Returns the parameter. */
  public Parameter parameter() {
    return form.parameters().get(index);
  }
}
