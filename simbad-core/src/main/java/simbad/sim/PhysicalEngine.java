package simbad.sim;

import java.util.ArrayList;
import java.util.List;
import javax.media.j3d.BoundingBox;
import javax.media.j3d.BoundingSphere;
import javax.vecmath.Point3d;
import javax.vecmath.Vector3d;
import simbad.kernel.geometry.Extent;
import simbad.kernel.scene.NearPairs;

/**
 * Finds which agents are close to each other, which stop each other and which are stopped; with
 * physics on, also lets them fall, slide, push each other and bounce off walls.
 *
 * <p>Physics is that of rigid spheres: weight, friction on the floor, elastic central impacts. A
 * body comes down on the floor without bouncing. Within a step accelerations are constant, and
 * displacements are exact for that.
 */
public class PhysicalEngine {
  /** Acceleration of a falling body, metres per second squared. */
  protected static final float g = 9.8f;

  /** Room for the rounding of a floating-point height. */
  private static final double ON_GROUND_M = 1e-6;

  private final NearPairs pairs = new NearPairs();
  private final NearPairs.Receiver receiver = this::near;
  private final AgentImpact impact = new AgentImpact(this);
  private final Settling settling = new Settling();
  private final WallImpact wallImpact = new WallImpact(this);
  private ArrayList<SimpleAgent> agents = new ArrayList<>();
  private double elapsed;
  private boolean pushing;
  private boolean stopping;

  PhysicalEngine() {}

  /**
   * Sets an agent's acceleration to what weight and friction give it in this step.
   *
   * <p>Above the floor that is {@link #g} downwards; on it, friction against the motion, at most as
   * much as stops the agent. The friction coefficient is the dynamic one, or the static one where
   * that is 0; what has motors is not slowed. Without mass, or detached, nothing accelerates.
   *
   * @param elapsedSecond how long the step takes, simulated seconds
   * @param agent whose velocity is that at the start of the step
   */
  protected void computeForces(double elapsedSecond, SimpleAgent agent) {
    computeForces(elapsedSecond, agent, agent.isAboveGround());
  }

  /**
   * The same of an agent that is known to fall or not: what has just been thrown up from the floor
   * has its weight, too.
   */
  void computeForces(double elapsedSecond, SimpleAgent agent, boolean falls) {
    agent.setInteracted(false);
    agent.linearAcceleration.set(0, 0, 0);
    if (agent.getMass() <= 0 || agent.detachedFromSceneGraph) {
      return;
    }
    double weight = falls || slides(agent) ? weight(agent) : 1;
    if (falls) {
      agent.linearAcceleration.y = -g * weight;
    }
    if (slides(agent) && !(falls && !agent.meets(Compatibility.FRICTION_IN_THE_AIR))) {
      slow(agent, g * weight * friction(agent), elapsedSecond);
    }
  }

  private static double weight(SimpleAgent agent) {
    boolean tells = agent.getMass() != 1;
    return tells && agent.meets(Compatibility.GRAVITY_GROWS_WITH_MASS) ? agent.getMass() : 1;
  }

  /** The dynamic coefficient, or the static one where that is 0. */
  private static double friction(SimpleAgent agent) {
    return agent.dynamicFrictionCoefficient > 0
        ? agent.dynamicFrictionCoefficient
        : agent.staticFrictionCoefficient;
  }

  /** Ends a step's way down at the floor, and lifts what is below it. */
  private static void land(SimpleAgent agent) {
    double above = agent.distanceToGround();
    boolean sinks = agent.instantTranslation.y < 0 || above < -ON_GROUND_M;
    if (sinks && above + agent.instantTranslation.y < 0) {
      agent.instantTranslation.y = -above;
      agent.linearVelocity.y = 0;
      agent.linearAcceleration.y = 0;
    }
  }

  private static boolean slides(SimpleAgent agent) {
    Vector3d velocity = agent.linearVelocity;
    boolean moves = velocity.lengthSquared() > 0;
    return moves && !agent.hasMotors() && friction(agent) > 0;
  }

  private static void slow(SimpleAgent agent, double brakingMPerS2, double elapsedSecond) {
    Vector3d velocity = agent.linearVelocity;
    // What lies on the floor has no speed upwards; of what falls, the original slowed that, too.
    double speedMPerS = velocity.length();
    double stopping = speedMPerS / elapsedSecond;
    boolean stops = brakingMPerS2 > stopping && !agent.meets(Compatibility.FRICTION_NEVER_STOPS);
    double share = (stops ? stopping : brakingMPerS2) / speedMPerS;
    agent.linearAcceleration.scaleAdd(-share, velocity, agent.linearAcceleration);
  }

  /** Lets agents stay where they are that this step would lead into others. */
  void settle(List<SimpleAgent> all, double elapsedSecond) {
    settling.apply(all, elapsedSecond);
  }

  /** Lets agents that would sink below the floor in this step come down on it. */
  void land(List<SimpleAgent> all) {
    for (int i = 0; i < all.size(); i++) {
      land(all.get(i));
    }
  }

