package simbad.obstacles;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/**
 * The detection rule once more, from the csv file alone: nothing of the product is used here, no
 * reader, no frame, no geometry. All in the obstacle's own frame; angles counter-clockwise as seen
 * from above, z down the page.
 */
final class TableReference {
  private static final double HALF_ANGLE_RAD = Math.toRadians(27.5);
  private static final double MIN_RANGE_M = 0.03;
  private static final double MAX_RANGE_M = 6;

  /** A cone so much wider or narrower must not change the verdict, else it depends on rounding. */
  private static final double TINY_ANGLE_RAD = 1e-9;

  private static final double NONE = Double.POSITIVE_INFINITY;

  /** What the table says of a pose, and whether that depends on less than the test's margins. */
  record Verdict(double rangeM, boolean clear) {
    boolean echo() {
      return rangeM < NONE;
    }
  }

  private final double[] edgeX;
  private final double[] edgeZ;
  private final double[] bodyX;
  private final double[] bodyZ;

  /** A table's file and the cross-section as x, z, x, z ... in metres. */
  TableReference(Path csv, double... body) throws IOException {
    List<String> rows =
        Files.readAllLines(csv).stream().filter(line -> line.matches("[0-9].*")).toList();
    edgeX = new double[rows.size()];
    edgeZ = new double[rows.size()];
    for (int i = 0; i < rows.size(); i++) {
      int comma = rows.get(i).indexOf(',');
      double bearing = Math.toRadians(Double.parseDouble(rows.get(i).substring(0, comma)));
      double threshold = Double.parseDouble(rows.get(i).substring(comma + 1));
      edgeX[i] = threshold * Math.sin(bearing);
      edgeZ[i] = threshold * Math.cos(bearing);
    }
    bodyX = new double[body.length / 2];
    bodyZ = new double[body.length / 2];
    for (int i = 0; i < bodyX.length; i++) {
      bodyX[i] = body[2 * i];
      bodyZ[i] = body[2 * i + 1];
    }
  }

  int size() {
    return edgeX.length;
  }

  double greatestM() {
    double greatest = 0;
    for (int i = 0; i < edgeX.length; i++) {
      greatest = Math.max(greatest, Math.hypot(edgeX[i], edgeZ[i]));
    }
    return greatest;
  }

  /** How far the ray from the centre at a bearing runs until it meets the polygon. */
  double thresholdM(double bearingRad) {
    double dx = Math.sin(bearingRad);
    double dz = Math.cos(bearingRad);
    double reach = 0;
    for (int i = 0, j = edgeX.length - 1; i < edgeX.length; j = i++) {
      double ex = edgeX[i] - edgeX[j];
      double ez = edgeZ[i] - edgeZ[j];
      // s (dx, dz) = corner j + u (ex, ez), by Cramer's rule.
      double determinant = dz * ex - dx * ez;
      double s = (edgeZ[j] * ex - edgeX[j] * ez) / determinant;
      double u = (edgeZ[j] * dx - edgeX[j] * dz) / determinant;
      if (s >= 0 && u >= -1e-12 && u <= 1 + 1e-12) {
        reach = Math.max(reach, s);
      }
    }
    return reach;
  }

  /** Distance of a place from the polygon's line. */
  double edgeDistanceM(double x, double z) {
    double best = NONE;
    for (int i = 0, j = edgeX.length - 1; i < edgeX.length; j = i++) {
      double ex = edgeX[i] - edgeX[j];
      double ez = edgeZ[i] - edgeZ[j];
      double along = ((x - edgeX[j]) * ex + (z - edgeZ[j]) * ez) / (ex * ex + ez * ez);
      double t = Math.min(1, Math.max(0, along));
      best = Math.min(best, Math.hypot(x - edgeX[j] - t * ex, z - edgeZ[j] - t * ez));
    }
    return best;
  }

