package simbad.sonar.effect;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import simbad.sonar.scene.SensingSetup;

/** The forms that effects can take before a given set-up, as their definitions have them. */
public final class Forms {
  /** Bearings of a fitted table, as many as the thesis measured. */
  public static final int TABLE_SIZE = 72;

  /** Waves of a fitted shadow of few lobes. */
  public static final int SHADOW_WAVES = 3;

  private Forms() {}

  /**
   * Returns all forms of all effects, in the order of the vocabulary.
   *
   * @param setup whose obstacles and sensor they are for
   * @param sensors labels of the transducers in the log
   */
  public static List<Form> all(SensingSetup setup, List<String> sensors) {
    return Definitions.all().stream()
        .flatMap(definition -> of(definition, setup, sensors).stream())
        .toList();
  }

  /** Returns the forms of one effect under the law by which the set-up decides on echoes. */
  public static List<Form> of(Definition definition, SensingSetup setup, List<String> sensors) {
    return setup.sensor().law().isLevel()
        ? definition.levelForms(setup, sensors)
        : definition.forms(setup, sensors);
  }

  /** Finds a form by its effect and name. */
  public static Optional<Form> find(
      Effect effect, String name, SensingSetup setup, List<String> sensors) {
    return known(Definitions.of(effect), setup, sensors)
        .filter(form -> form.name().equals(name))
        .findFirst();
  }

  /** Returns what a file may name: forms under either law. */
  static Stream<Form> known(SensingSetup setup, List<String> sensors) {
    return Definitions.all().stream().flatMap(each -> known(each, setup, sensors));
  }

  /** A scene that believes in thresholds may have been diagnosed under the level law. */
  private static Stream<Form> known(
      Definition definition, SensingSetup setup, List<String> sensors) {
    return Stream.of(of(definition, setup, sensors), definition.levelForms(setup, sensors))
        .flatMap(List::stream);
  }
}
