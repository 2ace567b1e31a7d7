package simbad.sonar.ping;

import java.util.List;
import simbad.sonar.frame.Angles;
import simbad.sonar.frame.Placement;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.shape.Outline;

/** Angles from the heading of a ping to an obstacle, radians, positive counter-clockwise. */
final class OffAxis {
  private static final double SAME_POINT_M = 1e-9;
  private static final double SAME_ANGLE_RAD = 1e-9;

  private final Geometry geometry;
  private final int obstacles;
  private final List<Outline> outlines;
  private final double[] longestEdgeM;

  OffAxis(Geometry geometry) {
    this.geometry = geometry;
    outlines = geometry.scene().obstacles().stream().map(Obstacle::worldOutline).toList();
    obstacles = outlines.size();
    longestEdgeM = outlines.stream().mapToDouble(Outline::longestEdgeM).toArray();
  }

  /** To the obstacle's centre, in [-pi, pi]. */
  double ofCentre(int line) {
    Placement place = geometry.scene().obstacles().get(line % obstacles).worldFromObstacle();
    return of(line / obstacles, place.xM(), place.zM());
  }

  /**
   * To the point of the obstacle that is nearest in the cone; the cone's half angle where none is.
   */
  double ofNearest(int line) {
    int ping = line / obstacles;
    Outline outline = outlines.get(line % obstacles);
    if (geometry.nearestM(line) == Double.POSITIVE_INFINITY) {
      return geometry.coneHalfAngleRad();
    }
    // An edge of which a corner lies further off than this and its length has no point so near.
    double far = geometry.nearestM(line) + SAME_POINT_M + longestEdgeM[line % obstacles];
    int from = outline.size() - 1;
    for (int to = 0; to < outline.size(); to++) {
      double cornerX = outline.xM(to) - geometry.xM(ping);
      double cornerZ = outline.zM(to) - geometry.zM(ping);
      if (cornerX * cornerX + cornerZ * cornerZ <= far * far) {
        double offAxis = ofNearest(line, from, to);
        if (!Double.isNaN(offAxis)) {
          return offAxis;
        }
      }
      from = to;
    }
    // Neither a corner nor the foot of a perpendicular: where the outline leaves the cone.
    return geometry.coneHalfAngleRad();
  }

  /** Of the nearest point of an edge; NaN where it is not the obstacle's nearest in the cone. */
  private double ofNearest(int line, int from, int to) {
    int ping = line / obstacles;
    Outline outline = outlines.get(line % obstacles);
    double edgeX = outline.xM(to) - outline.xM(from);
    double edgeZ = outline.zM(to) - outline.zM(from);
    double towards =
        (geometry.xM(ping) - outline.xM(from)) * edgeX
            + (geometry.zM(ping) - outline.zM(from)) * edgeZ;
    double length2 = edgeX * edgeX + edgeZ * edgeZ;
    double share = length2 == 0 ? 0 : Math.max(0, Math.min(1, towards / length2));
    double x = outline.xM(from) + share * edgeX;
    double z = outline.zM(from) + share * edgeZ;
    double awayX = x - geometry.xM(ping);
    double awayZ = z - geometry.zM(ping);
    // A root, since hypot takes ten times as long and this is asked of every edge.
    double away = Math.sqrt(awayX * awayX + awayZ * awayZ);
    if (Math.abs(away - geometry.nearestM(line)) > SAME_POINT_M) {
      return Double.NaN;
    }
    double offAxis = of(ping, x, z);
    return Math.abs(offAxis) <= geometry.coneHalfAngleRad() + SAME_ANGLE_RAD ? offAxis : Double.NaN;
  }

  /** The least to any point of the obstacle's outline, in [0, pi]; 0 where the axis meets it. */
  double ofOutline(int line) {
    int ping = line / obstacles;
    Outline outline = outlines.get(line % obstacles);
    double least = Math.PI;
    double from = ofCorner(ping, outline, outline.size() - 1);
    for (int i = 0; i < outline.size(); i++) {
      double to = ofCorner(ping, outline, i);
      if (from * to <= 0 && Math.abs(from - to) < Math.PI) {
        return 0;
      }
      least = Math.min(least, Math.abs(to));
      from = to;
    }
    return least;
  }

  private double ofCorner(int ping, Outline outline, int corner) {
    return of(ping, outline.xM(corner), outline.zM(corner));
  }

  /** Of a place, from the heading. */
  private double of(int ping, double toXM, double toZM) {
    double direction = Math.atan2(geometry.zM(ping) - toZM, toXM - geometry.xM(ping));
    return Angles.signed(direction - geometry.headingRad(ping));
  }
}
