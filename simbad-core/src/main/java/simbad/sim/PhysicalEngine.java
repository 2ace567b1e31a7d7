package simbad.sim;

import java.util.List;
import simbad.kernel.scene.NearPairs;

/** Finds which agents are close to each other and which run into static objects. */
public class PhysicalEngine {
  private final List<SimpleAgent> agents;
  private final NearPairs pairs = new NearPairs();
  private final NearPairs.Receiver receiver = this::near;

  PhysicalEngine(List<SimpleAgent> agents) {
    this.agents = agents;
  }

  /** Tells every two agents whose spheres will touch after this step about each other. */
  void checkAgentAgentPairs() {
    pairs.resize(agents.size());
    for (int i = 0; i < agents.size(); i++) {
      SimpleAgent agent = agents.get(i);
      agent.clearVeryNear();
      pairs.setCentre(i, agent.nextX(), agent.nextY(), agent.nextZ());
      pairs.setRadius(i, agent.getRadius());
    }
    pairs.sweep(receiver);
  }

  private void near(int lower, int higher) {
    SimpleAgent one = agents.get(lower);
    SimpleAgent other = agents.get(higher);
    if (!one.detachedFromSceneGraph && !other.detachedFromSceneGraph) {
      one.veryNear(other);
      other.veryNear(one);
    }
  }

  /**
   * Sets every agent's collision flag.
   *
   * <p>Other agents do not stop an agent: as in Simbad, robots drive through each other.
   */
  void checkAgentObjectPairs() {
    for (int i = 0; i < agents.size(); i++) {
      agents.get(i).checkCollision(null, false);
    }
  }
}
