package simbad.obstacles;

/** The bodies of two obstacles of one world would lie in each other: who made it can mend it. */
public final class ObstacleOverlapException extends IllegalArgumentException {
  private static final long serialVersionUID = 1;

  ObstacleOverlapException(SonarObstacle entering, SonarObstacle standing) {
    super(entering + " overlaps " + standing);
  }
}
