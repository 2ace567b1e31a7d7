package simbad.blindworld.world;

import simbad.blindworld.check.Checks;

/**
 * Where a transducer really listens.
 *
 * @param axisRad its axis beside the heading, counter-clockwise
 * @param halfAngleRad half the opening of the cone
 */
public record Beam(double axisRad, double halfAngleRad) {
  /** Refuses what is no such thing. */
  public Beam {
    Checks.finite("axis", axisRad);
    Checks.notNegative("half angle", halfAngleRad);
  }
}
