package simbad.experiments.fidelity;

import simbad.sonar.model.DetectionRule;
import simbad.sonar.model.SensorModel;

/** The suite as its users have it, with the model that it was made for. */
class ShadowFidelityTest extends FidelitySuite {
  @Override
  protected SensorModel model() {
    return DetectionRule.SHADOW;
  }
}
