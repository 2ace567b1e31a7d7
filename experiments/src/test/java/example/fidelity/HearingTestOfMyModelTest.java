package example.fidelity;

import java.util.List;
import simbad.experiments.fidelity.FidelityLimits;
import simbad.experiments.fidelity.FidelitySuite;
import simbad.obstacles.Catalogue;
import simbad.obstacles.ObstacleType;
import simbad.sonar.model.DetectionRule;
import simbad.sonar.model.SensorModel;
import simbad.sonar.scene.SonarSpec;

/** The suite as a third party has it: from a package of its own, every choice overridden. */
class HearingTestOfMyModelTest extends FidelitySuite {
  @Override
  protected SensorModel model() {
    return DetectionRule.SHADOW;
  }

  @Override
  protected List<ObstacleType> obstacles() {
    return List.of(Catalogue.find("hexagon").orElseThrow());
  }

  @Override
  protected SonarSpec sonar() {
    return Catalogue.srf04();
  }

  @Override
  protected FidelityLimits limits() {
    return new FidelityLimits(0.95, 0.06, 0.02, 0);
  }
}
