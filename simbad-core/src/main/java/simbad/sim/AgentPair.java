package simbad.sim;

import simbad.kernel.geometry.Placement;

/** What the bounding spheres of two agents do to each other in a step. Allocates nothing. */
final class AgentPair {
  private AgentPair() {}

  /** Returns true if the spheres touch when both agents have moved. */
  static boolean touchAfter(SimpleAgent one, SimpleAgent other) {
    return touch(
        one.nextX() - other.nextX(),
        one.nextY() - other.nextY(),
        one.nextZ() - other.nextZ(),
        reach(one, other));
  }

  /**
   * Returns true if an agent moves towards another one and would touch it, whether or not that one
   * moves.
   */
  static boolean isStopped(SimpleAgent agent, SimpleAgent other) {
    return approaches(agent, other) && (touchStanding(agent, other) || touchAfter(agent, other));
  }

  /**
   * Returns true if an agent moves towards another one and touches it when both have moved; a
   * static object may keep the other one where it is.
   */
  static boolean runsInto(SimpleAgent agent, SimpleAgent other) {
    return approaches(agent, other)
        && (touchAfter(agent, other) || (touchStanding(agent, other) && other.runsIntoObject()));
  }

  /** Returns true if neither agent may pass the other. */
  static boolean meetBodily(SimpleAgent one, SimpleAgent other) {
    boolean solid = !one.getCanBeTraversed() && !other.getCanBeTraversed();
    return solid && !one.detachedFromSceneGraph && !other.detachedFromSceneGraph;
  }

  /** Returns true if the spheres overlap after this step, and more than now. */
  static boolean sinks(SimpleAgent one, SimpleAgent other) {
    double dx = other.placement().xM() - one.placement().xM();
    double dy = other.placement().yM() - one.placement().yM();
    double dz = other.placement().zM() - one.placement().zM();
    double before = dx * dx + dy * dy + dz * dz;
    double share = one.isStopped() ? 0 : 1;
    double otherShare = other.isStopped() ? 0 : 1;
    dx += otherShare * other.instantTranslation.x - share * one.instantTranslation.x;
    dy += otherShare * other.instantTranslation.y - share * one.instantTranslation.y;
    dz += otherShare * other.instantTranslation.z - share * one.instantTranslation.z;
    double after = dx * dx + dy * dy + dz * dz;
    double reach = reach(one, other);
    return after < reach * reach && after < before;
  }

  static boolean approaches(SimpleAgent agent, SimpleAgent other) {
    Placement from = agent.placement();
    Placement to = other.placement();
    return agent.instantTranslation.x * (to.xM() - from.xM())
            + agent.instantTranslation.y * (to.yM() - from.yM())
            + agent.instantTranslation.z * (to.zM() - from.zM())
        > 0;
  }

  private static boolean touchStanding(SimpleAgent agent, SimpleAgent other) {
    Placement standing = other.placement();
    return touch(
        agent.nextX() - standing.xM(),
        agent.nextY() - standing.yM(),
        agent.nextZ() - standing.zM(),
        reach(agent, other));
  }

  private static double reach(SimpleAgent one, SimpleAgent other) {
    return (double) one.getRadius() + other.getRadius();
  }

  private static boolean touch(double dx, double dy, double dz, double reach) {
    return dx * dx + dy * dy + dz * dz <= reach * reach;
  }
}
