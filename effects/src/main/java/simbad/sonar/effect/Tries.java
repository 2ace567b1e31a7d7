package simbad.sonar.effect;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import simbad.definition.Parameter;

/** Values to start a fit from: combinations of what each parameter may try. */
public final class Tries {
  private Tries() {}

  /** Returns what each parameter of a form tries, in a list that may be changed. */
  public static List<List<Double>> of(Form form) {
    List<List<Double>> tries = new ArrayList<>();
    form.parameters().forEach(parameter -> tries.add(parameter.tries()));
    return tries;
  }

  /** Returns values, each moved into its parameter's interval. */
  public static double[] within(Form form, double... values) {
    double[] moved = values.clone();
    Arrays.setAll(moved, i -> form.parameters().get(i).clamp(values[i]));
    return moved;
  }

  /** Returns all combinations of a form's own tries. */
  public static List<double[]> all(Form form) {
    return combined(form, of(form));
  }

  /** Returns all combinations of some tries, one list for each parameter. */
  @SafeVarargs
  @SuppressWarnings("varargs")
  public static List<double[]> product(Form form, List<Double>... tries) {
    return combined(form, List.of(tries));
  }

  /**
   * Returns all combinations, each value moved into its parameter's interval. The parameter's own
   * tries stand in for an empty list.
   *
   * @param form whose values they are
   * @param tries one list for each parameter
   */
  public static List<double[]> combined(Form form, List<List<Double>> tries) {
    List<double[]> all = List.of(new double[0]);
    for (int i = 0; i < tries.size(); i++) {
      Parameter parameter = form.parameters().get(i);
      List<Double> values = tries.get(i).isEmpty() ? parameter.tries() : tries.get(i);
      List<double[]> longer = new ArrayList<>();
      for (double[] begun : all) {
        for (double value : values) {
          double[] more = Arrays.copyOf(begun, begun.length + 1);
          more[begun.length] = parameter.clamp(value);
          longer.add(more);
        }
      }
      all = longer;
    }
    return all;
  }
}
