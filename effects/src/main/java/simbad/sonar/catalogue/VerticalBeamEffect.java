package simbad.sonar.catalogue;

import static simbad.sonar.effect.FittedValues.text;

import java.util.List;
import java.util.Set;
import simbad.definition.Effect;
import simbad.definition.Parameter;
import simbad.definition.Trait;
import simbad.sonar.change.VerticalBeam;
import simbad.sonar.effect.Definition;
import simbad.sonar.effect.FittedValues;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;
import simbad.sonar.effect.LogDesign;
import simbad.sonar.effect.Probe;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.SensingSetup;

/** What answers is over or under the beam. */
public final class VerticalBeamEffect implements Definition {
  private static final Parameter HEIGHT = Parameter.of("height_m", 0, 0, 2, 0.05, 0.15, 0.4);

  private static final double LEAST_SOFT_M = 0.005;

  @Override
  public Effect effect() {
    return Effect.VERTICAL_BEAM;
  }

  @Override
  public String happens() {
    return "the target is above or below the beam, or the corner at the floor sends back "
        + "the echo";
  }

  @Override
  public String briefly() {
    return "what sends back the echo is above or below the sensor's axis";
  }

  @Override
  public String cause() {
    return "a low target, a high sensor, a sensor that looks up or down";
  }

  @Override
  public List<Form> forms(SensingSetup setup, List<String> sensors) {
    double soft = Math.max(LEAST_SOFT_M, setup.sensor().edgeWidthM());
    return List.of(
        Form.of(effect(), "slant", v -> new VerticalBeam(v[0], Math.PI / 2, soft), HEIGHT),
        Form.of(
            effect(),
            "cut",
            v -> new VerticalBeam(v[0], Math.toRadians(v[1]), soft),
            HEIGHT,
            Parameter.of("half_angle_deg", 90, 2, 90, 10, 25).asClosed()));
  }

  /** Which lengthens a range of half a metre by a centimetre. */
  @Override
  public List<Probe> probes(SensingSetup setup, PingLog log) {
    return List.of(
        Probe.alone(Forms.find(effect(), "slant", setup, log.sensors()).orElseThrow(), 0, 0.1));
  }

  @Override
  public Set<Effect> twins(LogDesign log) {
    return log.alikeInRange(effect());
  }

  @Override
  public String remedy(FittedValues values) {
    return text(
        "bring sensor and target to one height: the echo comes from %.0f cm above or "
            + "below the axis",
        100 * values.value("height_m"));
  }

  @Override
  public Set<Trait> traits() {
    return Set.of(Trait.MOVES_RANGES);
  }
}
