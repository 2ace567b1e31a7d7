package simbad.sonar.scene;

import java.util.Optional;
import simbad.sonar.check.Checks;

/**
 * A sensor before a scene, as a scene file states it.
 *
 * @param sensor the sensor's figures
 * @param scene the obstacles
 * @param noEchoM the range that a no-echo counts as where ranges are averaged; positive, finite
 * @param details what is said beside that
 */
public record SensingSetup(SonarSpec sensor, Scene scene, double noEchoM, SetupDetails details) {
  /** Checks the no-echo range. */
  public SensingSetup {
    Checks.positive("noEchoM", noEchoM);
  }

  /** Creates one that says nothing beside. */
  public SensingSetup(SonarSpec sensor, Scene scene, double noEchoM) {
    this(sensor, scene, noEchoM, SetupDetails.NONE);
  }

  /** Returns the same set-up with another sensor. */
  public SensingSetup with(SonarSpec other) {
    return new SensingSetup(other, scene, noEchoM, details);
  }

  /** Returns the same set-up with other obstacles. */
  public SensingSetup with(Scene other) {
    return new SensingSetup(sensor, other, noEchoM, details);
  }

  /** Returns the same set-up with other details. */
  public SensingSetup with(SetupDetails other) {
    return new SensingSetup(sensor, scene, noEchoM, other);
  }

  /** Returns the same set-up, believed to hear by a law. */
  public SensingSetup under(SensorLaw.Model model) {
    SensorLaw law = new SensorLaw(Optional.of(model), sensor.law().level());
    return with(sensor.withLaw(law));
  }
}
