package simbad.sonar.change;

import java.util.Optional;
import simbad.sonar.check.Checks;
import simbad.sonar.frame.Angles;
import simbad.sonar.frame.Placement;
import simbad.sonar.ping.Geometry;
import simbad.sonar.ping.LevelChange;
import simbad.sonar.ping.LevelEars;
import simbad.sonar.ping.ObstacleChange;
import simbad.sonar.ping.OutlineLevels;
import simbad.sonar.ping.SceneChange;
import simbad.sonar.ping.Scenes;
import simbad.sonar.scene.Scene;

/**
 * An obstacle has another outline than believed, and answers as that one does: stronger or weaker
 * than it by as much as the two outlines' echoes differ. Under the level law.
 *
 * @param only label of the obstacle; empty for all
 * @param believed outline of it, which its strength is that of
 * @param real outline; the same one, not turned, is neutral
 * @param turnRad by which the real one is turned in the obstacle's frame, counter-clockwise seen
 *     from above
 */
public record OtherOutline(
    Optional<String> only, OutlineLevels believed, OutlineLevels real, double turnRad)
    implements SceneChange, LevelChange, ObstacleChange {
  /** How far the integral is off: of 0, 1.5 and 3 dB, drawn worlds are likeliest with this. */
  private static final double UNSURE_DB = 1.5;

  /** Checks the turn; NaN is refused. */
  public OtherOutline {
    Checks.finite("turnRad", turnRad);
  }

  @Override
  public Scene apply(Scene scene) {
    Placement turned = Placement.IDENTITY.turned(turnRad);
    return Scenes.shaped(
        scene, only, outline -> turnRad == 0 ? real.outline() : real.outline().placed(turned));
  }

  @Override
  public double addedDb(LevelEars ears, Geometry geometry, int line) {
    return isAbout(geometry, line)
        ? strongerDb(geometry.bearingRad(line), geometry.centreDistanceM(line))
        : 0;
  }

  @Override
  public double deviationDb(Geometry geometry, int line) {
    return real.equals(believed) || !isAbout(geometry, line) ? 0 : UNSURE_DB;
  }

  private boolean isAbout(Geometry geometry, int line) {
    return only.isEmpty() || only.get().equals(geometry.label(line));
  }

  /**
   * Returns by how much it answers more strongly than believed.
   *
   * @param bearingRad of the sensor in the obstacle's frame, in [0, 2 pi)
   * @param distanceM from the sensor to the obstacle's centre, positive
   * @return decibels
   */
  public double strongerDb(double bearingRad, double distanceM) {
    return real.levelDb(Angles.positive(bearingRad - turnRad), distanceM)
        - believed.levelDb(bearingRad, distanceM);
  }
}
