package simbad.sonar.effect;

import static java.lang.Math.toRadians;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SonarSpec;

/**
 * The catalogue of calibrations: in what a set-up may be a little off while the simulation is
 * trusted. None belongs to an effect.
 */
public final class SetupForms {
  /** Waves of a threshold's factor round the obstacle. */
  public static final int WAVES = 7;

  private SetupForms() {}

  /**
   * Returns all calibrations: the scatter, the tails, the cone's border, and for each obstacle its
   * threshold.
   *
   * @param setup whose obstacles and sensor they are for
   */
  public static List<Form> all(SensingSetup setup) {
    List<Form> forms = new ArrayList<>(List.of(scatter(setup.sensor()), tails(), edge()));
    Scenes.labels(setup.scene()).forEach(label -> forms.add(threshold(label)));
    return List.copyOf(forms);
  }

  /**
   * Returns what an effect does as a calibration: what already differs while the simulation is
   * trusted belongs to the set-up, whatever its name.
   *
   * @param form of an effect
   */
  public static Form of(Form form) {
    return new Form(Optional.empty(), form.toString(), form.parameters(), form.maker());
  }

  /**
   * Finds a calibration by its name.
   *
   * @param name of one of {@link #all}, or of an effect's form as {@link #of} names it
   * @param setup whose obstacles and sensor it is for
   * @param sensors labels of the transducers in the log
   */
  public static Optional<Form> find(String name, SensingSetup setup, List<String> sensors) {
    Stream<Form> effects = Forms.known(setup, sensors);
    return Stream.concat(all(setup).stream(), effects.map(SetupForms::of))
        .filter(form -> form.name().equals(name))
        .findFirst()
        .or(() -> LevelForms.find(name, setup));
  }

  private static Form scatter(SonarSpec sensor) {
    double edge = sensor.edgeWidthM();
    double noise = sensor.rangeNoiseM();
    double misses = sensor.missRate();
    return form(
        "scatter",
        v -> new SensorScatter(v[0], v[1], v[2]),
        Parameter.of("edge_width_m", edge, 0, Math.max(0.5, edge), edge, 0.05),
        Parameter.of("range_noise_m", noise, 0, Math.max(0.25, noise), noise),
        Parameter.of("miss_rate", misses, 0, 1, misses));
  }

  private static Form tails() {
    return form(
        "tails",
        v -> new NoiseTails(v[0], v[1]),
        Parameter.of("share", 0, 0, 1, 0.1),
        Parameter.of("deviation_m", 0, 0, 0.25, 0.03));
  }

  private static Form edge() {
    return form(
        "beam-edge",
        v -> new BeamEdge(toRadians(v[0])),
        Parameter.of("soft_deg", 0, 0, 10, 0.5, 2));
  }

  private static Form threshold(String label) {
    List<Parameter> series = new ArrayList<>();
    series.add(Parameter.of("constant", 0, -0.3, 0.3, 0));
    for (int wave = 1; wave <= WAVES; wave++) {
      series.add(Parameter.of("cos_" + wave, 0, -0.3, 0.3, 0));
      series.add(Parameter.of("sin_" + wave, 0, -0.3, 0.3, 0));
    }
    return form(
        "threshold:" + label,
        v -> new BearingFactor(Optional.of(label), Arrays.stream(v).boxed().toList()),
        series.toArray(Parameter[]::new));
  }

  private static Form form(String name, Form.Maker maker, Parameter... parameters) {
    return new Form(Optional.empty(), name, List.of(parameters), maker);
  }
}
