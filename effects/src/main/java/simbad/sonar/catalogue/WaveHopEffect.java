package simbad.sonar.catalogue;

import static simbad.sonar.effect.FittedValues.text;

import java.util.List;
import simbad.definition.Effect;
import simbad.definition.Parameter;
import simbad.sonar.change.WaveHop;
import simbad.sonar.effect.Definition;
import simbad.sonar.effect.FittedValues;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;
import simbad.sonar.effect.LogDesign;
import simbad.sonar.effect.Probe;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SonarSpec;

/** Readings are off by whole periods of the carrier. */
public final class WaveHopEffect implements Definition {
  /** Steps and noise that hide a wave of 4 mm. */
  private static final double HIDES_WAVES_M = 0.003;

  @Override
  public Effect effect() {
    return Effect.WAVE_HOP;
  }

  @Override
  public String happens() {
    return "readings are off by whole periods of the carrier";
  }

  @Override
  public String cause() {
    return "a weak echo, whose first wave stays under the threshold of the receiver";
  }

  @Override
  public List<Form> forms(SensingSetup setup, List<String> sensors) {
    return List.of(
        Form.of(
            effect(),
            "later",
            v -> new WaveHop(v[0], v[1]),
            Parameter.of("share", 0, 0, 1, 0.1, 0.4).asClosed(),
            Parameter.of("step_m", 0, 0.002, 0.009, 0.0043, 0.0086)));
  }

  /** A fifth of the echoes. */
  @Override
  public List<Probe> probes(SensingSetup setup, PingLog log) {
    return List.of(
        Probe.tried(Forms.find(effect(), "later", setup, log.sensors()).orElseThrow(), 0, 0.2));
  }

  /** It is looked for where steps and noise do not hide it. */
  @Override
  public boolean canShow(Form form, LogDesign log) {
    SonarSpec sensor = log.setup().sensor();
    return sensor.resolutionM() <= HIDES_WAVES_M && sensor.rangeNoiseM() <= HIDES_WAVES_M;
  }

  @Override
  public String remedy(FittedValues values) {
    return text(
        "raise the echo's level, or take the least of a few readings: %.0f %% of the echoes read"
            + " %.1f mm too far",
        100 * values.value("share"), 1000 * values.value("step_m"));
  }
}
