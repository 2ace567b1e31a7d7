package simbad.sonar.scene;

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
    if (!(noEchoM > 0 && noEchoM < Double.POSITIVE_INFINITY)) {
      throw new IllegalArgumentException("noEchoM = " + noEchoM + " is not in (0, infinity)");
    }
  }

  /** Creates one that says nothing beside. */
  public SensingSetup(SonarSpec sensor, Scene scene, double noEchoM) {
    this(sensor, scene, noEchoM, SetupDetails.NONE);
  }
}
