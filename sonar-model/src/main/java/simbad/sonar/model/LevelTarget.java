package simbad.sonar.model;

import simbad.sonar.level.Decibels;
import simbad.sonar.level.LevelLaw;
import simbad.sonar.level.TargetStrength;
import simbad.sonar.scene.Detection;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.StrengthDetection;
import simbad.sonar.scene.UniformDetection;

/** A placed obstacle with its target strength. Immutable. */
final class LevelTarget extends PlacedObstacle {
  private final TargetStrength strength;
  private final double greatestEnergy;

  LevelTarget(Obstacle obstacle, TargetStrength strength, LevelLaw law) {
    super(obstacle);
    this.strength = strength;
    greatestEnergy =
        Decibels.energy(law.levelDb() + strength.greatestDb()) * law.beam().greatestEnergy();
  }

  /** What an obstacle's detection says of its strength under the law that the scene believes. */
  static TargetStrength strength(Detection detection, LevelLaw believed) {
    if (detection instanceof StrengthDetection stated) {
      return stated.strength();
    }
    if (detection instanceof UniformDetection uniform) {
      return TargetStrength.uniform(believed.strengthDb(uniform.rangeM()));
    }
    return TargetStrength.ofThresholds(detection.findTable().orElseThrow(), believed);
  }

  TargetStrength strength() {
    return strength;
  }

  /** The same obstacle, of the same strength, under another law. */
  LevelTarget heardBy(LevelLaw law) {
    return new LevelTarget(obstacle(), strength, law);
  }

  /** No echo's energy exceeds this, at 1 m, without loss and over a threshold of 0 dB. */
  double greatestEnergy() {
    return greatestEnergy;
  }

  /** The energy of its echo over the threshold's, were it at the axis of a piston. */
  double axisEnergy(LevelLaw law, double xM, double zM, double centreDistanceM) {
    return law.axisEnergy(strength.strengthDb(bearingRad(xM, zM)), centreDistanceM);
  }
}
