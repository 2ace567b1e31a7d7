package simbad.sonar.change;

import java.util.Optional;
import simbad.sonar.check.Checks;
import simbad.sonar.ping.EchoChange;
import simbad.sonar.ping.Geometry;
import simbad.sonar.ping.ObstacleChange;

/**
 * A plate mirrors sound: it answers well square to its two faces only. Across the border the chance
 * of an echo falls as a logistic curve, down to what edges and roughness send back everywhere.
 *
 * @param only label of the one obstacle that is a plate; empty for all
 * @param faceRad bearing of a face's normal, in the obstacle's frame; the other face is opposite
 * @param halfAngleRad from the normal to where half of the fall is done, radians, at least 0
 * @param softRad the angle over which the chance falls from 1/2 to 1/(1+e), radians, above 0
 * @param floor what the chance falls to, in [0, 1]; 1 is neutral
 */
public record FaceLobe(
    Optional<String> only, double faceRad, double halfAngleRad, double softRad, double floor)
    implements EchoChange, ObstacleChange {
  /** Checks the figures; NaN is refused. */
  public FaceLobe {
    Checks.finite("faceRad", faceRad);
    Checks.notNegative("halfAngleRad", halfAngleRad);
    Checks.positive("softRad", softRad);
    Checks.share("floor", floor);
  }

  @Override
  public double share(Geometry geometry, int line) {
    if (only.isPresent() && !only.get().equals(geometry.label(line))) {
      return 1;
    }
    double sin =
        geometry.bearingSin(line) * Math.cos(faceRad)
            - geometry.bearingCos(line) * Math.sin(faceRad);
    double aside = Math.asin(Math.min(1, Math.abs(sin)));
    return floor + (1 - floor) / (1 + Math.exp((aside - halfAngleRad) / softRad));
  }
}
