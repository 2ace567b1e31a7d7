package simbad.sonar.change;

import java.util.ArrayList;
import java.util.List;
import simbad.sonar.ping.PoseChange;
import simbad.sonar.ping.TruePose;

/**
 * A robot is on the path that it believes to follow, but not as far along it.
 *
 * @param factor way made over way believed, in (0, 1]; 1 is neutral. A robot that is further along
 *     than it believes is where no pose tells of yet.
 */
public record PathScale(double factor) implements PoseChange {
  /** Rejects a factor out of its range. */
  public PathScale {
    if (!(factor > 0 && factor <= 1)) {
      throw new IllegalArgumentException("factor = " + factor + " is not in (0, 1]");
    }
  }

  @Override
  public int order() {
    return 0;
  }

  @Override
  public Track start(String sensor, double runStartS) {
    return factor == 1 ? Track.STILL : new Behind();
  }

  private record Milestone(double wayM, TruePose pose) {}

  private final class Behind implements Track {
    private final List<Milestone> path = new ArrayList<>();

    /** The last milestone that is not beyond where the robot is. */
    private int at;

    @Override
    public void next(double timeS, TruePose pose) {
      double wayM = 0;
      if (!path.isEmpty()) {
        Milestone last = path.get(path.size() - 1);
        double dx = pose.xM() - last.pose.xM();
        double dz = pose.zM() - last.pose.zM();
        wayM = last.wayM + Math.hypot(dx, dz);
      }
      path.add(new Milestone(wayM, pose.copy()));
      double made = factor * wayM;
      while (at + 1 < path.size() && path.get(at + 1).wayM <= made) {
        at++;
      }
      Milestone from = path.get(at);
      if (at + 1 < path.size() && path.get(at + 1).wayM > from.wayM) {
        Milestone to = path.get(at + 1);
        double share = (made - from.wayM) / (to.wayM - from.wayM);
        pose.setBetween(from.pose, to.pose, share);
      } else {
        pose.set(from.pose);
      }
    }
  }
}
