package simbad.sonar.catalogue;

import static simbad.sonar.effect.FittedValues.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import simbad.definition.Effect;
import simbad.definition.Parameter;
import simbad.definition.Trait;
import simbad.sonar.change.ObstacleOffset;
import simbad.sonar.effect.Clues;
import simbad.sonar.effect.Definition;
import simbad.sonar.effect.FittedValues;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.LogDesign;
import simbad.sonar.effect.Probe;
import simbad.sonar.ping.PingLog;
import simbad.sonar.ping.Scenes;
import simbad.sonar.scene.SensingSetup;

/** An obstacle stands elsewhere than believed. */
public final class ObstacleOffsetEffect implements Definition {
  private static final String ALL = "all";
  private static final double MOST_M = 1;

  @Override
  public Effect effect() {
    return Effect.OBSTACLE_OFFSET;
  }

  @Override
  public String happens() {
    return "an obstacle stands elsewhere than believed";
  }

  @Override
  public String cause() {
    return "an obstacle whose place was measured wrongly, or that was knocked";
  }

  @Override
  public List<Form> forms(SensingSetup setup, List<String> sensors) {
    List<Form> forms = new ArrayList<>(List.of(moved(ALL, Optional.empty(), MOST_M)));
    List<String> labels = Scenes.labels(setup.scene());
    if (labels.size() > 1) {
      labels.forEach(label -> forms.add(moved("only:" + label, Optional.of(label), MOST_M)));
    }
    return forms;
  }

  private Form moved(String name, Optional<String> only, double mostM) {
    return Form.of(
        effect(),
        name,
        v -> new ObstacleOffset(v[0], v[1], only),
        Parameter.of("x_m", 0, -mostM, mostM, -0.06, 0, 0.06),
        Parameter.of("z_m", 0, -mostM, mostM, -0.06, 0, 0.06));
  }

  /** A lone one that is turned before a sensor is aimed at. */
  @Override
  public Form within(Form form, LogDesign log) {
    double mostM = log.mostAsideM();
    return mostM < MOST_M ? moved(form.name(), Optional.empty(), mostM) : form;
  }

  @Override
  public Optional<double[]> whereHeard(Form form, Clues.HeardArc arc) {
    return form.name().equals(ALL)
        ? Optional.of(new double[] {arc.xM(), arc.zM()})
        : Optional.empty();
  }

  /** 1 cm either way. */
  @Override
  public List<Probe> probes(SensingSetup setup, PingLog log) {
    Form all = forms(setup, log.sensors()).get(0);
    return setup.scene().obstacles().isEmpty()
        ? List.of()
        : List.of(Probe.alone(all, 0, 0.01), Probe.alone(all, 1, 0.01));
  }

  /** Twice what a tape is read off to, in any direction. */
  @Override
  public boolean isWithinDays(Form form, double... values) {
    return Math.hypot(values[0], values[1]) < 0.004;
  }

  @Override
  public String remedy(FittedValues values) {
    return text(
        "move the obstacle by %+.3f m in x and %+.3f m in z",
        values.value("x_m"), values.value("z_m"));
  }

  @Override
  public Set<Effect> twins(LogDesign log) {
    return log.isOneBearing() ? Set.of(Effect.BEAM_MISALIGNMENT) : Set.of();
  }

  @Override
  public Set<Trait> traits() {
    return Set.of(Trait.SOAKS_UP_PLACEMENTS, Trait.MOVES_OBSTACLES);
  }
}
