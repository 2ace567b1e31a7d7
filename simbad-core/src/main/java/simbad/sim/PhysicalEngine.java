package simbad.sim;

import java.util.ArrayList;
import javax.media.j3d.BoundingBox;
import javax.media.j3d.BoundingSphere;
import javax.vecmath.Point3d;
import simbad.kernel.geometry.Extent;
import simbad.kernel.scene.NearPairs;

/** Finds which agents are close to each other, which stop each other and which are stopped. */
public class PhysicalEngine {
  /** Acceleration of a falling body, metres per second squared. */
  protected static final float g = 9.8f;

  private final NearPairs pairs = new NearPairs();
  private final NearPairs.Receiver receiver = this::near;
  private ArrayList<SimpleAgent> agents = new ArrayList<>();
  private boolean stopping;

  PhysicalEngine() {}

  /**
   * Tells every two agents whose spheres will touch after this step about each other, and finds
   * which agents are stopped by others.
   *
   * <p>An agent is stopped by another one that cannot be traversed if this step leads towards it
   * and the spheres would touch, wherever the other one ends up in this step. So spheres that do
   * not overlap never will, and those that do can part.
   *
   * @param elapsedSecond how long the step takes, simulated seconds
   * @param all the agents
   * @param push accepted for old programs; agents do not push each other so far
   * @param stop whether agents stop each other
   */
  @SuppressWarnings("NonApiType") // The type is Simbad's.
  protected void checkAgentAgentPairs(
      double elapsedSecond, ArrayList<SimpleAgent> all, boolean push, boolean stop) {
    agents = all;
    stopping = stop;
    pairs.resize(agents.size());
    for (int i = 0; i < agents.size(); i++) {
      SimpleAgent agent = agents.get(i);
      agent.clearVeryNear();
      agent.setStoppedByAgent(false);
      pairs.setCentre(i, agent.nextX(), agent.nextY(), agent.nextZ());
      pairs.setRadius(i, agent.getRadius() + agent.instantTranslation.length());
    }
    pairs.sweep(receiver);
  }

  private void near(int lower, int higher) {
    SimpleAgent one = agents.get(lower);
    SimpleAgent other = agents.get(higher);
    if (one.detachedFromSceneGraph || other.detachedFromSceneGraph) {
      return;
    }
    if (AgentPair.touchAfter(one, other)) {
      one.veryNear(other);
      other.veryNear(one);
    }
    if (stopping && !one.getCanBeTraversed() && !other.getCanBeTraversed()) {
      stop(one, other);
      stop(other, one);
    }
  }

  private static void stop(SimpleAgent agent, SimpleAgent other) {
    if (!agent.restores(Compatibility.ROBOTS_PASS_ROBOTS) && AgentPair.isStopped(agent, other)) {
      agent.setStoppedByAgent(true);
    }
  }

  /**
   * Sets every agent's collision flag.
   *
   * @param all the agents
   * @param objects accepted for old programs; the world knows its objects
   * @param push accepted for old programs
   * @param checkGeometry is handed to the agents
   */
  @SuppressWarnings("NonApiType") // The types are Simbad's.
  protected void checkAgentObjectPairs(
      ArrayList<SimpleAgent> all, ArrayList<Object> objects, boolean push, boolean checkGeometry) {
    for (int i = 0; i < all.size(); i++) {
      all.get(i).checkCollision(null, checkGeometry);
    }
  }

  /** Returns true if a sphere touches a static object. */
  protected boolean intersect(BoundingSphere sphere, StaticObject object) {
    return object.intersect(sphere);
  }

  /** Returns true if a sphere touches a box. */
  protected boolean intersect(BoundingSphere sphere, BoundingBox box) {
    Point3d corner = new Point3d();
    Extent extent = new Extent();
    box.getLower(corner);
    extent.include(corner.x, corner.y, corner.z);
    box.getUpper(corner);
    extent.include(corner.x, corner.y, corner.z);
    Point3d centre = new Point3d();
    sphere.getCenter(centre);
    return extent.touchesBall(centre.x, centre.y, centre.z, sphere.getRadius());
  }
}
