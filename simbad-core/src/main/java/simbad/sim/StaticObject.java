package simbad.sim;

import javax.media.j3d.Appearance;
import javax.media.j3d.BoundingBox;
import javax.media.j3d.BoundingSphere;
import javax.media.j3d.Bounds;
import javax.media.j3d.Transform3D;
import javax.vecmath.Point3d;
import org.jspecify.annotations.Nullable;
import simbad.kernel.geometry.Extent;
import simbad.kernel.geometry.Placement;
import simbad.kernel.scene.BodyPart;
import simbad.kernel.scene.Solid;

/** An object that does not move by itself. */
public class StaticObject extends BaseObject {
  /** World-frame bounds, as {@link #createTransformedBounds()} left them. */
  protected @Nullable Bounds transformedBounds;

  /** Where the object is, as {@link #createLocalToVworld()} left it. */
  protected Transform3D localToVworld = new Transform3D();

  /** How the object looks, for the window. */
  protected @Nullable Appearance appearance;

  private final Point3d centre = new Point3d();
  private final BoundingSphere ball = new BoundingSphere();

  /** Creates an object at the origin. */
  public StaticObject() {}

  @Override
  void addShapesTo(Solid body, Placement bodyFromThis) {
    super.addShapesTo(body, bodyFromThis);
    body.setBallTest(this::touchesBall);
  }

  @Override
  boolean stopsThoughTraversable() {
    return meets(Compatibility.TRAVERSABLE_OBJECTS_STOP);
  }

  /** Asks the hook, so that a subclass decides about collisions with it. */
  private boolean touchesBall(double x, double y, double z, double radius) {
    centre.set(x, y, z);
    ball.setCenter(centre);
    ball.setRadius(radius);
    return intersect(ball);
  }

  /**
   * Decides whether an agent, given by its bounding sphere, collides with this object. This
   * implementation compares the sphere with the world-frame boxes round the body's shapes. Asked
   * only of objects whose boxes the sphere may touch.
   */
  protected boolean intersect(BoundingSphere bounds) {
    bounds.getCenter(centre);
    return getSolid().extentTouchesBall(centre.x, centre.y, centre.z, bounds.getRadius());
  }

  /** Computes {@link #transformedBounds} for where the object is now. */
  protected void createTransformedBounds() {
    Extent extent = new Extent();
    for (BodyPart part : getSolid().parts()) {
      extent.include(part.extent());
    }
    transformedBounds =
        new BoundingBox(
            new Point3d(extent.minX(), extent.minY(), extent.minZ()),
            new Point3d(extent.maxX(), extent.maxY(), extent.maxZ()));
  }

  /** Returns the world-frame bounds of the object where it is now. */
  protected @Nullable Bounds getTransformedBounds() {
    createTransformedBounds();
    return transformedBounds;
  }

  /** Computes {@link #localToVworld} for where the object is now. */
  protected void createLocalToVworld() {
    Transform3D turn = new Transform3D();
    getTranslationTransform(localToVworld);
    getRotationTransform(turn);
    localToVworld.mul(turn);
  }
}