  /**
   * Tells every two agents whose spheres touch in this step about each other, and finds which
   * agents push each other or are stopped by others.
   *
   * <p>Without physics an agent is stopped by another one that cannot be traversed if this step
   * leads towards it and the spheres would touch, wherever the other one ends up in this step. So
   * spheres that do not overlap never will, and those that do can part. With physics it is stopped
   * only if the spheres would touch when both have moved: what can give way is pushed.
   *
   * @param elapsedSecond how long the step takes, simulated seconds
   * @param all the agents
   * @param push whether agents that meet exchange momentum
   * @param stop whether agents stop each other
   */
  @SuppressWarnings("NonApiType") // The type is Simbad's.
  protected void checkAgentAgentPairs(
      double elapsedSecond, ArrayList<SimpleAgent> all, boolean push, boolean stop) {
    agents = all;
    elapsed = elapsedSecond;
    pushing = push;
    stopping = stop;
    pairs.resize(agents.size());
    for (int i = 0; i < agents.size(); i++) {
      SimpleAgent agent = agents.get(i);
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
    boolean solid = !one.getCanBeTraversed() && !other.getCanBeTraversed();
    boolean met = pushing && solid && impact.apply(one, other, elapsed);
    if (met || (stopping && AgentPair.touchAfter(one, other))) {
      one.veryNear(other);
      boolean isLast = higher == agents.size() - 1;
      if (isLast || !other.meets(Compatibility.NEARNESS_IS_ONE_SIDED)) {
        other.veryNear(one);
      }
    }
    if (stopping && solid) {
      stop(one, other);
      stop(other, one);
    }
  }

  private void stop(SimpleAgent agent, SimpleAgent other) {
    boolean stopped =
        pushing ? AgentPair.runsInto(agent, other) : AgentPair.isStopped(agent, other);
    if (stopped && !agent.meets(Compatibility.ROBOTS_PASS_ROBOTS)) {
      agent.setStoppedByAgent(true);
    }
  }

  /**
   * Lets agents bounce off static objects, or sets every agent's collision flag.
   *
   * @param all the agents
   * @param objects accepted for old programs; the world knows its objects
   * @param push true: what has no motors bounces; false: collision flags are set
   * @param checkGeometry is handed to the agents
   */
  @SuppressWarnings("NonApiType") // The types are Simbad's.
  protected void checkAgentObjectPairs(
      ArrayList<SimpleAgent> all, ArrayList<Object> objects, boolean push, boolean checkGeometry) {
    for (int i = 0; i < all.size(); i++) {
      if (push) {
        wallImpact.apply(all.get(i), elapsed);
      } else {
        all.get(i).checkCollision(null, checkGeometry);
      }
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

  /**
   * Computes the direction in which a box pushes a sphere: from the nearest point of the box to the
   * sphere's centre, or out of the nearest face if the centre is inside.
   *
   * @param sphere in the frame of the box
   * @param box where it stands
   * @param normal receives the unit vector
   */
  protected void computeContactNormal(BoundingSphere sphere, BoundingBox box, Vector3d normal) {
    Point3d lower = new Point3d();
    Point3d upper = new Point3d();
    Point3d centre = new Point3d();
    box.getLower(lower);
    box.getUpper(upper);
    sphere.getCenter(centre);
    normal.set(
        beyond(centre.x, lower.x, upper.x),
        beyond(centre.y, lower.y, upper.y),
        beyond(centre.z, lower.z, upper.z));
    if (normal.lengthSquared() > 0) {
      normal.normalize();
    } else {
      leaveByNearestFace(centre, lower, upper, normal);
    }
  }

  private static double beyond(double at, double lower, double upper) {
    return at < lower ? at - lower : Math.max(0, at - upper);
  }

  private void leaveByNearestFace(Point3d at, Point3d lower, Point3d upper, Vector3d normal) {
    double nearest = Double.NEGATIVE_INFINITY;
    for (int face = 0; face < 6; face++) {
      Point3d onFace = face % 2 == 0 ? lower : upper;
      double side = face % 2 == 0 ? -1 : 1;
      double x = face / 2 == 0 ? side : 0;
      double y = face / 2 == 1 ? side : 0;
      double z = face / 2 == 2 ? side : 0;
      double height = projNormal(at.x, at.y, at.z, onFace.x, onFace.y, onFace.z, x, y, z);
      if (height > nearest) {
        nearest = height;
        normal.set(x, y, z);
      }
    }
  }

  /**
   * Returns how far a point lies above a plane.
   *
   * @param x the point's x; y and z follow
   * @param planeX x of a point of the plane; y and z follow
   * @param normalX x of the plane's unit normal; y and z follow
   */
  protected double projNormal(
      double x,
      double y,
      double z,
      double planeX,
      double planeY,
      double planeZ,
      double normalX,
      double normalY,
      double normalZ) {
    return (x - planeX) * normalX + (y - planeY) * normalY + (z - planeZ) * normalZ;
  }
}
