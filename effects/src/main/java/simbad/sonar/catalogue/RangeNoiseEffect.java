package simbad.sonar.catalogue;

import static simbad.sonar.effect.FittedValues.text;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import simbad.definition.Effect;
import simbad.definition.Parameter;
import simbad.definition.Trait;
import simbad.sonar.change.NoiseTails;
import simbad.sonar.change.RangeNoise;
import simbad.sonar.effect.Definition;
import simbad.sonar.effect.FittedValues;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;
import simbad.sonar.effect.LogDesign;
import simbad.sonar.effect.Probe;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SonarSpec;

/** Ranges scatter more than believed. */
public final class RangeNoiseEffect implements Definition {
  @Override
  public Effect effect() {
    return Effect.RANGE_NOISE;
  }

  @Override
  public String happens() {
    return "ranges scatter more than believed";
  }

  @Override
  public String cause() {
    return "electrical noise, a weak echo, wind, a timer that jitters";
  }

  @Override
  public List<Form> forms(SensingSetup setup, List<String> sensors) {
    return List.of(
        Form.of(
            effect(),
            "constant",
            v -> new RangeNoise(v[0], 0),
            Parameter.of("added_m", 0, 0, 0.5, 0.01, 0.03, 0.1)),
        Form.of(
            effect(),
            "growing",
            v -> new RangeNoise(v[0], v[1]),
            Parameter.of("added_m", 0, 0, 0.5, 0.002, 0.02),
            Parameter.of("added_per_m", 0, 0, 0.3, 0.01, 0.04)),
        Form.of(
            effect(),
            "tails",
            v -> new NoiseTails(v[0], v[1]),
            Parameter.of("share", 0, 0, 1, 0.1, 0.4).asClosed(),
            Parameter.of("deviation_m", 0, 0, 0.25, 0.03, 0.1)));
  }

  /** 1 cm of scatter is what cheap sensors are specified to. */
  @Override
  public List<Probe> probes(SensingSetup setup, PingLog log) {
    return List.of(
        Probe.alone(Forms.find(effect(), "constant", setup, log.sensors()).orElseThrow(), 0, 0.01));
  }

  /** What scatters from placement to placement alone is no noise. */
  @Override
  public boolean canShow(Form form, LogDesign log) {
    return log.isNoisier();
  }

  @Override
  public Optional<SensingSetup> corrected(SensingSetup stated, Form form, double... values) {
    SonarSpec sensor = stated.sensor();
    return form.with(values) instanceof RangeNoise noise && noise.addedPerM() == 0
        ? Optional.of(
            stated.with(
                sensor.withScatter(
                    Math.hypot(sensor.rangeNoiseM(), noise.addedM()),
                    sensor.missRate(),
                    sensor.edgeWidthM())))
        : Optional.empty();
  }

  @Override
  public String remedy(FittedValues values) {
    return values.has("deviation_m")
        ? text(
            "take the median of a few readings: %.0f %% of them scatter by %.3f m",
            100 * values.value("share"), values.value("deviation_m"))
        : text(
            "take the mean of some readings, or raise the sensor's range_noise_m:"
                + " readings scatter by %.3f m more",
            values.value("added_m"));
  }

  @Override
  public Set<Trait> traits() {
    return Set.of(Trait.BESIDE_THE_LAW, Trait.SOAKS_UP);
  }
}
