package simbad.experiments.run;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import simbad.sonar.effect.FittedForm;
import simbad.sonar.predict.FittedModel;

/** What a fitted model holds, in a line. */
final class DiagnosedMeaning {
  /** Of more, such as a table of thresholds, only the number is said. */
  private static final int FEW = 6;

  private DiagnosedMeaning() {}

  static String of(FittedModel model) {
    List<String> forms =
        Stream.concat(model.effects().stream(), model.calibration().stream())
            .map(DiagnosedMeaning::of)
            .toList();
    String sensor = "fitted model of the sensor " + model.setup().sensor().name();
    return sensor + (forms.isEmpty() ? ", nothing changed" : ": " + String.join("; ", forms));
  }

  private static String of(FittedForm fitted) {
    if (fitted.values().size() > FEW) {
      return fitted.form() + " (" + fitted.values().size() + " values)";
    }
    List<String> values = new ArrayList<>();
    for (int i = 0; i < fitted.values().size(); i++) {
      String name = fitted.form().parameters().get(i).name();
      values.add(String.format(Locale.ROOT, "%s %.4g", name, fitted.values().get(i)));
    }
    return fitted.form() + " (" + String.join(", ", values) + ")";
  }
}
