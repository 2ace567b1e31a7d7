package simbad.sonar.catalogue;

import static simbad.sonar.effect.FittedValues.text;

import java.util.List;
import simbad.definition.Effect;
import simbad.definition.Parameter;
import simbad.sonar.change.DeadZone;
import simbad.sonar.effect.Clues;
import simbad.sonar.effect.Definition;
import simbad.sonar.effect.FittedValues;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;
import simbad.sonar.effect.Probe;
import simbad.sonar.effect.Tries;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.SensingSetup;

/** Near echoes are lost: the real minimum range is longer. */
public final class DeadZoneEffect implements Definition {
  @Override
  public Effect effect() {
    return Effect.DEAD_ZONE;
  }

  @Override
  public String happens() {
    return "near echoes are lost: the real minimum range is longer";
  }

  @Override
  public String briefly() {
    return "near echoes are lost";
  }

  @Override
  public String cause() {
    return "a transducer that still rings when the echo comes, a blanking time that was set too long";
  }

  @Override
  public List<Form> forms(SensingSetup setup, List<String> sensors) {
    Parameter end = Parameter.of("end_m", 0, 0, setup.sensor().maxRangeM(), 0.15, 0.3, 0.5, 0.8);
    return List.of(
        Form.of(effect(), "sharp", v -> new DeadZone(v[0], 0), end),
        Form.of(
            effect(),
            "soft",
            v -> new DeadZone(v[0], v[1]),
            end,
            Parameter.of("soft_m", 0, 0, 0.3, 0.02)));
  }

  @Override
  public List<double[]> starts(Form form, Clues clues) {
    return Tries.combined(form, Distances.first(form, clues));
  }

  /** Sensors are specified to be blind up to 0.3 m. */
  @Override
  public List<Probe> probes(SensingSetup setup, PingLog log) {
    return List.of(
        Probe.alone(
            Forms.find(effect(), "sharp", setup, log.sensors()).orElseThrow(),
            0,
            Math.max(0.3, 1.5 * setup.sensor().minRangeM())));
  }

  @Override
  public String remedy(FittedValues values) {
    return text("set min_range_m to %.3f", values.value("end_m"));
  }
}
