package simbad.sonar.catalogue;

import static java.lang.Math.toRadians;
import static simbad.sonar.effect.FittedValues.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import simbad.definition.Effect;
import simbad.definition.Parameter;
import simbad.definition.Trait;
import simbad.sonar.change.ObstacleTurn;
import simbad.sonar.effect.Definition;
import simbad.sonar.effect.FittedValues;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.LogDesign;
import simbad.sonar.effect.Probe;
import simbad.sonar.ping.PingLog;
import simbad.sonar.ping.Scenes;
import simbad.sonar.scene.SensingSetup;

/** An obstacle is turned otherwise than believed. */
public final class ObstacleTurnEffect implements Definition {
  @Override
  public Effect effect() {
    return Effect.OBSTACLE_TURN;
  }

  @Override
  public String happens() {
    return "an obstacle is turned otherwise than believed";
  }

  @Override
  public String cause() {
    return "an obstacle that was set up at another angle, or knocked";
  }

  @Override
  public List<Form> forms(SensingSetup setup, List<String> sensors) {
    List<Form> forms = new ArrayList<>(List.of(turned("all", Optional.empty())));
    List<String> labels = Scenes.labels(setup.scene());
    if (labels.size() > 1) {
      labels.forEach(label -> forms.add(turned("only:" + label, Optional.of(label))));
    }
    return forms;
  }

  private Form turned(String name, Optional<String> only) {
    return Form.of(
        effect(),
        name,
        v -> new ObstacleTurn(toRadians(v[0]), only),
        Parameter.of("turn_deg", 0, -180, 180, -30, -20, -12, -7, -3, 3, 7, 12, 20, 30).asClosed());
  }

  /** 2 degrees. */
  @Override
  public List<Probe> probes(SensingSetup setup, PingLog log) {
    return setup.scene().obstacles().isEmpty()
        ? List.of()
        : List.of(Probe.alone(forms(setup, log.sensors()).get(0), 0, 2));
  }

  @Override
  public boolean canShow(Form form, LogDesign log) {
    return !log.isOfRoundOnes(form, true);
  }

  /** A quarter of a degree on a protractor. */
  @Override
  public boolean isWithinDays(Form form, double... values) {
    return Math.abs(values[0] - form.neutral()[0]) < 0.5;
  }

  @Override
  public String remedy(FittedValues values) {
    return text("change the obstacle's turn_deg by %+.1f", values.value("turn_deg"));
  }

  @Override
  public Set<Trait> traits() {
    return Set.of(Trait.SOAKS_UP_PLACEMENTS);
  }
}
