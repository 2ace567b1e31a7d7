package simbad.sonar.catalogue;

import static simbad.sonar.effect.FittedValues.text;

import java.util.List;
import java.util.Set;
import simbad.definition.Effect;
import simbad.definition.Parameter;
import simbad.definition.Trait;
import simbad.sonar.change.Crosstalk;
import simbad.sonar.change.EarlyCrosstalk;
import simbad.sonar.change.WalkingCrosstalk;
import simbad.sonar.effect.Clues;
import simbad.sonar.effect.Definition;
import simbad.sonar.effect.FittedValues;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;
import simbad.sonar.effect.LogDesign;
import simbad.sonar.effect.Modes;
import simbad.sonar.effect.Probe;
import simbad.sonar.effect.Tries;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.SensingSetup;

/** Now and then a reading has nothing to do with the scene. */
public final class CrosstalkEffect implements Definition {
  /** Most pings may hear a sonar that never rests; what all of them hear is no stranger. */
  private static final Parameter SHARE = Parameter.of("share", 0, 0, 0.9, 0.03, 0.1, 0.3);

  /** What comes from nearly the same range each time has a place. */
  private static final double LEAST_BAND_M = 0.3;

  /** What walks by less from ping to ping hardly walks. */
  private static final double LEAST_STEP_M = 0.01;

  private static final String WALKING = "walking";

  @Override
  public Effect effect() {
    return Effect.CROSSTALK;
  }

  @Override
  public String happens() {
    return "now and then a reading has nothing to do with the scene";
  }

  @Override
  public String cause() {
    return "another sonar, an air hose or another source of ultrasound, electrical noise";
  }

  /** A late echo of the ping before looks like it where nobody knows which ping came before. */
  @Override
  public Set<Effect> twins(LogDesign log) {
    return log.isTimed() ? Set.of() : Set.of(Effect.PREVIOUS_PING);
  }

  /** In a drive distance and time go together, and so may what walks with time. */
  @Override
  public boolean isOfThePlace(String form) {
    return form.startsWith(WALKING);
  }

  @Override
  public List<Form> forms(SensingSetup setup, List<String> sensors) {
    double most = setup.sensor().maxRangeM();
    Parameter low = Parameter.of("low_m", 0, 0, 0.9 * most, 0.05);
    Parameter band = Parameter.of("band_m", most, LEAST_BAND_M, most, 0.5 * most, most);
    return List.of(
        Form.of(
            effect(), "any", v -> new Crosstalk(v[0], v[1], v[1] + v[2], false), SHARE, low, band),
        Form.of(
            effect(),
            "silent",
            v -> new Crosstalk(v[0], v[1], v[1] + v[2], true),
            SHARE,
            low,
            band),
        Form.of(
            effect(),
            "earlier",
            v -> new EarlyCrosstalk(v[0], v[1], v[1] + v[2]),
            SHARE,
            low,
            band),
        walking(WALKING, most, Parameter.of("step_m", LEAST_STEP_M, LEAST_STEP_M, 1, 0.1)),
        walking(
            WALKING + " back",
            most,
            Parameter.of("step_m", -LEAST_STEP_M, -1, -LEAST_STEP_M, -0.1)));
  }

  private Form walking(String name, double most, Parameter step) {
    return Form.of(
        effect(),
        name,
        v -> new WalkingCrosstalk(v[0], v[1], v[2], v[3], v[4], v[5]),
        SHARE,
        Parameter.of("low_m", 0, 0, 0.5, 0),
        Parameter.of("band_m", most, 0.5, 3 * most, most),
        step,
        Parameter.of("start_m", 0, -3 * most, 3 * most, 0),
        Parameter.of("spread_m", 0, 0, 0.1, 0.01));
  }

  @Override
  public List<double[]> starts(Form form, Clues clues) {
    if (form.name().startsWith(WALKING)) {
      return clues.walks(form);
    }
    double[] sorted = clues.strangeRangesM().sorted().toArray();
    if (sorted.length == 0) {
      return Tries.product(form, form.parameters().get(0).tries(), List.of(), List.of());
    }
    double low = Modes.quantile(sorted, 0.02) - 0.02;
    double high = Modes.quantile(sorted, 0.98) + 0.02;
    double most = form.parameters().get(2).high();
    double share = (double) sorted.length / clues.log().size();
    List<Double> bands = List.of(high - low, most);
    return Tries.product(form, List.of(share, 2 * share), List.of(low, 0.05), bands);
  }

  /** A fiftieth of the readings. */
  @Override
  public List<Probe> probes(SensingSetup setup, PingLog log) {
    return List.of(
        Probe.tried(Forms.find(effect(), "any", setup, log.sensors()).orElseThrow(), 0, 0.02));
  }

  @Override
  public String remedy(FittedValues values) {
    return text(
        "never let two sonars ping at the same time, and take the median of three readings:"
            + " %.0f %% of the pings hear another sonar",
        100 * values.value("share"));
  }

  @Override
  public Set<Trait> traits() {
    return Set.of(Trait.SOAKS_UP);
  }
}
