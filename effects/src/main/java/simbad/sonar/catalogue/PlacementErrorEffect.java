package simbad.sonar.catalogue;

import static simbad.sonar.effect.FittedValues.text;

import java.util.List;
import java.util.Set;
import simbad.definition.Effect;
import simbad.definition.Parameter;
import simbad.definition.Trait;
import simbad.sonar.change.RangeNoise;
import simbad.sonar.effect.Definition;
import simbad.sonar.effect.FittedValues;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;
import simbad.sonar.effect.LogDesign;
import simbad.sonar.effect.Probe;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.SensingSetup;

/** Each placement is a little elsewhere than believed, by its own amount. */
public final class PlacementErrorEffect implements Definition {
  /** "A little elsewhere": what a tape or a ruler may be off by. */
  private static final double MOST_MISPLACED_M = 0.05;

  @Override
  public Effect effect() {
    return Effect.PLACEMENT_ERROR;
  }

  @Override
  public String happens() {
    return "each placement is a little off, by an amount of its own";
  }

  @Override
  public String briefly() {
    return "each placement is a little off";
  }

  @Override
  public String cause() {
    return "a tape or a ruler that was read without care";
  }

  @Override
  public List<Form> forms(SensingSetup setup, List<String> sensors) {
    return List.of(
        Form.of(
            effect(),
            "range",
            v -> new RangeNoise(v[0], 0),
            Parameter.of("deviation_m", 0, 0, MOST_MISPLACED_M, 0.002, 0.01, 0.03)));
  }

  /** 1 cm, as a tape is read in passing. */
  @Override
  public List<Probe> probes(SensingSetup setup, PingLog log) {
    return List.of(
        Probe.alone(Forms.find(effect(), "range", setup, log.sensors()).orElseThrow(), 0, 0.01));
  }

  /** It is looked for where things were put in place and read again, and are not off as stated. */
  @Override
  public boolean canShow(Form form, LogDesign log) {
    return log.isFurtherOff();
  }

  @Override
  public String remedy(FittedValues values) {
    return text(
        "place things more exactly than %.1f cm, or give pose_sigma_m",
        100 * values.value("deviation_m"));
  }

  @Override
  public Set<Trait> traits() {
    return Set.of(Trait.MISPLACES, Trait.SOAKS_UP_A_REST);
  }
}
