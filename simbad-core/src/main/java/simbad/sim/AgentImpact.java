package simbad.sim;

import javax.vecmath.Vector3d;

/** Lets two agents that meet in a step exchange momentum, as elastic spheres do. */
final class AgentImpact {
  private final PhysicalEngine engine;
  private final Vector3d between = new Vector3d();
  private final Vector3d approach = new Vector3d();

  AgentImpact(PhysicalEngine engine) {
    this.engine = engine;
  }

  /**
   * Changes velocities and displacements of two agents if they meet in this step.
   *
   * @return true if they meet
   */
  boolean apply(SimpleAgent one, SimpleAgent other, double elapsedSecond) {
    between.set(
        other.placement().xM() - one.placement().xM(),
        other.placement().yM() - one.placement().yM(),
        other.placement().zM() - one.placement().zM());
    approach.sub(other.instantTranslation, one.instantTranslation);
    boolean massive = one.getMass() > 0 && other.getMass() > 0;
    if (!massive || !reachContact((double) one.getRadius() + other.getRadius())) {
      return false;
    }
    if (!one.isAboveGround() && !other.isAboveGround()) {
      // The floor takes what would press a lower body down.
      between.y = 0;
    }
    return between.lengthSquared() > 0 && exchange(one, other, elapsedSecond);
  }

  /**
   * Moves {@link #between} to where the spheres first touch in this step; spheres that overlap
   * touch at once.
   *
   * @return false if they do not touch or do not approach
   */
  private boolean reachContact(double reachM) {
    double closing = between.dot(approach);
    double gap = between.lengthSquared() - reachM * reachM;
    if (closing >= 0 || between.lengthSquared() == 0) {
      return false;
    }
    if (gap > 0) {
      double way = approach.lengthSquared();
      double root = closing * closing - way * gap;
      double share = root < 0 ? Double.POSITIVE_INFINITY : (-closing - Math.sqrt(root)) / way;
      if (share > 1) {
        return false;
      }
      between.scaleAdd(share, approach, between);
    }
    return true;
  }

  private boolean exchange(SimpleAgent one, SimpleAgent other, double elapsedSecond) {
    between.normalize();
    // The velocities before weight and friction act: these differ between the floor and the air.
    approach.sub(other.linearVelocity, one.linearVelocity);
    approach.scaleAdd(elapsedSecond, one.linearAcceleration, approach);
    approach.scaleAdd(-elapsedSecond, other.linearAcceleration, approach);
    double closingMPerS = -approach.dot(between);
    if (closingMPerS <= 0) {
      return false;
    }
    double impulse =
        (1 + restitution(one, other))
            * closingMPerS
            / (1.0 / one.getMass() + 1.0 / other.getMass());
    push(one, -impulse / one.getMass(), elapsedSecond);
    push(other, impulse / other.getMass(), elapsedSecond);
    return true;
  }

  /**
   * What has motors pushes and does not kick: a ball between a wall and a robot that comes nearer
   * would get faster with each bounce.
   */
  private static double restitution(SimpleAgent one, SimpleAgent other) {
    boolean driven = one.hasMotors() || other.hasMotors();
    return driven && !one.meets(Compatibility.IMPACTS_LEAVE_OVERLAPS) ? 0 : 1;
  }

  private void push(SimpleAgent agent, double changeMPerS, double elapsedSecond) {
    Vector3d velocity = agent.linearVelocity;
    velocity.scaleAdd(-elapsedSecond, agent.linearAcceleration, velocity);
    velocity.scaleAdd(changeMPerS, between, velocity);
    engine.computeForces(elapsedSecond, agent);
    velocity.scaleAdd(elapsedSecond, agent.linearAcceleration, velocity);
    agent.integratesPositionChange(elapsedSecond);
    agent.setInteracted(true);
  }
}
