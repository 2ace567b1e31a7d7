package simbad.scene3d;

import javax.media.j3d.Transform3D;
import javax.vecmath.Matrix3d;
import javax.vecmath.Point3d;
import javax.vecmath.Vector3d;

/**
 * Where the eye is and where it looks, relative to an anchor: the world's origin, or an agent that
 * the eye follows. Turning, panning and zooming go by a centre, which is a point in the anchor's
 * frame. Safe for use by several threads.
 */
public final class Viewpoint {
  /** Lowest elevation of the eye over its centre: a little below the floor's level. */
  private static final double LOWEST_RAD = Math.toRadians(-10);

  private static final double HIGHEST_RAD = Math.toRadians(90);
  private static final double NEAREST_M = 0.02;
  private static final double FARTHEST_M = 1000;

  private final Transform3D worldFromAnchor = new Transform3D();
  private final Transform3D anchorFromEye = new Transform3D();
  private final Point3d centre = new Point3d();
  private final Transform3D anchorFromHome = new Transform3D();
  private final Point3d homeCentre = new Point3d();

  /** Creates a viewpoint at the world's origin that looks along -z. */
  public Viewpoint() {}

  /**
   * Puts the eye at a point and lets it look at another one, which becomes the centre.
   *
   * @param eye metres, in the anchor's frame; not the centre
   * @param newCentre metres, in the anchor's frame
   * @param up direction that is up in the picture; not along the view
   */
  public synchronized void look(Point3d eye, Point3d newCentre, Vector3d up) {
    centre.set(newCentre);
    anchorFromEye.lookAt(eye, newCentre, up);
    anchorFromEye.invert();
    stayHere();
  }

  /** Takes a transform from the eye's frame to the anchor's as it is; the centre stays. */
  public synchronized void look(Transform3D newAnchorFromEye) {
    anchorFromEye.set(newAnchorFromEye);
    stayHere();
  }

  private void stayHere() {
    anchorFromHome.set(anchorFromEye);
    homeCentre.set(centre);
  }

  /** Goes back to where {@code look} put the eye last. */
  public synchronized void goHome() {
    anchorFromEye.set(anchorFromHome);
    centre.set(homeCentre);
  }

  /** Moves the centre, metres, in the anchor's frame; the eye stays. */
  public synchronized void setCentre(Point3d newCentre) {
    centre.set(newCentre);
  }

  /** Moves the anchor; the eye moves with it. */
  public synchronized void setAnchor(Transform3D newWorldFromAnchor) {
    worldFromAnchor.set(newWorldFromAnchor);
  }

  /** Writes where the eye is in the world. */
  public synchronized void get(Transform3D worldFromEye) {
    worldFromEye.mul(worldFromAnchor, anchorFromEye);
  }

  /**
   * Turns the eye round the centre.
   *
   * @param aboutVerticalRad counter-clockwise as seen from above
   * @param upwardsRad towards the top; it stops right above and a little below the centre
   */
  public synchronized void orbit(double aboutVerticalRad, double upwardsRad) {
    Matrix3d turn = new Matrix3d();
    anchorFromEye.get(turn);
    double elevation = elevationRad(turn);
    double wanted = Math.max(LOWEST_RAD, Math.min(HIGHEST_RAD, elevation + upwardsRad));
    Vector3d right = new Vector3d(turn.m00, turn.m10, turn.m20);
    Transform3D lift = aboutCentre(right, elevation - wanted);
    Transform3D swing = aboutCentre(new Vector3d(0, 1, 0), aboutVerticalRad);
    anchorFromEye.mul(lift, anchorFromEye);
    anchorFromEye.mul(swing, anchorFromEye);
    anchorFromEye.normalize();
  }

  /** How high the eye stands over what it looks at: pi/2 looks straight down. */
  private static double elevationRad(Matrix3d turn) {
    return Math.asin(Math.max(-1, Math.min(1, turn.m12)));
  }

  private Transform3D aboutCentre(Vector3d axis, double angleRad) {
    Transform3D turn = new Transform3D();
    turn.set(new javax.vecmath.AxisAngle4d(axis, angleRad));
    Point3d turned = new Point3d(centre);
    turn.transform(turned);
    turn.setTranslation(
        new Vector3d(centre.x - turned.x, centre.y - turned.y, centre.z - turned.z));
    return turn;
  }

  /**
   * Moves eye and centre across the view.
   *
   * @param right share of the distance to the centre
   * @param up share of the distance to the centre
   */
  public synchronized void pan(double right, double up) {
    double distanceM = distanceM();
    Vector3d shift = new Vector3d(right * distanceM, up * distanceM, 0);
    anchorFromEye.transform(shift);
    centre.add(shift);
    moveEyeBy(shift);
  }

  /** Multiplies the distance between eye and centre by a factor above 0, within 2 cm to 1 km. */
  public synchronized void zoom(double factor) {
    double distanceM = distanceM();
    double wanted = Math.max(NEAREST_M, Math.min(FARTHEST_M, distanceM * factor));
    Vector3d shift = new Vector3d(0, 0, wanted - distanceM);
    anchorFromEye.transform(shift);
    moveEyeBy(shift);
  }

  /** Returns how far the eye is from the centre, metres. */
  public synchronized double distanceM() {
    return centre.distance(eye());
  }

  private Point3d eye() {
    Point3d eye = new Point3d();
    anchorFromEye.transform(eye);
    return eye;
  }

  private void moveEyeBy(Vector3d shift) {
    Vector3d moved = new Vector3d(eye());
    moved.add(shift);
    anchorFromEye.setTranslation(moved);
  }
}
