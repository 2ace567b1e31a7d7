package simbad.sonar.catalogue;

import static simbad.sonar.effect.FittedValues.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import simbad.definition.Effect;
import simbad.definition.Parameter;
import simbad.definition.Trait;
import simbad.sonar.change.EarlyTimeout;
import simbad.sonar.change.ReadingTimeout;
import simbad.sonar.effect.Clues;
import simbad.sonar.effect.Definition;
import simbad.sonar.effect.FittedValues;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Probe;
import simbad.sonar.effect.Tries;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SonarSpec;

/** Far echoes are lost: the real time-out is shorter. */
public final class EarlyTimeoutEffect implements Definition {
  private static final String SHARP = "sharp";
  private static final String READING = "reading";

  @Override
  public Effect effect() {
    return Effect.EARLY_TIMEOUT;
  }

  @Override
  public String happens() {
    return "far echoes are lost: the real time-out is shorter";
  }

  @Override
  public String briefly() {
    return "far echoes are lost";
  }

  @Override
  public String cause() {
    return "a time-out in the program, a receiver that stops listening early";
  }

  @Override
  public List<Form> forms(SensingSetup setup, List<String> sensors) {
    Parameter start = start(setup);
    Parameter soft = Parameter.of("soft_m", 0, 0, 0.3, 0.02);
    return List.of(
        sharp(start), Form.of(effect(), "soft", v -> new EarlyTimeout(v[0], v[1]), start, soft));
  }

  /**
   * A time-out is a clock's, which ends what is read; one that is soft is a receiver that asks
   * more, as air does.
   */
  @Override
  public List<Form> levelForms(SensingSetup setup, List<String> sensors) {
    Parameter start = start(setup);
    return List.of(Form.of(effect(), READING, v -> new ReadingTimeout(v[0]), start), sharp(start));
  }

  private Form sharp(Parameter start) {
    return Form.of(effect(), SHARP, v -> new EarlyTimeout(v[0], 0), start);
  }

  private static Parameter start(SensingSetup setup) {
    double most = setup.sensor().maxRangeM();
    return Parameter.of(
        "start_m", Double.POSITIVE_INFINITY, 0.1, most, 0.3 * most, 0.5 * most, 0.7 * most);
  }

  @Override
  public List<double[]> starts(Form form, Clues clues) {
    List<List<Double>> tries = Distances.first(form, clues);
    List<Double> start = new ArrayList<>(Distances.edges(clues));
    start.addAll(tries.get(0));
    tries.set(0, start);
    return Tries.combined(form, tries);
  }

  /** A quarter of what the scene or the sensor reaches. */
  @Override
  public List<Probe> probes(SensingSetup setup, PingLog log) {
    double reach =
        setup.scene().obstacles().stream()
            .mapToDouble(obstacle -> obstacle.detection().greatestM())
            .filter(threshold -> threshold > 0)
            .max()
            .orElse(Double.POSITIVE_INFINITY);
    double practical = 0.75 * Math.min(setup.sensor().maxRangeM(), reach);
    return List.of(Probe.alone(sharp(start(setup)), 0, practical));
  }

  @Override
  public Optional<SensingSetup> corrected(SensingSetup stated, Form form, double... values) {
    SonarSpec sensor = stated.sensor();
    boolean isSharp = form.name().equals(SHARP) || form.name().equals(READING);
    return isSharp && values[0] > sensor.minRangeM()
        ? Optional.of(stated.with(sensor.withRange(sensor.minRangeM(), values[0])))
        : Optional.empty();
  }

  @Override
  public String remedy(FittedValues values) {
    return text("set max_range_m to %.2f, or wait longer for the echo", values.value("start_m"));
  }

  @Override
  public Set<Trait> traits() {
    return Set.of(Trait.BESIDE_THE_LAW);
  }
}
