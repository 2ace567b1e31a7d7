package simbad.sonar.effect;

import simbad.sonar.level.LevelLaw;
import simbad.sonar.scene.SonarSpec;

/**
 * The sensor hears by the level law, not by thresholds: a calibration of the set-up.
 *
 * @param law by which it hears
 * @param squintRad by which its beam's axis lies counter-clockwise of its heading
 * @param missRate share of echoes that are lost whatever their strength, in [0, 1]
 */
public record LevelRule(LevelLaw law, double squintRad, double missRate) implements SensorChange {
  /** There is no cone: all before the baffle counts, and the beam says how much. */
  @Override
  public SonarSpec apply(SonarSpec believed) {
    return believed.withCone(Math.PI / 2).withScatter(0, missRate, 0);
  }
}
