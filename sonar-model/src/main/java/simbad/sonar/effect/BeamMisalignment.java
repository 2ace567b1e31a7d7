package simbad.sonar.effect;

import java.util.Optional;
import simbad.sonar.check.Checks;

/**
 * The sensor looks to one side of its believed heading.
 *
 * @param turnRad by which it is turned, counter-clockwise seen from above; 0 is neutral
 * @param only label of the one sensor that does; empty for all
 */
public record BeamMisalignment(double turnRad, Optional<String> only) implements PoseChange {
  /** Checks the figure; NaN is refused. */
  public BeamMisalignment {
    Checks.finite("turnRad", turnRad);
  }

  @Override
  public int order() {
    return 3;
  }

  @Override
  public Track start(String sensor, double runStartS) {
    return only.map(sensor::equals).orElse(true)
        ? (timeS, pose) -> pose.turn(turnRad)
        : Track.STILL;
  }
}
