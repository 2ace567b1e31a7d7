package simbad.sonar.effect;

import simbad.sonar.scene.SonarSpec;

/** The sensor's figures are not what they are believed to be. */
@FunctionalInterface
public non-sealed interface SensorChange extends Change {
  /** The cone, unless an implementation says that it leaves it as it is. */
  @Override
  default boolean changesGeometry() {
    return true;
  }

  /** Returns the figures as they are. */
  SonarSpec apply(SonarSpec believed);
}
