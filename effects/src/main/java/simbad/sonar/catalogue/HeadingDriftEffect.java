package simbad.sonar.catalogue;

import static java.lang.Math.toRadians;
import static simbad.sonar.effect.FittedValues.text;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import simbad.definition.Effect;
import simbad.definition.Parameter;
import simbad.definition.Trait;
import simbad.sonar.change.HeadingDrift;
import simbad.sonar.change.HeadingDriftByWay;
import simbad.sonar.change.Reckoning;
import simbad.sonar.effect.Definition;
import simbad.sonar.effect.FittedValues;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;
import simbad.sonar.effect.LogDesign;
import simbad.sonar.effect.Probe;
import simbad.sonar.frame.Placement;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.SensingSetup;

/** The believed heading drifts. */
public final class HeadingDriftEffect implements Definition {
  private static final String BIAS = "turn-bias";
  private static final String TURNS = "turn-scale";
  private static final String ASYMMETRY = "wheel-asymmetry";

  /** What has settled after the first pings is no drift: it is a sensor that looks aside. */
  private static final double LEAST_S = 2;

  private static final Parameter DRIFT =
      Parameter.of("rate_deg_s", 0, -5, 5, -1, -0.3, -0.1, 0.1, 0.3, 1);

  /** How much it is by the parameter that tells it; a form has one of them. */
  private static final Map<String, String> IN_WORDS =
      Map.of(
          "rate_deg_s", "true less believed heading is %+.3f degrees for each second",
          "rate_deg_m", "true less believed heading is %+.2f degrees for each metre",
          "turn_deg", "true less believed heading is %+.1f degrees in the end",
          "bias_rad_s", "true less believed heading is %+.4f rad for each second",
          "turn_factor", "it turns %.3f times as far as is believed",
          "turn_rad_per_m", "true less believed heading is %+.3f rad for each metre");

  @Override
  public Effect effect() {
    return Effect.HEADING_DRIFT;
  }

  @Override
  public String happens() {
    return "the believed heading drifts";
  }

  @Override
  public String briefly() {
    return "the believed heading drifts with time";
  }

  @Override
  public String cause() {
    return "a gyro that drifts, wheels of unequal size";
  }

  /** Where readings carry a robot's pose, that was reckoned, and the sensors are on the robot. */
  @Override
  public List<Form> forms(SensingSetup setup, List<String> sensors) {
    Map<String, Placement> mounts = setup.details().robotFromSensor();
    Form heading =
        Form.of(effect(), "heading", v -> new HeadingDrift(toRadians(v[0]), false), DRIFT);
    Form settling =
        Form.of(
            effect(),
            "settling",
            v -> new HeadingDrift(toRadians(v[0] / v[1]), v[1], false),
            Parameter.of("turn_deg", 0, -60, 60, -15, -5, 5, 15),
            Parameter.of("settling_s", 10, LEAST_S, 1000, 4, 10, 40).asClosed());
    Form way =
        Form.of(
            effect(),
            "way",
            v -> new HeadingDriftByWay(toRadians(v[0])),
            Parameter.of("rate_deg_m", 0, -60, 60, -8, -3, -1, 1, 3, 8));
    if (mounts.isEmpty()) {
      Form reckoned =
          Form.of(effect(), "reckoned", v -> new HeadingDrift(toRadians(v[0]), true), DRIFT);
      return List.of(heading, reckoned, settling, way);
    }
    return List.of(heading, bias(mounts), settling, way, turns(mounts), wheels(mounts));
  }

  private Form bias(Map<String, Placement> mounts) {
    return Form.of(
        effect(),
        BIAS,
        v -> new Reckoning(1, 1, v[0], 0, mounts),
        Parameter.of("bias_rad_s", 0, -0.1, 0.1, -0.02, -0.005, -0.002, 0.002, 0.005, 0.02));
  }

  private Form turns(Map<String, Placement> mounts) {
    return Form.of(
        effect(),
        TURNS,
        v -> new Reckoning(1, v[0], 0, 0, mounts),
        Parameter.of("turn_factor", 1, 0.5, 1.6, 0.9, 0.96, 1.04, 1.1));
  }

  private Form wheels(Map<String, Placement> mounts) {
    return Form.of(
        effect(),
        ASYMMETRY,
        v -> new Reckoning(1, 1, 0, v[0], mounts),
        Parameter.of("turn_rad_per_m", 0, -1, 1, -0.15, -0.05, -0.02, 0.02, 0.05, 0.15));
  }

  /** One look past one obstacle does not tell a turn that grew from one that was always there. */
  @Override
  public boolean canShow(Form form, LogDesign log) {
    return !log.isOnePass();
  }

  @Override
  public Optional<String> seenInMotion(Form form) {
    return Optional.of(form.name()).filter(List.of(BIAS, TURNS, ASYMMETRY)::contains);
  }

  /** A degree in ten seconds. */
  @Override
  public List<Probe> probes(SensingSetup setup, PingLog log) {
    return List.of(
        Probe.alone(Forms.find(effect(), "heading", setup, log.sensors()).orElseThrow(), 0, 0.1));
  }

  @Override
  public String remedy(FittedValues values) {
    String drift =
        IN_WORDS.entrySet().stream()
            .filter(entry -> values.has(entry.getKey()))
            .map(entry -> text(entry.getValue(), values.value(entry.getKey())))
            .findFirst()
            .orElseThrow();
    return text("correct the heading, or reset it from time to time: %s", drift);
  }

  @Override
  public Set<Trait> traits() {
    return Set.of(Trait.SOAKS_UP_PLACEMENTS);
  }
}
