package simbad.sonar.catalogue;

import static java.lang.Math.toRadians;

import java.util.List;
import java.util.Set;
import simbad.sonar.effect.Definition;
import simbad.sonar.effect.Effect;
import simbad.sonar.effect.FittedValues;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;
import simbad.sonar.effect.HeadingDrift;
import simbad.sonar.effect.HeadingDriftByWay;
import simbad.sonar.effect.Parameter;
import simbad.sonar.effect.PingLog;
import simbad.sonar.effect.Probe;
import simbad.sonar.effect.Trait;
import simbad.sonar.scene.SensingSetup;

/** The believed heading drifts. */
public final class HeadingDriftEffect implements Definition {
  private static final Parameter DRIFT =
      Parameter.of("rate_deg_s", 0, -5, 5, -1, -0.3, -0.1, 0.1, 0.3, 1);

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

  @Override
  public List<Form> forms(SensingSetup setup, List<String> sensors) {
    return List.of(
        Form.of(effect(), "heading", v -> new HeadingDrift(toRadians(v[0]), false), DRIFT),
        Form.of(effect(), "reckoned", v -> new HeadingDrift(toRadians(v[0]), true), DRIFT),
        Form.of(
            effect(),
            "settling",
            v -> new HeadingDrift(toRadians(v[0] / v[1]), v[1], false),
            Parameter.of("turn_deg", 0, -60, 60, -15, -5, 5, 15),
            Parameter.of("settling_s", 10, 0.1, 1000, 1, 10, 40).asClosed()),
        Form.of(
            effect(),
            "way",
            v -> new HeadingDriftByWay(toRadians(v[0])),
            Parameter.of("rate_deg_m", 0, -60, 60, -8, -3, -1, 1, 3, 8)));
  }

  /** A degree in ten seconds. */
  @Override
  public List<Probe> probes(SensingSetup setup, PingLog log) {
    return List.of(
        Probe.alone(Forms.find(effect(), "heading", setup, log.sensors()).orElseThrow(), 0, 0.1));
  }

  @Override
  public String remedy(FittedValues values) {
    return "correct the heading's drift, or reset it from time to time";
  }

  @Override
  public Set<Trait> traits() {
    return Set.of(Trait.SOAKS_UP_PLACEMENTS);
  }
}
