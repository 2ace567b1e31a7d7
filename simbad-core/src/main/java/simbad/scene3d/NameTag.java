package simbad.scene3d;

import javax.media.j3d.BranchGroup;
import javax.media.j3d.Transform3D;
import javax.media.j3d.TransformGroup;
import javax.vecmath.Matrix3d;
import javax.vecmath.Point3d;
import javax.vecmath.Vector3d;
import simbad.sonar.check.Checks;

/** An agent's name beside it, upright in the picture and equally large at any distance. */
public final class NameTag implements Animated {
  /** Between the agent and its name. */
  private static final double GAP_PX = 4;

  /** So much of the way to the agent, where it looks the same: what is nearest is drawn last. */
  private static final double NEARER = 0.1;

  /** A transform must not flatten what it is applied to. */
  private static final double SMALLEST = 1e-6;

  private final Figure figure;
  private final double reachM;
  private final BranchGroup group = new BranchGroup();
  private final TransformGroup pose = new TransformGroup();
  private final Curtain curtain;
  private final Transform3D agent = new Transform3D();
  private final Transform3D wanted = new Transform3D();
  private final Transform3D shown = new Transform3D();
  private final Matrix3d turn = new Matrix3d();
  private boolean drawn = true;

  /**
   * Creates a tag; needs a display.
   *
   * @param name what it says
   * @param figure shows the agent, and is captured before this tag; followed
   * @param reachM how far the agent reaches from its middle, metres
   */
  public NameTag(String name, Figure figure, double reachM) {
    this.figure = figure;
    this.reachM = Checks.number("reachM", reachM);
    pose.setCapability(TransformGroup.ALLOW_TRANSFORM_WRITE);
    pose.addChild(TagShape.of(name));
    curtain = new Curtain(pose);
    group.addChild(curtain.node());
  }

  @Override
  public BranchGroup node() {
    return group;
  }

  @Override
  public void capture() {
    // The agent's figure captures where it is.
  }

  @Override
  public void show() {
    curtain.set(drawn && figure.isPresent());
  }

  @Override
  public void adopt(Look look) {
    drawn = look.draws(Layer.NAMES);
  }

  /**
   * Turns the tag to the eye.
   *
   * @param worldFromEye where the eye is
   * @param pixelShare width of a pixel of the picture at a distance of 1
   */
  void face(Transform3D worldFromEye, double pixelShare) {
    figure.get(agent);
    Vector3d place = new Vector3d();
    agent.get(place);
    worldFromEye.get(turn);
    Vector3d up = new Vector3d(turn.m01, turn.m11, turn.m21);
    double pixelM = Math.max(SMALLEST, pixelShare * distanceM(worldFromEye, place));
    place.scaleAdd(reachM + GAP_PX * pixelM, up, place);
    Vector3d eye = new Vector3d();
    worldFromEye.get(eye);
    place.interpolate(eye, place, NEARER);
    wanted.set(turn, place, NEARER * pixelM);
    if (!wanted.equals(shown)) {
      shown.set(wanted);
      pose.setTransform(wanted);
    }
  }

  /** How far ahead of the eye a place is. */
  private static double distanceM(Transform3D worldFromEye, Vector3d place) {
    Transform3D eyeFromWorld = new Transform3D();
    eyeFromWorld.invert(worldFromEye);
    Point3d seen = new Point3d(place);
    eyeFromWorld.transform(seen);
    return -seen.z;
  }
}
