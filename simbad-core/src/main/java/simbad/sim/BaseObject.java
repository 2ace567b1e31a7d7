package simbad.sim;

import java.awt.GraphicsEnvironment;
import java.awt.HeadlessException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.media.j3d.Bounds;
import javax.media.j3d.Node;
import javax.media.j3d.Transform3D;
import javax.vecmath.Color3f;
import javax.vecmath.Vector3d;
import org.jspecify.annotations.Nullable;
import simbad.kernel.drawing.Facets;
import simbad.kernel.drawing.Rgb;
import simbad.kernel.drawing.Visual;
import simbad.kernel.geometry.Placement;
import simbad.kernel.geometry.Shape;
import simbad.kernel.scene.Solid;
import simbad.scene3d.Attachment;
import simbad.scene3d.Figure;

/** Anything that has a place in the world: static objects, agents and their devices. */
public abstract class BaseObject {
  /** True while the object is taken out of the world by {@link #detach()}. */
  protected boolean detachedFromSceneGraph;

  /** Bounds in the object's own frame, for those who compute them; unused by the simulation. */
  protected @Nullable Bounds localBounds;

  /** The world that the object is in, if it is in one; to be read only. */
  public @Nullable World world;

  private final Placement placement = new Placement();
  private final List<BaseObject> children = new ArrayList<>();
  private final List<Attachment> nodes = new ArrayList<>();
  private final Vector3d translation = new Vector3d();
  private final double[] matrix = new double[16];
  private final Visual visual = new Visual(placement, this::drawing);
  private @Nullable Solid solid;
  private boolean canBeTraversed;
  private Color3f color = new Color3f(0.8f, 0.8f, 0.8f);

  BaseObject() {}

  /**
   * Says of which shapes this object's body consists, for rays and for collisions. Override it to
   * define a new kind of obstacle or agent; an object without shapes is neither seen nor touched.
   *
   * <p>Asked once, when the body is first needed, which is after construction. Rays meet the shapes
   * as they are turned; collisions use the world-frame boxes round them.
   *
   * @return shapes in the object's own frame; x, y, z as in the world while the object is not
   *     turned
   */
  protected List<Shape> bodyShapes() {
    return List.of();
  }

  /**
   * Says how this object looks, in its own frame: by default its body's shapes in its colour.
   * Override it to look different; the body that rays and collisions meet stays as it is. Asked
   * when the object is first drawn, and again after {@link #lookChanged()}.
   */
  protected List<Facets> drawing() {
    Rgb rgb = Surroundings.rgb(color());
    return bodyShapes().stream().map(shape -> Facets.lit(shape, rgb)).toList();
  }

  /** Says that {@link #drawing()} has another answer now. */
  protected void lookChanged() {
    visual.lookChanged();
  }

  /** Returns how this object looks and where it is, with its parts. */
  Visual visual() {
    return visual;
  }

  /** Adds this object's shapes to a body, given where this object is in that body. */
  void addShapesTo(Solid body, Placement bodyFromThis) {
    bodyShapes().forEach(shape -> body.add(shape, bodyFromThis));
  }

  /**
   * Returns the body that rays and collisions meet, as shapes with their place in the world. It
   * follows the object.
   */
  public Solid getSolid() {
    if (solid == null) {
      Solid made = new Solid(placement);
      addShapesTo(made, new Placement());
      made.setPresent(!detachedFromSceneGraph);
      solid = made;
      applyTraversable();
    }
    return solid;
  }

  /** Moves the object by a displacement in metres, given in the frame that it stands in. */
  public void translateTo(Vector3d displacement) {
    placement.moveBy(displacement.x, displacement.y, displacement.z);
    placementChanged();
  }

  /** Turns the object about its own vertical axis by an angle in radians, counter-clockwise. */
  public void rotateY(double angle) {
    placement.turnAboutY(angle);
    placementChanged();
  }

  /** Turns the object about its own z axis by an angle in radians, from x towards y. */
  public void rotateZ(double angle) {
    placement.turnAboutZ(angle);
    placementChanged();
  }

  /** Tells everyone who depends on the placement that it has changed. */
  void placementChanged() {
    if (solid != null) {
      solid.moved();
    }
    if (world != null) {
      world.noteChange(this);
    }
  }

  /** Returns where the object is, for those in this package who may change it. */
  Placement placement() {
    return placement;
  }

  /** Makes another object part of this one: it is then placed in this object's frame. */
  protected void addChild(BaseObject child) {
    children.add(child);
    visual.add(child.visual());
  }

