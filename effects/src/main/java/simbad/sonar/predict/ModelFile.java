package simbad.sonar.predict;

import com.fasterxml.jackson.databind.json.JsonMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import simbad.definition.Effect;
import simbad.definition.Parameter;
import simbad.sonar.effect.Definitions;
import simbad.sonar.effect.FittedForm;
import simbad.sonar.effect.Form;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.JsonInput;
import simbad.sonar.format.TextFile;
import simbad.sonar.scene.SensingSetup;

/**
 * Fitted models as JSON files, {@code format} "sonar-model/1": the labels of the {@code sensors},
 * the calibrations of the {@code setup}, which may be left out, and the {@code changes} by effects.
 * Each calibration has a {@code form} and its {@code parameters} by name, each change an {@code
 * effect} too.
 *
 * <p>Numbers stand in full precision: what is read equals what was written to the last bit. Where
 * the neutral value is infinite, it stands as the text "infinity".
 */
public final class ModelFile {
  private static final String FORMAT = "sonar-model/1";
  private static final String INFINITY = "infinity";
  private static final JsonMapper MAPPER = new JsonMapper();

  private final SensingSetup setup;
  private final List<String> sensors = new ArrayList<>();
  private final List<Form> before = new ArrayList<>();

  private ModelFile(SensingSetup setup) {
    this.setup = setup;
  }

  /**
   * Reads a model.
   *
   * @param file JSON
   * @param setup that the model was fitted for, as its scene file states it
   * @throws DataFormatException naming file, line and field of the first fault
   */
  public static FittedModel read(Path file, SensingSetup setup) throws DataFormatException {
    JsonInput root = JsonInput.read(file);
    if (!root.text("format").equals(FORMAT)) {
      throw root.field("format").isNot("\"" + FORMAT + "\"");
    }
    return new ModelFile(setup).model(root);
  }

  /**
   * Reads a list of changes that stands in another file, each as in {@code changes}.
   *
   * @param list of changes
   * @param setup that they change
   * @param sensors labels of the transducers
   * @throws DataFormatException naming file, line and field of the first fault
   */
  public static FittedModel parseChanges(JsonInput list, SensingSetup setup, List<String> sensors)
      throws DataFormatException {
    ModelFile reader = new ModelFile(setup);
    reader.sensors.addAll(sensors);
    return reader.model(list, List.of());
  }

  private FittedModel model(JsonInput root) throws DataFormatException {
    for (JsonInput label : root.items("sensors")) {
      sensors.add(label.text());
    }
    List<FittedForm> calibration = new ArrayList<>();
    if (root.has("setup")) {
      for (JsonInput item : root.items("setup")) {
        calibration.add(fitted(item, Optional.empty()));
      }
    }
    return model(root.field("changes"), calibration);
  }

  private FittedModel model(JsonInput changes, List<FittedForm> calibration)
      throws DataFormatException {
    List<FittedForm> effects = new ArrayList<>();
    for (JsonInput item : changes.items()) {
      effects.add(fitted(item, Optional.of(effect(item.field("effect")))));
    }
    FittedModel model = new FittedModel(setup, sensors, calibration, effects);
    try {
      model.diagnosed();
    } catch (IllegalArgumentException e) {
      throw changes.fault(String.valueOf(e.getMessage()));
    }
    return model;
  }

  private static Effect effect(JsonInput name) throws DataFormatException {
    return Definitions.find(name.text()).orElseThrow(() -> name.isNot("the name of an effect"));
  }

  private FittedForm fitted(JsonInput item, Optional<Effect> effect) throws DataFormatException {
    JsonInput name = item.field("form");
    Form form =
        FittedModel.find(effect, name.text(), setup, sensors)
            .orElseThrow(
                () ->
                    name.isNot(
                        "a form of "
                            + effect.map(Effect::word).orElse("the set-up")
                            + " before this scene and these sensors"));
    if (before.contains(form)) {
      throw name.fault(form + " appears twice");
    }
    before.add(form);
    return new FittedForm(form, values(form, item.field("parameters")));
  }

  private static List<Double> values(Form form, JsonInput parameters) throws DataFormatException {
    List<String> names = form.parameters().stream().map(Parameter::name).toList();
    for (String found : parameters.names()) {
      if (!names.contains(found)) {
        throw parameters
            .field(found)
            .fault("is not a parameter of " + form + ": " + String.join(", ", names));
      }
    }
    List<Double> values = new ArrayList<>();
    for (Parameter parameter : form.parameters()) {
      JsonInput value = parameters.field(parameter.name());
      boolean infinite = parameter.permits(Double.POSITIVE_INFINITY) && value.isText(INFINITY);
      values.add(
          infinite
              ? Double.POSITIVE_INFINITY
              : value.number(parameter::permits, "a number " + parameter.domain()));
    }
    return values;
  }

  /**
   * Writes a model so that {@link #read} gives it back.
   *
   * @param file target; its directory must exist
   * @param model whose set-up goes into a scene file of its own
   * @throws IOException if it cannot be written
   */
  public static void write(Path file, FittedModel model) throws IOException {
    TextFile.write(file, text(model));
  }

  /** Returns a model as the text of a file. */
  public static String text(FittedModel model) {
    ObjectNode root = MAPPER.createObjectNode().put("format", FORMAT);
    model.sensors().forEach(root.putArray("sensors")::add);
    add(root.putArray("setup"), model.calibration());
    add(root.putArray("changes"), model.effects());
    return root.toPrettyString() + "\n";
  }

  private static void add(ArrayNode list, List<FittedForm> forms) {
    for (FittedForm fitted : forms) {
      ObjectNode item = list.addObject();
      fitted.form().of().ifPresent(effect -> item.put("effect", effect.word()));
      item.put("form", fitted.form().name());
      ObjectNode parameters = item.putObject("parameters");
      for (int i = 0; i < fitted.values().size(); i++) {
        String name = fitted.form().parameters().get(i).name();
        double value = fitted.values().get(i);
        if (value == Double.POSITIVE_INFINITY) {
          parameters.put(name, INFINITY);
        } else {
          parameters.put(name, value);
        }
      }
    }
  }
}
