package simbad.kernel.belt;

import simbad.kernel.geometry.Placement;
import simbad.kernel.scene.Ball;
import simbad.sonar.check.Checks;
import simbad.sonar.sensing.TransducerPoses;

/**
 * Where the rays of a belt start, point and end, in the belt's own frame. Immutable.
 *
 * <p>Each ray has an angle that says which side of the belt it looks to; sector means go by it.
 */
public final class BeltLayout {
  private static final int STRIDE = 6;

  /** Room for rounding in the reach of a belt. */
  private static final double MARGIN_M = 1e-6;

  private final double[] rays;
  private final double[] lengthM;
  private final double[] angleRad;
  private double reachM;

  private BeltLayout(int size) {
    rays = new double[size * STRIDE];
    lengthM = new double[size];
    angleRad = new double[size];
  }

  /**
   * Creates a ring of rays that look outwards, evenly spread, the first along +x and the others
   * counter-clockwise.
   *
   * <p>A ray ends on the circle of radius plus range, and that sum is rounded to single precision
   * as it always was: an obstacle within a ten-millionth of the full range is not heard.
   *
   * @param radiusM radius of the circle on which the rays start, metres
   * @param maxRangeM greatest range, metres from that circle
   * @param size number of rays; at least 0
   */
  public static BeltLayout ring(float radiusM, float maxRangeM, int size) {
    Checks.number("radiusM", radiusM);
    Checks.number("maxRangeM", maxRangeM);
    BeltLayout layout = new BeltLayout(size);
    double endM = radiusM + maxRangeM;
    for (int i = 0; i < size; i++) {
      double angle = i * (2 * Math.PI) / size;
      double x = Math.cos(angle);
      double z = -Math.sin(angle);
      layout.setRay(i, new double[] {x * radiusM, 0, z * radiusM}, new double[] {x, 0, z});
      layout.lengthM[i] = endM - radiusM;
      layout.angleRad[i] = angle;
    }
    layout.measureReach();
    return layout;
  }

  /**
   * Creates a layout from points and vectors.
   *
   * <p>The angle of a ray is the unsigned one between +x and its starting point, in [0, pi]: rays
   * on the right count as on the left. Old programs rely on it.
   *
   * @param positions starting points, metres, each x, y, z
   * @param directions way from each starting point to the ray's end, metres; none of length 0
   */
  public static BeltLayout of(double[][] positions, double[][] directions) {
    if (positions.length != directions.length) {
      throw new IllegalArgumentException(
          "directions = "
              + directions.length
              + " are not as many as positions, "
              + positions.length);
    }
    Checks.numbers("positions", positions);
    Checks.numbers("directions", directions);
    BeltLayout layout = new BeltLayout(positions.length);
    for (int i = 0; i < positions.length; i++) {
      layout.lengthM[i] = norm(directions[i]);
      layout.setRay(i, positions[i], unit(directions[i]));
      layout.angleRad[i] = angleToX(positions[i]);
    }
    layout.measureReach();
    return layout;
  }

  private static double norm(double[] v) {
    return Math.sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  }

  private static double[] unit(double[] v) {
    double norm = norm(v);
    if (!(norm > 0)) {
      throw new IllegalArgumentException("length of a direction = " + norm + " is not above 0");
    }
    return new double[] {v[0] / norm, v[1] / norm, v[2] / norm};
  }

  private static double angleToX(double[] v) {
    return Math.atan2(Math.hypot(v[1], v[2]), v[0]);
  }

  private void setRay(int ray, double[] position, double[] direction) {
    System.arraycopy(position, 0, rays, ray * STRIDE, 3);
    System.arraycopy(direction, 0, rays, ray * STRIDE + 3, 3);
  }

  /** Returns the number of rays. */
  public int size() {
    return lengthM.length;
  }

  /** Returns the length of a ray in metres. */
  public double lengthM(int ray) {
    return lengthM[ray];
  }

  /** Returns the length of the longest ray in metres; 0 if there is none. */
  public double longestM() {
    double longest = 0;
    for (double length : lengthM) {
      longest = Math.max(longest, length);
    }
    return longest;
  }

  /** Returns the angle by which a ray is sorted into sectors, radians in [0, 2 pi). */
  public double angleRad(int ray) {
    return angleRad[ray];
  }

  /** Finds how far the ends of the rays are from the middle between two opposite starts. */
  private void measureReach() {
    TransducerPoses poses = new TransducerPoses(size());
    place(new Placement(), poses);
    Ball middle = new Ball();
    enclose(poses, middle);
    for (int i = 0; i < size(); i++) {
      double x = poses.xM(i) - middle.xM();
      double y = poses.yM(i) - middle.yM();
      double z = poses.zM(i) - middle.zM();
      double endX = x + lengthM[i] * poses.directionX(i);
      double endY = y + lengthM[i] * poses.directionY(i);
      double endZ = z + lengthM[i] * poses.directionZ(i);
      reachM = Math.max(reachM, norm(new double[] {x, y, z}));
      reachM = Math.max(reachM, norm(new double[] {endX, endY, endZ}));
    }
    reachM += MARGIN_M;
  }

  /**
   * Sets a ball so that it holds every ray; a layout without rays leaves it as it is.
   *
   * @param poses where {@link #place} has put the rays
   * @param ball is set
   */
  public void enclose(TransducerPoses poses, Ball ball) {
    if (size() > 0) {
      int opposite = size() / 2;
      ball.set(
          (poses.xM(0) + poses.xM(opposite)) / 2,
          (poses.yM(0) + poses.yM(opposite)) / 2,
          (poses.zM(0) + poses.zM(opposite)) / 2,
          reachM);
    }
  }

  /** Places every ray of a belt in the world. */
  public void place(Placement worldFromBelt, TransducerPoses poses) {
    for (int i = 0; i < size(); i++) {
      int at = i * STRIDE;
      placeStart(worldFromBelt, poses, i, at);
      placeDirection(worldFromBelt, poses, i, at + 3);
    }
  }

  private void placeStart(Placement placement, TransducerPoses poses, int ray, int at) {
    double x = rays[at];
    double y = rays[at + 1];
    double z = rays[at + 2];
    poses.setPosition(
        ray, placement.outerX(x, y, z), placement.outerY(x, y, z), placement.outerZ(x, y, z));
  }

  private void placeDirection(Placement placement, TransducerPoses poses, int ray, int at) {
    double x = rays[at];
    double y = rays[at + 1];
    double z = rays[at + 2];
    poses.setDirection(
        ray, placement.turnedX(x, y, z), placement.turnedY(x, y, z), placement.turnedZ(x, y, z));
  }
}
