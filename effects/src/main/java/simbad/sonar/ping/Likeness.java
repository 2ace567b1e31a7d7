package simbad.sonar.ping;

import java.util.List;
import java.util.Objects;
import simbad.sonar.scene.Obstacle;

/**
 * What a geometry has in common with a known one of the same log: a fit looks at the same obstacle
 * from the same places many times.
 */
final class Likeness {
  private final Geometry known;
  private final Geometry made;
  private final boolean cone;

  /** By obstacle: whether it is the same, and whether it is heard in the same way. */
  private final boolean[] stands;

  private final boolean[] sounds;

  /** Whether its echo comes from the same place. */
  private final boolean[] echoes;

  Likeness(Geometry known, Geometry made) {
    this.known = known;
    this.made = made;
    cone = known.coneHalfAngleRad() == made.coneHalfAngleRad();
    List<Obstacle> before = known.scene().obstacles();
    List<Obstacle> now = made.scene().obstacles();
    stands = new boolean[now.size()];
    sounds = new boolean[now.size()];
    echoes = new boolean[now.size()];
    LevelEars were = known.ears();
    LevelEars are = made.ears();
    for (int i = 0; i < stands.length; i++) {
      stands[i] = before.size() == now.size() && before.get(i).equals(now.get(i));
      echoes[i] = Objects.equals(LevelEars.near(were, i), LevelEars.near(are, i));
      sounds[i] = were != null && are != null && are.hearLike(were, i);
    }
  }

  /**
   * Takes over what a ping sees of an obstacle.
   *
   * @return whether all is known then that is not computed when it is asked for
   */
  boolean sees(int ping, int obstacle) {
    if (!stands[obstacle] || !isSame(known.xM(ping), made.xM(ping))) {
      return false;
    }
    if (!isSame(known.zM(ping), made.zM(ping))) {
      return false;
    }
    int line = ping * stands.length + obstacle;
    boolean heading = isSame(known.headingRad(ping), made.headingRad(ping));
    if (heading) {
      made.offAxisRad[line] = known.offAxisRad[line];
      made.outlineOffAxisRad[line] = known.outlineOffAxisRad[line];
    }
    if (heading && cone) {
      made.nearestM[line] = known.nearestM[line];
      takePlace(line);
      if (echoes[obstacle]) {
        made.echoOffAxisRad[line] = known.echoOffAxisRad[line];
      }
      if (sounds[obstacle]) {
        takeSound(line);
      }
      return true;
    }
    double nearest = made.nearestNowM(obstacle);
    boolean seen = nearest < Double.POSITIVE_INFINITY;
    if (seen != known.nearestM[line] < Double.POSITIVE_INFINITY) {
      return false;
    }
    made.nearestM[line] = nearest;
    takePlace(line);
    return true;
  }

  private static boolean isSame(double one, double other) {
    return Double.doubleToRawLongBits(one) == Double.doubleToRawLongBits(other);
  }

  /** What does not depend on where the sensor looks, as long as it sees something. */
  private void takePlace(int line) {
    made.centreDistanceM[line] = known.centreDistanceM[line];
    made.bearingRad[line] = known.bearingRad[line];
    made.bearingCos[line] = known.bearingCos[line];
    made.bearingSin[line] = known.bearingSin[line];
    made.thresholdM[line] = known.thresholdM[line];
  }

  private void takeSound(int line) {
    made.excessDb[line] = known.excessDb[line];
    made.excessDeviationDb[line] = known.excessDeviationDb[line];
    made.pathM[line] = known.pathM[line];
    made.pathDeviationM[line] = known.pathDeviationM[line];
  }
}