  /**
   * Adds a Java 3D node that is drawn with this object, in its own frame. Nodes with geometry can
   * be made only where there is a display. To be called before the object enters a world.
   */
  protected void addChild(Node node) {
    nodes.add(new Attachment(node));
  }

  /** Returns what {@link #addChild(Node)} was given. */
  List<Attachment> nodes() {
    return nodes;
  }

  /**
   * Adds to a scene what Java 3D shall show of this object beyond its body: sensor rays, a shadow.
   * Override it; called once for each display scene that is built, and never without a display.
   *
   * @param figure takes nodes in the object's own frame
   */
  protected void decorate(Figure figure) {
    // Most objects are seen as their body alone.
  }

  /** Lets looks be made; those of Java 3D nodes are left out where no display could draw them. */
  static void createLooks(Runnable looks) {
    try {
      looks.run();
    } catch (HeadlessException | ExceptionInInitializerError | NoClassDefFoundError e) {
      if (!GraphicsEnvironment.isHeadless()) {
        throw e;
      }
    }
  }

  /** Returns the objects that are part of this one. */
  List<BaseObject> children() {
    return children;
  }

  /** Writes the object's translation, without its turn, to a transform. */
  public void getTranslationTransform(Transform3D transform) {
    translation.set(placement.xM(), placement.yM(), placement.zM());
    transform.set(translation);
  }

  /** Returns where the object's middle is in the frame that it stands in, metres; a new vector. */
  public Vector3d getTranslation() {
    return new Vector3d(placement.xM(), placement.yM(), placement.zM());
  }

  /** Writes the object's turn, without its translation, to a transform. */
  public void getRotationTransform(Transform3D transform) {
    placement.copyRotationTo(matrix);
    matrix[15] = 1;
    transform.set(matrix);
  }

  /**
   * Returns the turn about the vertical axis in radians, in [-pi, pi]: 0 looks along +x, pi/2 along
   * -z.
   */
  public double getHeadingRad() {
    return placement.headingRad();
  }

  /** Turns the object on the spot to a heading in radians, 0 along +x, pi/2 along -z. */
  public void setHeadingRad(double headingRad) {
    placement.resetTurn();
    rotateY(headingRad);
  }

  /** Puts the object and its parts into a world. */
  protected void setWorld(World newWorld) {
    world = newWorld;
    applyTraversable();
    children.forEach(child -> child.setWorld(newWorld));
  }

  /** Returns the world that the object is in, if it is in one. */
  protected Optional<World> findWorld() {
    return Optional.ofNullable(world);
  }

  /** Returns true if a ball is stopped by a static object of this object's world. */
  boolean isStoppedAt(double x, double y, double z, double radius) {
    return world != null && world.getScene().stopsBall(x, y, z, radius);
  }

  /** Takes the object out of the world; allowed at any time, also within a step. */
  public void detach() {
    setDetached(true);
  }

  /** Puts a detached object back. */
  public void attach() {
    setDetached(false);
  }

  private void setDetached(boolean detached) {
    detachedFromSceneGraph = detached;
    visual.setPresent(!detached);
    if (solid != null) {
      solid.setPresent(!detached);
    }
    placementChanged();
  }

  /** Lets agents pass through this object, or stops them. */
  public void setCanBeTraversed(boolean newCanBeTraversed) {
    canBeTraversed = newCanBeTraversed;
    applyTraversable();
  }

  private void applyTraversable() {
    if (solid != null) {
      solid.setTraversable(canBeTraversed && !stopsThoughTraversable());
    }
  }

  /** Returns true if this object stops agents although they may pass: a habit of the original. */
  boolean stopsThoughTraversable() {
    return false;
  }

  /**
   * Returns true if a habit is wanted in this object's world; notes that something depends on it.
   */
  boolean meets(Compatibility habit) {
    return world != null && world.meets(habit);
  }

  /** Returns true if a habit of the original is wanted in this object's world. */
  boolean restores(Compatibility habit) {
    return world != null && world.restores(habit);
  }

  /** Returns true if agents pass through this object. */
  public boolean getCanBeTraversed() {
    return canBeTraversed;
  }

  /** Sets the colour; the argument is copied. */
  public void setColor(Color3f newColor) {
    color = new Color3f(newColor);
    lookChanged();
  }

  /** Returns the colour. */
  Color3f color() {
    return color;
  }
}
