package simbad.sim;

import java.util.Arrays;
import java.util.List;
import javax.vecmath.Vector3d;
import simbad.kernel.scene.NearPairs;

/**
 * The last word on a step under physics: who would end it deeper within another body than it begins
 * it stays where it is. So bodies that do not overlap never will, whatever impacts, walls and
 * motors have made of their displacements.
 *
 * <p>Who stays may be in the way of who counted on its going; so pairs are looked at until nobody
 * more has to stay, which ends at the latest when all do.
 */
final class Settling {
  private final NearPairs pairs = new NearPairs();
  private final NearPairs.Receiver receiver = this::keep;
  private int[] kept = new int[16];
  private int count;
  private List<SimpleAgent> agents = List.of();

  /** Lets agents stay that would sink into others. Allocates nothing but for more pairs. */
  void apply(List<SimpleAgent> all, double elapsedSecond) {
    agents = all;
    count = 0;
    pairs.resize(all.size());
    for (int i = 0; i < all.size(); i++) {
      SimpleAgent agent = all.get(i);
      pairs.setCentre(i, agent.nextX(), agent.nextY(), agent.nextZ());
      pairs.setRadius(i, agent.getRadius() + agent.instantTranslation.length());
    }
    pairs.sweep(receiver);
    boolean changed = true;
    while (changed) {
      changed = false;
      for (int i = 0; i < count; i += 2) {
        changed |= part(agents.get(kept[i]), agents.get(kept[i + 1]), elapsedSecond);
      }
    }
  }

  private void keep(int lower, int higher) {
    SimpleAgent one = agents.get(lower);
    SimpleAgent other = agents.get(higher);
    if (AgentPair.meetBodily(one, other)) {
      if (count + 2 > kept.length) {
        kept = Arrays.copyOf(kept, 2 * kept.length);
      }
      kept[count++] = lower;
      kept[count++] = higher;
    }
  }

  private static boolean part(SimpleAgent one, SimpleAgent other, double elapsedSecond) {
    if (!AgentPair.sinks(one, other) || one.meets(Compatibility.IMPACTS_LEAVE_OVERLAPS)) {
      return false;
    }
    boolean stays = AgentPair.approaches(one, other) && stay(one, elapsedSecond);
    stays |= AgentPair.approaches(other, one) && stay(other, elapsedSecond);
    return stays;
  }

  /**
   * Lets an agent stay where it is in this step; what it falls or rolls with is as at its start.
   *
   * @return false if it does not move anyway
   */
  private static boolean stay(SimpleAgent agent, double elapsedSecond) {
    if (agent.isStopped() || agent.instantTranslation.lengthSquared() == 0) {
      return false;
    }
    if (agent.hasMotors()) {
      agent.setStopped();
    } else {
      Vector3d velocity = agent.linearVelocity;
      velocity.scaleAdd(-elapsedSecond, agent.linearAcceleration, velocity);
      agent.instantTranslation.set(0, 0, 0);
    }
    return true;
  }
}
