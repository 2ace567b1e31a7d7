package simbad.gap.fit;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import simbad.definition.Effect;
import simbad.definition.Parameter;
import simbad.sonar.check.Checks;
import simbad.sonar.effect.Form;
import simbad.sonar.ping.Change;

/**
 * Forms of effects with values for all their parameters: one explanation of a log.
 *
 * @param forms at most one for each effect; none is the nominal model
 * @param values of all parameters, form after form
 */
@SuppressWarnings("ArrayRecordComponent") // copied in and out; a fit makes millions of them
public record Hypothesis(List<Form> forms, double[] values) {
  /** Nothing is unmodelled. */
  public static final Hypothesis NONE = new Hypothesis(List.of(), new double[0]);

  /** Copies both, checks their sizes and refuses NaN. */
  public Hypothesis {
    forms = List.copyOf(forms);
    values = Checks.numbers("values", values.clone());
    int size = forms.stream().mapToInt(form -> form.parameters().size()).sum();
    if (values.length != size) {
      throw new IllegalArgumentException(forms + " take " + size + " values, not " + values.length);
    }
  }

  /** Returns a copy of the values. */
  @Override
  public double[] values() {
    return values.clone();
  }

  /** Returns the number of parameters. */
  public int size() {
    return values.length;
  }

  /** Returns all parameters, form after form. */
  public List<Parameter> parameters() {
    return forms.stream().flatMap(form -> form.parameters().stream()).toList();
  }

  /** Returns the effects, in the order of the forms. */
  public List<Effect> effects() {
    return forms.stream().map(Form::effect).toList();
  }

  /** Returns whether a form of an effect is among the forms. */
  public boolean has(Effect effect) {
    return forms.stream().anyMatch(form -> form.of().filter(effect::equals).isPresent());
  }

  /** Returns whether a table is among the forms. */
  public boolean hasTable() {
    return forms.stream().anyMatch(Form::isTable);
  }

  /** Returns the same forms with other values. */
  public Hypothesis with(double... newValues) {
    return new Hypothesis(forms, newValues);
  }

  /** Returns this with one form more. */
  public Hypothesis and(Form form, double... formValues) {
    List<Form> more = new ArrayList<>(forms);
    more.add(form);
    double[] all = Arrays.copyOf(values, values.length + formValues.length);
    System.arraycopy(formValues, 0, all, values.length, formValues.length);
    return new Hypothesis(more, all);
  }

  /** Returns this without the forms of an effect. */
  public Hypothesis without(Effect effect) {
    Hypothesis less = NONE;
    for (int i = 0; i < forms.size(); i++) {
      if (forms.get(i).effect() != effect) {
        less = less.and(forms.get(i), valuesOf(i));
      }
    }
    return less;
  }

  /** Returns the values of one form. */
  public double[] valuesOf(int form) {
    int from = 0;
    for (int i = 0; i < form; i++) {
      from += forms.get(i).parameters().size();
    }
    return Arrays.copyOfRange(values, from, from + forms.get(form).parameters().size());
  }

  /** Returns whether a value stands at an end of what was searched. */
  public boolean isAtBound() {
    List<Parameter> parameters = parameters();
    return IntStream.range(0, values.length).anyMatch(i -> parameters.get(i).isAtBound(values[i]));
  }

  /** Returns the changes that the forms make. */
  public List<Change> changes() {
    List<Change> changes = new ArrayList<>();
    for (int i = 0; i < forms.size(); i++) {
      changes.add(forms.get(i).with(valuesOf(i)));
    }
    return changes;
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof Hypothesis that
        && forms.equals(that.forms)
        && Arrays.equals(values, that.values);
  }

  @Override
  public int hashCode() {
    return 31 * forms.hashCode() + Arrays.hashCode(values);
  }

  @Override
  public String toString() {
    return forms.isEmpty()
        ? "none"
        : IntStream.range(0, forms.size())
            .mapToObj(i -> forms.get(i) + Arrays.toString(valuesOf(i)))
            .collect(Collectors.joining(" + "));
  }
}
