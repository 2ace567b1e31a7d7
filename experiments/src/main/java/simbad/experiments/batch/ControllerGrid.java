package simbad.experiments.batch;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import simbad.experiments.control.ControllerMaker;
import simbad.experiments.control.ControllerParameter;
import simbad.experiments.control.Controllers;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.JsonInput;

/** Reads controllers of a spec: a kind's name, and for each of its parameters a value or a list. */
final class ControllerGrid {
  private static final String NAME = "name";
  private static final String PARAMETERS = "parameters";

  private ControllerGrid() {}

  /** All combinations of one item's values. */
  static BatchChoices<ControllerSetting> read(JsonInput item) throws DataFormatException {
    SpecFields.allowOnly(item, NAME, PARAMETERS);
    ControllerMaker maker = maker(item);
    List<List<Double>> values = new ArrayList<>();
    if (item.has(PARAMETERS)) {
      checkNames(item.field(PARAMETERS), maker);
    }
    for (ControllerParameter parameter : maker.parameters()) {
      values.add(values(item, parameter));
    }
    return combinations(maker, values);
  }

  /** The kind that an item names. */
  static ControllerMaker maker(JsonInput item) throws DataFormatException {
    JsonInput name = item.field(NAME);
    String known =
        Controllers.all().stream().map(ControllerMaker::name).collect(Collectors.joining(", "));
    return Controllers.find(name.text())
        .orElseThrow(() -> name.isNot("the name of a controller: " + known));
  }

  private static void checkNames(JsonInput parameters, ControllerMaker maker)
      throws DataFormatException {
    SpecFields.allowOnly(
        parameters,
        maker.parameters().stream().map(ControllerParameter::name).toArray(String[]::new));
  }

  private static List<Double> values(JsonInput item, ControllerParameter parameter)
      throws DataFormatException {
    if (!item.has(PARAMETERS) || !item.field(PARAMETERS).has(parameter.name())) {
      return List.of(parameter.standard());
    }
    JsonInput value = item.field(PARAMETERS).field(parameter.name());
    return SpecFields.numbers(
        value,
        parameter::permits,
        "a number in [" + parameter.low() + ", " + parameter.high() + "]");
  }

  private static BatchChoices<ControllerSetting> combinations(
      ControllerMaker maker, List<List<Double>> values) {
    MixedRadix radix = new MixedRadix(values.stream().map(list -> (long) list.size()).toList());
    return new BatchChoices<>(
        radix.product().longValueExact(),
        number -> {
          long[] digits = radix.digits(number);
          Map<String, Double> setting = new LinkedHashMap<>();
          for (int i = 0; i < digits.length; i++) {
            double value = values.get(i).get(Math.toIntExact(digits[i]));
            setting.put(maker.parameters().get(i).name(), value);
          }
          return new ControllerSetting(maker, setting);
        });
  }
}
