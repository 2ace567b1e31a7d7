package simbad.sonar.effect;

import java.util.List;
import simbad.definition.Parameter;
import simbad.sonar.ping.Change;

/**
 * A form with the values that were fitted.
 *
 * @param form the form
 * @param values one for each of its parameters, each in its interval or neutral
 */
public record FittedForm(Form form, List<Double> values) {
  /** Copies and checks the values. */
  public FittedForm {
    values = List.copyOf(values);
    if (values.size() != form.parameters().size()) {
      throw new IllegalArgumentException(
          form + " takes " + form.parameters().size() + " values, not " + values.size());
    }
    for (int i = 0; i < values.size(); i++) {
      Parameter parameter = form.parameters().get(i);
      if (!parameter.permits(values.get(i))) {
        throw new IllegalArgumentException(
            form
                + " "
                + parameter.name()
                + " = "
                + values.get(i)
                + " is not "
                + parameter.domain());
      }
    }
  }

  /** Returns the change that it makes. */
  public Change change() {
    return form.with(values.stream().mapToDouble(Double::doubleValue).toArray());
  }
}
