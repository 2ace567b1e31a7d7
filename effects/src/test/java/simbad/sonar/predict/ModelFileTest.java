package simbad.sonar.predict;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.stream.DoubleStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simbad.definition.Parameter;
import simbad.sonar.catalogue.SetupForms;
import simbad.sonar.change.BeamMisalignment;
import simbad.sonar.change.BearingFactor;
import simbad.sonar.change.EarlyTimeout;
import simbad.sonar.change.Gain;
import simbad.sonar.change.NoiseTails;
import simbad.sonar.effect.FittedForm;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;
import simbad.sonar.fixture.Refusal;
import simbad.sonar.format.Faults;
import simbad.sonar.format.FileDamage;
import simbad.sonar.format.Samples;
import simbad.sonar.format.SceneFile;
import simbad.sonar.ping.Change;
import simbad.sonar.scene.SensingSetup;

class ModelFileTest {
  @TempDir private Path directory = Path.of("target");

  private SensingSetup setup() throws Exception {
    return SceneFile.read(Faults.file(directory, Samples.scene()));
  }

  @Test
  void model_isRead() throws Exception {
    SensingSetup setup = setup();
    FittedModel model = ModelFile.read(Faults.file(directory, Samples.MODEL), setup);
    List<Change> expected =
        List.of(
            new NoiseTails(0.25, 0.04),
            new BearingFactor(
                Optional.of("post"),
                DoubleStream.concat(
                        DoubleStream.of(0.01, 0.02, 0, 0, -0.03), DoubleStream.of(new double[10]))
                    .boxed()
                    .toList()),
            new Gain(0.8),
            new EarlyTimeout(Double.POSITIVE_INFINITY, 0.05),
            new BeamMisalignment(Math.toRadians(5), Optional.of("right")));
    assertEquals(expected, model.changes());
    assertEquals(expected, model.diagnosed().changes());
    assertEquals(expected.subList(0, 2), model.calibrated().changes());
    assertEquals(List.of("left", "right"), model.sensors());
  }

  @Test
  void setup_mayBeLeftOut() throws Exception {
    String text = "{\"format\": \"sonar-model/1\", \"sensors\": [], \"changes\": [], \"more\": 1}";
    SensingSetup setup = setup();
    FittedModel model = ModelFile.read(Faults.file(directory, text), setup);
    assertTrue(model.changes().isEmpty());
    assertTrue(model.calibration().isEmpty());
  }

  /** Every form at values with all their digits, and at its neutral values, infinite ones too. */
  @Test
  void model_writtenAndRead_isEqualToTheBit() throws Exception {
    SensingSetup setup = setup();
    List<String> sensors = List.of("left", "right", "\u00e4 \"1\"");
    Random random = new Random(9);
    for (Form form : Forms.all(setup, sensors)) {
      for (boolean neutral : new boolean[] {false, true}) {
        assertKept(
            new FittedModel(setup, sensors, List.of(), List.of(fitted(form, neutral, random))));
      }
    }
    for (Form form : SetupForms.all(setup)) {
      assertKept(new FittedModel(setup, sensors, List.of(fitted(form, false, random)), List.of()));
    }
  }

  private static FittedForm fitted(Form form, boolean neutral, Random random) {
    List<Double> values = new ArrayList<>();
    for (Parameter parameter : form.parameters()) {
      values.add(
          neutral
              ? parameter.neutral()
              : Double.valueOf(random.nextDouble(parameter.low(), parameter.high())));
    }
    return new FittedForm(form, values);
  }

  private void assertKept(FittedModel model) throws Exception {
    Path file = directory.resolve("model.json");
    ModelFile.write(file, model);
    FittedModel read = ModelFile.read(file, model.setup());
    assertEquals(model, read);
    assertEquals(model.changes(), read.changes());
    assertEquals(ModelFile.text(model), ModelFile.text(read));
  }

