package simbad.kernel.scene;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.jspecify.annotations.Nullable;
import simbad.kernel.geometry.Placement;
import simbad.kernel.geometry.Shape;

/**
 * A body in the world: some shapes that move together. Rays see every solid that is present; balls
 * are stopped by those that are not traversable.
 *
 * <p>The solid shares its placement with its owner, who calls {@link #moved()} after a change. Not
 * safe for use by several threads.
 */
public final class Solid {
  /** Decides whether a ball, given by its centre and radius in metres, touches a solid. */
  @FunctionalInterface
  public interface BallTest {
    /** Returns true if the ball touches. */
    boolean touches(double xM, double yM, double zM, double radiusM);
  }

  private final Placement worldFromSolid;
  private final List<BodyPart> parts = new ArrayList<>();
  private BallTest ballTest = this::extentTouchesBall;
  private boolean traversable;
  private boolean present = true;
  private boolean stale = true;
  private @Nullable SolidIndex index;

  /**
   * Creates a solid without shapes.
   *
   * @param worldFromSolid where it is; shared, not copied
   */
  public Solid(Placement worldFromSolid) {
    this.worldFromSolid = worldFromSolid;
  }

  /** Adds a shape in the solid's own frame, before the solid enters a scene. */
  public Solid add(Shape shape) {
    return add(shape, new Placement());
  }

  /**
   * Adds a shape that has its place in the solid, before the solid enters a scene.
   *
   * @param shape the shape in its own frame
   * @param solidFromShape its place; kept, to be left alone from then on
   */
  public Solid add(Shape shape, Placement solidFromShape) {
    parts.add(new BodyPart(this, shape, solidFromShape));
    stale = true;
    return this;
  }

  /** Returns the parts, in the order in which they were added. */
  public List<BodyPart> parts() {
    return Collections.unmodifiableList(parts);
  }

  /** Says that the placement has changed. */
  public void moved() {
    stale = true;
    if (index != null) {
      index.noteMove();
    }
  }

  void refresh() {
    if (stale) {
      stale = false;
      for (int i = 0; i < parts.size(); i++) {
        parts.get(i).refresh(worldFromSolid);
      }
    }
  }

  /** Takes the solid out of its scene, or puts it back. */
  public void setPresent(boolean newPresent) {
    present = newPresent;
    if (index != null) {
      index.noteChange();
    }
  }

  /** Returns true if rays and balls can meet the solid. */
  public boolean isPresent() {
    return present;
  }

  /** Lets balls pass through the solid, or stops them. Rays see it in both cases. */
  public void setTraversable(boolean newTraversable) {
    traversable = newTraversable;
  }

  /** Returns true if balls pass through. */
  public boolean isTraversable() {
    return traversable;
  }

  /** Replaces the test that decides whether a ball near this solid's extent touches it. */
  public void setBallTest(BallTest test) {
    ballTest = test;
  }

  /** Returns true if a ball is stopped by this solid. */
  boolean stopsBall(double xM, double yM, double zM, double radiusM) {
    return !traversable && ballTest.touches(xM, yM, zM, radiusM);
  }

  /**
   * Returns true if a ball touches the world-frame box round one of the parts.
   *
   * <p>Simbad collides with these boxes, not with the turned bodies themselves.
   */
  public boolean extentTouchesBall(double xM, double yM, double zM, double radiusM) {
    refresh();
    for (int i = 0; i < parts.size(); i++) {
      if (parts.get(i).extent().touchesBall(xM, yM, zM, radiusM)) {
        return true;
      }
    }
    return false;
  }

  void enter(SolidIndex newIndex) {
    if (index != null) {
      index.forget(this);
    }
    index = newIndex;
  }
}
