package simbad.sonar.catalogue;

import static simbad.sonar.effect.FittedValues.text;

import java.util.List;
import simbad.definition.Effect;
import simbad.definition.Parameter;
import simbad.sonar.change.Hysteresis;
import simbad.sonar.effect.Definition;
import simbad.sonar.effect.FittedValues;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;
import simbad.sonar.effect.Probe;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.SensingSetup;

/** An obstacle is picked up at a shorter distance than it is lost at. */
public final class HysteresisEffect implements Definition {
  private static final Parameter GAP = Parameter.of("gap", 0, 0, 0.7, 0.05, 0.15, 0.3);

  @Override
  public Effect effect() {
    return Effect.HYSTERESIS;
  }

  @Override
  public String happens() {
    return "an obstacle is found at a shorter distance than the one at which it is lost";
  }

  @Override
  public String briefly() {
    return "an obstacle is found nearer than it is lost";
  }

  @Override
  public String cause() {
    return "a receiver or a filter that needs less to keep an echo than to find it";
  }

  @Override
  public List<Form> forms(SensingSetup setup, List<String> sensors) {
    return List.of(
        Form.of(effect(), "pick-up", v -> new Hysteresis(1 - v[0], 1), GAP),
        Form.of(effect(), "hold", v -> new Hysteresis(1, 1 + v[0]), GAP),
        Form.of(
            effect(),
            "metres",
            v -> new Hysteresis(1, 1, v[0]),
            Parameter.of("pick_up_m", 0, 0, 2, 0.05, 0.15, 0.4)),
        Form.of(effect(), "both", v -> new Hysteresis(1 - v[0] / 2, 1 + v[0] / 2), GAP));
  }

  /** A twentieth between pick-up and loss. */
  @Override
  public List<Probe> probes(SensingSetup setup, PingLog log) {
    return List.of(
        Probe.alone(Forms.find(effect(), "both", setup, log.sensors()).orElseThrow(), 0, 0.05));
  }

  @Override
  public String remedy(FittedValues values) {
    String apart =
        values.has("gap")
            ? text("%.0f %%", 100 * values.value("gap"))
            : text("%.2f m", values.value("pick_up_m"));
    return text(
        "measure thresholds both ways, towards the obstacle and away from it: they are %s apart",
        apart);
  }
}
