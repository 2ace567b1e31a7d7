package simbad.sonar.catalogue;

import static simbad.sonar.effect.FittedValues.text;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import simbad.definition.Effect;
import simbad.definition.Parameter;
import simbad.definition.Trait;
import simbad.sonar.change.CoarseResolution;
import simbad.sonar.effect.Clues;
import simbad.sonar.effect.Definition;
import simbad.sonar.effect.FittedValues;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;
import simbad.sonar.effect.Probe;
import simbad.sonar.effect.Tries;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.SensingSetup;

/** Readings come in coarser steps than believed. */
public final class CoarseResolutionEffect implements Definition {
  private static final double MOST_STEP_M = 0.5;

  @Override
  public Effect effect() {
    return Effect.COARSE_RESOLUTION;
  }

  @Override
  public String happens() {
    return "readings come in coarser steps than believed";
  }

  @Override
  public String cause() {
    return "a slow timer, whole centimetres or inches in the program, few bits in a message";
  }

  @Override
  public List<Form> forms(SensingSetup setup, List<String> sensors) {
    // Finer steps than the sensor's own are none that it can report.
    double own = Math.min(setup.sensor().resolutionM(), MOST_STEP_M);
    Parameter step =
        Parameter.of("step_m", 0, own, MOST_STEP_M, 0.02, 0.025, 0.03, 0.04, 0.05, 0.08, 0.1)
            .asClosed();
    return Arrays.stream(CoarseResolution.Reported.values())
        .map(
            reported ->
                Form.of(
                    effect(),
                    reported.name().toLowerCase(Locale.ROOT),
                    v -> new CoarseResolution(v[0], reported),
                    step))
        .toList();
  }

  @Override
  public List<double[]> starts(Form form, Clues clues) {
    Parameter step = form.parameters().get(0);
    return Tries.product(form, clues.steps().stream().filter(step::permits).toList());
  }

  /** Steps of 2 cm are what cheap sensors are specified to. */
  @Override
  public List<Probe> probes(SensingSetup setup, PingLog log) {
    return List.of(
        Probe.alone(
            Forms.find(effect(), "start", setup, log.sensors()).orElseThrow(),
            0,
            Math.max(0.02, 2 * setup.sensor().resolutionM())));
  }

  @Override
  public Optional<SensingSetup> corrected(SensingSetup stated, Form form, double... values) {
    return form.with(values) instanceof CoarseResolution steps
            && steps.reported() == CoarseResolution.Reported.START
        ? Optional.of(stated.with(stated.sensor().withResolution(values[0])))
        : Optional.empty();
  }

  @Override
  public String remedy(FittedValues values) {
    return text("set the sensor's resolution_m to %.4g", values.value("step_m"));
  }

  /** Steps as wide as readings of one distance scatter put them where they like. */
  @Override
  public Set<Trait> traits() {
    return Set.of(Trait.MOVES_RANGES);
  }
}
