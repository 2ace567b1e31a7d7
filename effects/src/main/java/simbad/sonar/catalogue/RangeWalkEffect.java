package simbad.sonar.catalogue;

import static simbad.sonar.effect.FittedValues.text;

import java.util.List;
import java.util.Set;
import simbad.definition.Effect;
import simbad.definition.Parameter;
import simbad.definition.Trait;
import simbad.sonar.change.RangeWalk;
import simbad.sonar.effect.Definition;
import simbad.sonar.effect.FittedValues;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;
import simbad.sonar.effect.LogDesign;
import simbad.sonar.effect.Probe;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.TableDetection;

/** Weak echoes read longer than strong ones. */
public final class RangeWalkEffect implements Definition {
  private static final String BY_LEVEL = "by level";
  private static final String BY_DISTANCE = "by distance";

  /** Some waves of the carrier at most: 8.6 mm each. */
  private static final Parameter AT_EDGE = Parameter.of("at_edge_m", 0, 0, 0.15, 0.02, 0.06);

  @Override
  public Effect effect() {
    return Effect.RANGE_WALK;
  }

  @Override
  public String happens() {
    return "weak echoes read longer than strong ones";
  }

  @Override
  public String cause() {
    return "a receiver with a fixed threshold, which a weak echo reaches some waves later";
  }

  /**
   * Where echoes are decided by thresholds the distance stands for the level. An envelope that
   * rises straight reaches a level 1/e sooner with every 20 log10(e) = 8.7 dB; one that falls with
   * 17.4 dB would be a scale of the ranges there.
   */
  @Override
  public List<Form> forms(SensingSetup setup, List<String> sensors) {
    return List.of(
        Form.of(
            effect(),
            BY_DISTANCE,
            v -> new RangeWalk(v[0], v[1]),
            AT_EDGE,
            Parameter.of("fall_db", 4, 1, 10, 3, 6).asClosed()));
  }

  @Override
  public List<Form> levelForms(SensingSetup setup, List<String> sensors) {
    return List.of(
        Form.of(
            effect(),
            BY_LEVEL,
            v -> new RangeWalk(v[0], v[1]),
            AT_EDGE,
            Parameter.of("fall_db", 8, 1, 30, 4, 12).asClosed()));
  }

  /** A reach that is believed to be the same on all sides says nothing of an echo's level. */
  @Override
  public boolean canShow(Form form, LogDesign log) {
    return form.name().equals(BY_LEVEL)
        || log.setup().scene().obstacles().stream()
            .anyMatch(obstacle -> obstacle.detection() instanceof TableDetection);
  }

  /** 1 cm is two waves of 40 kHz. */
  @Override
  public List<Probe> probes(SensingSetup setup, PingLog log) {
    return List.of(Probe.tried(Forms.of(this, setup, log.sensors()).get(0), 0, 0.01));
  }

  @Override
  public Set<Trait> traits() {
    return Set.of(Trait.MOVES_SOME_RANGES);
  }

  @Override
  public String remedy(FittedValues values) {
    return text(
        "subtract up to %.1f cm from the readings of weak echoes, or time the peak of "
            + "the echo",
        100 * values.value("at_edge_m"));
  }
}
