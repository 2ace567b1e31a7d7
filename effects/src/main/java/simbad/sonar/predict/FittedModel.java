package simbad.sonar.predict;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.random.RandomGenerator;
import java.util.stream.Stream;
import simbad.definition.Effect;
import simbad.sonar.catalogue.SetupForms;
import simbad.sonar.change.Reckoning;
import simbad.sonar.effect.FittedForm;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;
import simbad.sonar.model.SensorModel;
import simbad.sonar.ping.Change;
import simbad.sonar.ping.ObstacleChange;
import simbad.sonar.ping.Scenes;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.sensing.Sensor;

/**
 * A model as a diagnosis leaves it: a set-up, how it is calibrated, and the effects at work.
 *
 * <p>As a sensor model it brings its own sensor's figures along. What it says of one obstacle, or
 * of one transducer, holds for the obstacle of that label, or the transducer at that label's place;
 * where the world has none, it holds for none, and what it says of all holds for all.
 *
 * @param setup as the simulator believed it
 * @param sensors labels of the transducers, in the order of a belt's
 * @param calibration in what the set-up is off without an effect
 * @param effects the forms of the effects at work
 */
public record FittedModel(
    SensingSetup setup,
    List<String> sensors,
    List<FittedForm> calibration,
    List<FittedForm> effects)
    implements SensorModel {

  /** Copies the lists; a form that stands twice or in the wrong list is refused. */
  public FittedModel {
    sensors = List.copyOf(sensors);
    calibration = List.copyOf(calibration);
    effects = List.copyOf(effects);
    List<Form> forms = new ArrayList<>();
    calibration.forEach(fitted -> check(fitted.form(), true, forms));
    effects.forEach(fitted -> check(fitted.form(), false, forms));
  }

  private static void check(Form form, boolean calibrates, List<Form> before) {
    if (form.of().isEmpty() != calibrates) {
      throw new IllegalArgumentException(
          form + (calibrates ? " is not a calibration" : " is not a form of an effect"));
    }
    if (before.contains(form)) {
      throw new IllegalArgumentException(form + " appears twice");
    }
    before.add(form);
  }

  /** Finds a form by what files say of it. */
  public static Optional<Form> find(
      Optional<Effect> effect, String name, SensingSetup setup, List<String> sensors) {
    return effect.isPresent()
        ? Forms.find(effect.get(), name, setup, sensors)
        : SetupForms.find(name, setup, sensors);
  }

  /** Returns all changes, the calibration's first. */
  public List<Change> changes() {
    return ChangedModel.changes(changes(calibration), changes(effects));
  }

  private static List<Change> changes(List<FittedForm> forms) {
    return forms.stream().map(FittedForm::change).toList();
  }

  /** Returns the forms that say nothing of a scene, because it lacks the obstacles they are of. */
  public List<FittedForm> idleIn(Scene scene) {
    List<String> labels = Scenes.labels(scene);
    return Stream.concat(calibration.stream(), effects.stream())
        .filter(fitted -> fitted.change() instanceof ObstacleChange)
        .filter(fitted -> ((ObstacleChange) fitted.change()).isIdle(labels))
        .toList();
  }

  /** Returns the model with its effects. */
  public ChangedModel diagnosed() {
    return new ChangedModel(setup, changes());
  }

  /** Returns the model without its effects: calibrated only. */
  public ChangedModel calibrated() {
    return new ChangedModel(setup, changes(calibration));
  }

  /**
   * Binds the model to a scene.
   *
   * @param sensor of no interest: the model is that of its own sensor
   * @param scene what may be heard, in the place of the set-up's
   * @param random source of chance
   */
  @Override
  public Sensor bind(SonarSpec sensor, Scene scene, RandomGenerator random) {
    SensingSetup there = new SensingSetup(setup.sensor(), scene, setup.noEchoM(), setup.details());
    // A robot that reckons its way wrongly hears from where it is all the same.
    List<Change> heard =
        changes().stream().filter(change -> !(change instanceof Reckoning)).toList();
    return new DiagnosedSensor(new ChangedModel(there, heard), sensors, random);
  }
}
