package simbad.experiments.batch;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import simbad.experiments.run.SensorKind;
import simbad.sonar.effect.FittedForm;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.JsonInput;
import simbad.sonar.predict.FittedModel;
import simbad.sonar.predict.ModelFile;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SonarSpec;

/**
 * A list of effects at work on the nominal model, as in a model's file.
 *
 * <p>What an effect's parameters may be depends on the sensor and the scene, so the list is read
 * anew for each.
 *
 * @param list as it stands in the spec
 */
record EffectList(JsonInput list) {
  private static final List<String> LABELS =
      IntStream.range(0, SensorKind.SONARS).mapToObj(i -> "s" + i).toList();

  /** The nominal model of a sensor's figures before a scene, with the effects. */
  FittedModel model(SonarSpec sonar, BatchScene scene) throws DataFormatException {
    SensingSetup setup = new SensingSetup(sonar, scene.asSensed(), sonar.maxRangeM());
    return ModelFile.parseChanges(list, setup, LABELS);
  }

  boolean isEmpty() throws DataFormatException {
    return list.items().isEmpty();
  }

  /** How a row names a model's effects. */
  static String label(FittedModel model) {
    return model.effects().stream().map(EffectList::label).collect(Collectors.joining(" + "));
  }

  private static String label(FittedForm fitted) {
    List<String> values = new ArrayList<>();
    for (int i = 0; i < fitted.values().size(); i++) {
      String name = fitted.form().parameters().get(i).name();
      values.add(String.format(Locale.ROOT, "%s=%s", name, fitted.values().get(i)));
    }
    return fitted.form() + "(" + String.join(" ", values) + ")";
  }
}
