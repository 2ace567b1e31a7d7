package simbad.sonar.catalogue;

import static java.lang.Math.toRadians;
import static simbad.sonar.effect.FittedValues.text;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import simbad.definition.Effect;
import simbad.definition.Parameter;
import simbad.definition.Trait;
import simbad.sonar.change.BeamMisalignment;
import simbad.sonar.effect.Clues;
import simbad.sonar.effect.Definition;
import simbad.sonar.effect.FittedValues;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;
import simbad.sonar.effect.LogDesign;
import simbad.sonar.effect.Probe;
import simbad.sonar.frame.Placement;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.SensingSetup;

/** The sensor looks to one side of its believed heading. */
public final class BeamMisalignmentEffect implements Definition {
  private static final String ALL = "all";
  private static final String ONLY = "only:";

  @Override
  public Effect effect() {
    return Effect.BEAM_MISALIGNMENT;
  }

  @Override
  public String happens() {
    return "a sensor looks to one side of its believed heading";
  }

  @Override
  public String briefly() {
    return "the sensor looks to one side of its heading";
  }

  @Override
  public String cause() {
    return "a sensor that was mounted at an angle or knocked aside";
  }

  @Override
  public List<Form> forms(SensingSetup setup, List<String> sensors) {
    List<Form> forms = new ArrayList<>(List.of(turned(ALL, Optional.empty())));
    if (sensors.size() > 1) {
      sensors.forEach(sensor -> forms.add(turned(ONLY + sensor, Optional.of(sensor))));
    }
    return forms;
  }

  private Form turned(String name, Optional<String> sensor) {
    return Form.of(
        effect(),
        name,
        v -> new BeamMisalignment(toRadians(v[0]), sensor),
        Parameter.of("turn_deg", 0, -30, 30, -12, -6, -3, 3, 6, 12));
  }

  @Override
  public Optional<double[]> whereHeard(Form form, Clues.HeardArc arc) {
    return form.name().equals(ALL)
        ? Optional.of(new double[] {-Math.toDegrees(arc.turnRad())})
        : Optional.empty();
  }

  /** An axis that is a degree off. */
  @Override
  public List<Probe> probes(SensingSetup setup, PingLog log) {
    return List.of(
        Probe.alone(Forms.find(effect(), ALL, setup, log.sensors()).orElseThrow(), 0, 1));
  }

  /** Where the readings carry the robot's pose, the mounts of its sensors say how they look. */
  @Override
  public Optional<SensingSetup> corrected(SensingSetup stated, Form form, double... values) {
    Map<String, Placement> mounts = new LinkedHashMap<>(stated.details().robotFromSensor());
    boolean all = form.name().equals(ALL);
    mounts.replaceAll(
        (sensor, mount) ->
            all || form.name().equals(ONLY + sensor) ? mount.turned(toRadians(values[0])) : mount);
    return mounts.equals(stated.details().robotFromSensor())
        ? Optional.empty()
        : Optional.of(stated.with(stated.details().mounted(mounts)));
  }

  /** A quarter of a degree on a protractor. */
  @Override
  public boolean isWithinDays(Form form, double... values) {
    return Math.abs(values[0] - form.neutral()[0]) < 0.5;
  }

  @Override
  public String remedy(FittedValues values) {
    double degrees = values.value("turn_deg");
    return values.has("turn_deg")
        ? text(
            "turn the sensor %.1f degrees to the %s",
            Math.abs(degrees), degrees > 0 ? "right" : "left")
        : "straighten the sensor that looks to one side";
  }

  @Override
  public Set<Effect> twins(LogDesign log) {
    return log.isOneBearing() ? Set.of(Effect.OBSTACLE_OFFSET) : Set.of();
  }

  @Override
  public Set<Trait> traits() {
    return Set.of(Trait.SOAKS_UP_PLACEMENTS);
  }
}