  /** The whole rule at a pose. */
  Verdict verdict(double x, double z, double headingRad) {
    double narrow = nearestInConeM(x, z, headingRad, HALF_ANGLE_RAD - TINY_ANGLE_RAD);
    double wide = nearestInConeM(x, z, headingRad, HALF_ANGLE_RAD + TINY_ANGLE_RAD);
    double nearest = nearestInConeM(x, z, headingRad, HALF_ANGLE_RAD);
    boolean sameCone = narrow == wide || narrow - wide < 1e-6;
    boolean inside = Math.hypot(x, z) <= thresholdM(Math.atan2(x, z));
    boolean inRange = nearest >= MIN_RANGE_M && nearest <= MAX_RANGE_M;
    boolean offLimits =
        Math.abs(nearest - MIN_RANGE_M) > 1e-6 && Math.abs(nearest - MAX_RANGE_M) > 1e-6;
    return new Verdict(
        inside && inRange ? nearest : NONE,
        sameCone && offLimits && edgeDistanceM(x, z) > DetectionMapReachTest.OFF_THE_EDGE_M);
  }

  /**
   * Nearest point of the cross-section's line within a half angle of the heading. Along a straight
   * piece the distance falls to the foot of the perpendicular and rises from there, so the nearest
   * is an end, the foot, or where a border of the cone cuts the piece.
   */
  double nearestInConeM(double x, double z, double headingRad, double halfAngleRad) {
    double best = NONE;
    for (int i = 0, j = bodyX.length - 1; i < bodyX.length; j = i++) {
      double ax = bodyX[j] - x;
      double az = bodyZ[j] - z;
      double ex = bodyX[i] - bodyX[j];
      double ez = bodyZ[i] - bodyZ[j];
      double[] places = {
        0,
        1,
        -(ax * ex + az * ez) / (ex * ex + ez * ez),
        borderAt(ax, az, ex, ez, headingRad + halfAngleRad),
        borderAt(ax, az, ex, ez, headingRad - halfAngleRad)
      };
      for (int k = 0; k < places.length; k++) {
        double px = ax + places[k] * ex;
        double pz = az + places[k] * ez;
        boolean onPiece = places[k] >= 0 && places[k] <= 1;
        if (onPiece
            && (isOnBorder(k, px, pz, headingRad) || within(px, pz, headingRad, halfAngleRad))) {
          best = Math.min(best, Math.hypot(px, pz));
        }
      }
    }
    return best;
  }

  /** Where along a piece the line through the sensor with a heading cuts it. */
  private static double borderAt(double ax, double az, double ex, double ez, double headingRad) {
    double dx = Math.cos(headingRad);
    double dz = -Math.sin(headingRad);
    return (az * dx - ax * dz) / (ex * dz - ez * dx);
  }

  /** A cut with a border lies within the cone by what it is, if it lies ahead and not behind. */
  private static boolean isOnBorder(int place, double px, double pz, double headingRad) {
    return place >= 3 && offAxisRad(px, pz, headingRad) < Math.PI / 2;
  }

  static boolean within(double px, double pz, double headingRad, double halfAngleRad) {
    return offAxisRad(px, pz, headingRad) <= halfAngleRad;
  }

  private static double offAxisRad(double px, double pz, double headingRad) {
    double off = Math.abs(Math.atan2(-pz, px) - headingRad) % (2 * Math.PI);
    return off > Math.PI ? 2 * Math.PI - off : off;
  }

  /** The nearest of many points along the cross-section's line that are within the cone. */
  double nearestOfManyM(double x, double z, double headingRad, int pointsPerPiece) {
    double best = NONE;
    for (int i = 0, j = bodyX.length - 1; i < bodyX.length; j = i++) {
      for (int k = 0; k <= pointsPerPiece; k++) {
        double t = k / (double) pointsPerPiece;
        double px = bodyX[j] + t * (bodyX[i] - bodyX[j]) - x;
        double pz = bodyZ[j] + t * (bodyZ[i] - bodyZ[j]) - z;
        if (within(px, pz, headingRad, HALF_ANGLE_RAD)) {
          best = Math.min(best, Math.hypot(px, pz));
        }
      }
    }
    return best;
  }

  double halfAngleRad() {
    return HALF_ANGLE_RAD;
  }
}