  /** A piece of the model, what is put in its place (. for nothing), where the fault is named. */
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "sonar-model/1 | sonar-model/2 | 2: format | \"sonar-model/2\" is not \"sonar-model/1\"",
        "\"sensors\": [\"left\", \"right\"], | . | 1: sensors | is missing",
        "[\"left\", \"right\"] | [\"left\", 5] | 3: sensors.1 | 5 is not a text",
        "\"gain\" | \"gian\" | 11: changes.0.effect | \"gian\" is not the name of an effect",
        "\"gain\" | 5 | 11: changes.0.effect | 5 is not a text",
        "\"effect\": \"gain\", | . | 11: changes.0.effect | is missing",
        "\"form\": \"factor\", | . | 11: changes.0.form | is missing",
        "\"factor\", | \"actor\", | 11: changes.0.form | \"actor\" is not a form of gain",
        "only:right | only:middle | 14: changes.2.form | is not a form of beam-misalignment",
        "\"tails\" | \"heads\" | 5: setup.0.form | \"heads\" is not a form of the set-up",
        "threshold:post | threshold:pole | 6: setup.1.form | is not a form of the set-up",
        "{\"factor\": 0.8} | {} | 11: changes.0.parameters.factor | is missing",
        "{\"factor\": 0.8} | [] | 11: changes.0.parameters | [] is not an object",
        "\"factor\": 0.8 | \"factor\": 8 | 11: changes.0.parameters.factor | 8 is not a number in [",
        "\"factor\": 0.8 | \"factor\": \"infinity\" | 11: changes.0.parameters.factor | is not a number",
        "\"factor\": 0.8 | \"factor\": 0.8, \"f\": 1 | 11: changes.0.parameters.f | is not a parameter of",
        "\"infinity\" | \"infinite\" | 13: changes.1.parameters.start_m | is not a number in",
        "\"share\": 0.25 | \"share\": -1 | 5: setup.0.parameters.share | -1 is not a number in [0.0",
        "\"changes\": [ | \"changes\": 5, \"c\": [ | 10: changes | is not a list",
        "\"setup\": [ | \"setup\": {}, \"c\": [ | 4: setup | {} is not a list"
      })
  void field_spoiled_isNamed(String piece, String instead, String where, String part)
      throws Exception {
    assertTrue(Samples.MODEL.contains(piece), piece);
    int at = Samples.MODEL.indexOf(piece);
    String spoiled =
        Samples.MODEL.substring(0, at)
            + (instead.equals(".") ? "" : instead)
            + Samples.MODEL.substring(at + piece.length());
    checkFault(spoiled, ":" + where + ": ", part);
  }

  private void checkFault(String text, String where, String part) throws Exception {
    SensingSetup setup = setup();
    Path file = Faults.file(directory, text);
    Faults.check(any -> ModelFile.read(any, setup), file, where, part);
  }

  @Test
  void formTwice_isRefused() throws Exception {
    String gain =
        "{\"effect\": \"gain\", \"form\": \"factor\", \"parameters\": {\"factor\": 0.8}},";
    String twice = Samples.MODEL.replace(gain, gain + "\n" + gain);
    checkFault(twice, ":12: changes.1.form: ", "gain/factor appears twice");
  }

  @Test
  void twoKindsOfHysteresis_areRefused() throws Exception {
    String gain =
        "{\"effect\": \"gain\", \"form\": \"factor\", \"parameters\": {\"factor\": 0.8}},";
    String gap = "{\"effect\": \"hysteresis\", \"form\": \"%s\", \"parameters\": {\"gap\": 0.2}},";
    String both = Samples.MODEL.replace(gain, gap.formatted("hold") + gap.formatted("pick-up"));
    checkFault(both, ":10: changes: ", "at most one of a kind");
  }

  @Test
  void file_cutAnywhere_isRefused() throws Exception {
    String text = Samples.MODEL.stripTrailing();
    for (int length = 0; length < text.length(); length += 13) {
      checkFault(text.substring(0, length), ":", "");
    }
  }

  @Test
  void valuesThatDoNotFit_areRefused() throws Exception {
    SensingSetup setup = setup();
    Form gain =
        Forms.all(setup, List.of()).stream()
            .filter(form -> form.toString().equals("gain/factor"))
            .findFirst()
            .orElseThrow();
    FittedForm fitted = new FittedForm(gain, List.of(0.8));
    Refusal.check(() -> new FittedForm(gain, List.of()), "gain/factor takes 1 values, not 0");
    Refusal.check(() -> new FittedForm(gain, List.of(9.0)), "factor = 9.0 is not in [0.2");
    List<FittedForm> none = List.of();
    Refusal.check(
        () -> new FittedModel(setup, List.of(), List.of(fitted), none), "is not a calibration");
    Refusal.check(
        () -> new FittedModel(setup, List.of(), none, List.of(fitted, fitted)), "appears twice");
    FittedForm tails = new FittedForm(SetupForms.all(setup).get(1), List.of(0.1, 0.1));
    Refusal.check(
        () -> new FittedModel(setup, List.of(), none, List.of(tails)),
        "is not a form of an effect");
  }

  @Test
  void damaged_isReadOrRefused() throws Exception {
    SensingSetup setup = setup();
    FileDamage.check(directory, file -> ModelFile.read(file, setup), Samples.MODEL);
  }
}
