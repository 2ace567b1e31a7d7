package simbad.sonar.catalogue;

import static simbad.sonar.effect.FittedValues.text;

import java.util.List;
import java.util.Set;
import simbad.definition.Effect;
import simbad.definition.Parameter;
import simbad.definition.Trait;
import simbad.sonar.change.FloorEcho;
import simbad.sonar.change.TwoFloorEchoes;
import simbad.sonar.effect.Clues;
import simbad.sonar.effect.Definition;
import simbad.sonar.effect.FittedValues;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;
import simbad.sonar.effect.Modes;
import simbad.sonar.effect.Probe;
import simbad.sonar.effect.Tries;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.SensingSetup;

/** The floor answers at a fixed range when nothing nearer does. */
public final class FloorEchoEffect implements Definition {
  private static final Parameter SHARE = Parameter.of("share", 0, 0, 1, 0.05, 0.2, 0.5).asClosed();
  private static final int MODES = 4;

  @Override
  public Effect effect() {
    return Effect.FLOOR_ECHO;
  }

  @Override
  public String happens() {
    return "the floor sends back an echo from a fixed range when nothing nearer does";
  }

  @Override
  public String briefly() {
    return "the floor sends back an echo when nothing nearer does";
  }

  @Override
  public String cause() {
    return "a sensor that is mounted low or tilted down, a carpet edge or a joint in the floor";
  }

  @Override
  public List<Form> forms(SensingSetup setup, List<String> sensors) {
    double most = setup.sensor().maxRangeM();
    Parameter range = Parameter.of("range_m", most, 0.02, most, 0.3 * most);
    Parameter spread = Parameter.of("spread_m", 0, 0, 0.15, 0.02);
    return List.of(
        Form.of(effect(), "fixed", v -> new FloorEcho(v[0], v[1], v[2]), range, spread, SHARE),
        Form.of(
            effect(),
            "two",
            v -> new TwoFloorEchoes(new FloorEcho(v[0], v[1], v[2]), v[3], v[4]),
            range,
            spread,
            SHARE,
            Parameter.of("apart_m", 0, 0.01, 0.4, 0.05),
            Parameter.of("farther_share", 0, 0, 1, 0.2).asClosed()));
  }

  @Override
  public List<double[]> starts(Form form, Clues clues) {
    List<List<Double>> tries = Tries.of(form);
    tries.set(0, Modes.of(clues.strangeRangesM(), 0.02, MODES));
    tries.set(1, List.of(0.01, 0.04));
    return Tries.combined(form, tries);
  }

  /** A tenth of the pings that nothing nearer answers. */
  @Override
  public List<Probe> probes(SensingSetup setup, PingLog log) {
    return List.of(
        Probe.tried(Forms.find(effect(), "fixed", setup, log.sensors()).orElseThrow(), 2, 0.1));
  }

  @Override
  public String remedy(FittedValues values) {
    return text(
        "raise the sensor or tilt it up: an echo comes from %.2f m, whatever is there",
        values.value("range_m"));
  }

  @Override
  public Set<Trait> traits() {
    return Set.of(Trait.SOAKS_UP_A_REST);
  }
}
