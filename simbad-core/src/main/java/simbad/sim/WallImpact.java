package simbad.sim;

import java.util.List;
import javax.media.j3d.BoundingBox;
import javax.media.j3d.BoundingSphere;
import javax.vecmath.Point3d;
import javax.vecmath.Vector3d;
import simbad.kernel.geometry.Extent;
import simbad.kernel.scene.BodyPart;

/** Lets agents without motors bounce off static objects, as an elastic sphere does. */
final class WallImpact {
  private static final double MOST_PLACES = 1000;

  private final PhysicalEngine engine;
  private final Vector3d normal = new Vector3d();
  private final Point3d centre = new Point3d();
  private final BoundingSphere sphere = new BoundingSphere();

  WallImpact(PhysicalEngine engine) {
    this.engine = engine;
  }

  /**
   * Mirrors an agent's velocity at what this step leads it into. The agent sets off from where it
   * stands, with the mirror image of the velocity that it has there before weight and friction act:
   * so what falls on a box rises as high again.
   */
  void apply(SimpleAgent agent, double elapsedSecond) {
    World world = agent.world;
    boolean hits =
        world != null && !agent.hasMotors() && !agent.detachedFromSceneGraph && meetsObject(agent);
    if (hits) {
      Vector3d velocity = agent.linearVelocity;
      velocity.scaleAdd(-elapsedSecond, agent.linearAcceleration, velocity);
      bounce(agent, world.getStaticObjects());
      engine.computeForces(elapsedSecond, agent, agent.isAboveGround() || velocity.y > 0);
      velocity.scaleAdd(elapsedSecond, agent.linearAcceleration, velocity);
      agent.integratesPositionChange(elapsedSecond);
      agent.setInteracted(true);
    }
  }

  /**
   * Moves {@link #centre} along this step's way to the first place looked at where the agent would
   * touch something. Places are a radius apart, so that nothing fast passes through walls.
   */
  private boolean meetsObject(SimpleAgent agent) {
    double wayM = agent.instantTranslation.length();
    int places = 1 + (int) Math.min(MOST_PLACES, wayM / agent.getRadius());
    for (int i = 1; i <= places; i++) {
      centre.set(agent.placement().xM(), agent.placement().yM(), agent.placement().zM());
      centre.scaleAdd((double) i / places, agent.instantTranslation, centre);
      if (agent.isStoppedAt(centre.x, centre.y, centre.z, agent.getRadius())) {
        return true;
      }
    }
    return false;
  }

  private void bounce(SimpleAgent agent, List<StaticObject> objects) {
    sphere.setCenter(centre);
    sphere.setRadius(agent.getRadius());
    // Normals are those of where the agent stands: where it would be is inside, perhaps.
    for (StaticObject object : objects) {
      if (object.getSolid().isPresent()
          && !object.getSolid().isTraversable()
          && engine.intersect(sphere, object)) {
        object.getSolid().parts().forEach(part -> bounce(agent, part));
      }
    }
  }

  private void bounce(SimpleAgent agent, BodyPart part) {
    Extent extent = part.extent();
    if (extent.touchesBall(centre.x, centre.y, centre.z, agent.getRadius())) {
      BoundingBox box =
          new BoundingBox(
              new Point3d(extent.minX(), extent.minY(), extent.minZ()),
              new Point3d(extent.maxX(), extent.maxY(), extent.maxZ()));
      Point3d standing =
          new Point3d(agent.placement().xM(), agent.placement().yM(), agent.placement().zM());
      engine.computeContactNormal(new BoundingSphere(standing, agent.getRadius()), box, normal);
      double closingMPerS = -normal.dot(agent.linearVelocity);
      if (closingMPerS > 0) {
        agent.linearVelocity.scaleAdd(2 * closingMPerS, normal, agent.linearVelocity);
      }
    }
  }
}
