package simbad.sonar.catalogue;

import static simbad.sonar.effect.FittedValues.text;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import simbad.definition.Effect;
import simbad.definition.Parameter;
import simbad.definition.Trait;
import simbad.sonar.change.OdometryScale;
import simbad.sonar.change.PathScale;
import simbad.sonar.change.Reckoning;
import simbad.sonar.effect.Definition;
import simbad.sonar.effect.FittedValues;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Probe;
import simbad.sonar.frame.Placement;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.SensingSetup;

/** The distances travelled are believed too long or too short. */
public final class OdometryScaleEffect implements Definition {
  private static final String SPEED = "speed-scale";
  private static final String WHEELS = "wheel-scale";

  @Override
  public Effect effect() {
    return Effect.ODOMETRY_SCALE;
  }

  @Override
  public String happens() {
    return "the robot believes that it travels farther, or less far, than it does";
  }

  @Override
  public String cause() {
    return "a wrong wheel diameter or step length, slip";
  }

  /** Where readings carry a robot's pose, that was reckoned, and the sensors are on the robot. */
  @Override
  public List<Form> forms(SensingSetup setup, List<String> sensors) {
    Map<String, Placement> mounts = setup.details().robotFromSensor();
    Form along =
        Form.of(
            effect(),
            "along",
            v -> new PathScale(v[0]),
            Parameter.of("factor", 1, 0.5, 1, 0.86, 0.9, 0.94, 0.98));
    return mounts.isEmpty()
        ? List.of(Form.of(effect(), "path", v -> new OdometryScale(v[0]), factor("factor")), along)
        : List.of(
            Form.of(
                effect(), SPEED, v -> new Reckoning(v[0], 1, 0, 0, mounts), factor("speed_factor")),
            Form.of(
                effect(),
                WHEELS,
                v -> new Reckoning(v[0], v[0], 0, 0, mounts),
                factor("wheel_factor")),
            along);
  }

  private static Parameter factor(String name) {
    return Parameter.of(name, 1, 0.5, 1.6, 0.9, 0.96, 1.04, 1.1);
  }

  @Override
  public Optional<String> seenInMotion(Form form) {
    return Optional.of(form.name()).filter(List.of(SPEED, WHEELS)::contains);
  }

  /** 2 % of the path. */
  @Override
  public List<Probe> probes(SensingSetup setup, PingLog log) {
    return List.of(Probe.alone(forms(setup, log.sensors()).get(0), 0, 0.02));
  }

  @Override
  public String remedy(FittedValues values) {
    double factor =
        Stream.of("factor", "speed_factor", "wheel_factor")
            .filter(values::has)
            .mapToDouble(values::value)
            .findFirst()
            .orElseThrow();
    return text("calibrate the odometry: multiply the way that it reckons by %.3f", factor);
  }

  @Override
  public Set<Trait> traits() {
    return Set.of(Trait.SOAKS_UP_PLACEMENTS);
  }
}
