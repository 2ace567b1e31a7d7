package simbad.sonar.catalogue;

import java.util.List;
import java.util.Set;
import simbad.sonar.effect.Definition;
import simbad.sonar.effect.Effect;
import simbad.sonar.effect.FittedValues;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;
import simbad.sonar.effect.OdometryScale;
import simbad.sonar.effect.Parameter;
import simbad.sonar.effect.PathScale;
import simbad.sonar.effect.PingLog;
import simbad.sonar.effect.Probe;
import simbad.sonar.effect.Trait;
import simbad.sonar.scene.SensingSetup;

/** The distances travelled are believed too long or too short. */
public final class OdometryScaleEffect implements Definition {
  @Override
  public Effect effect() {
    return Effect.ODOMETRY_SCALE;
  }

  @Override
  public String happens() {
    return "distances travelled are believed too long or too short";
  }

  @Override
  public String cause() {
    return "a wheel diameter or a step length that is wrong, slip";
  }

  @Override
  public List<Form> forms(SensingSetup setup, List<String> sensors) {
    return List.of(
        Form.of(
            effect(),
            "path",
            v -> new OdometryScale(v[0]),
            Parameter.of("factor", 1, 0.5, 1.6, 0.9, 0.96, 1.04, 1.1)),
        Form.of(
            effect(),
            "along",
            v -> new PathScale(v[0]),
            Parameter.of("factor", 1, 0.5, 1, 0.86, 0.9, 0.94, 0.98)));
  }

  /** 2 % of the path. */
  @Override
  public List<Probe> probes(SensingSetup setup, PingLog log) {
    return List.of(
        Probe.alone(Forms.find(effect(), "path", setup, log.sensors()).orElseThrow(), 0, 0.02));
  }

  @Override
  public String remedy(FittedValues values) {
    return "calibrate the odometry's way: it is off by a factor";
  }

  @Override
  public Set<Trait> traits() {
    return Set.of(Trait.SOAKS_UP_PLACEMENTS);
  }
}
