package simbad.sonar.effect;

import java.util.ArrayList;
import java.util.List;
import simbad.sonar.check.Checks;

/**
 * A reading belongs to the pose of some pings ago, whatever the time between; in the first pings of
 * a run to the first.
 *
 * @param pings how many, at least 0; between two in proportion; 0 is neutral
 */
public record PingDelay(double pings) implements PoseChange {
  /** Checks the figure; NaN is refused. */
  public PingDelay {
    Checks.notNegative("pings", pings);
  }

  @Override
  public int order() {
    return 2;
  }

  @Override
  public Track start(String sensor, double runStartS) {
    return pings == 0 ? Track.STILL : new Delay(pings);
  }

  private static final class Delay implements Track {
    private final double pings;
    private final List<TruePose> past = new ArrayList<>();

    Delay(double pings) {
      this.pings = pings;
    }

    @Override
    public void next(double timeS, TruePose pose) {
      past.add(pose.copy());
      while (past.size() > pings + 2) {
        past.remove(0);
      }
      double then = Math.max(0, past.size() - 1 - pings);
      int earlier = (int) then;
      int later = Math.min(past.size() - 1, earlier + 1);
      pose.setBetween(past.get(earlier), past.get(later), then - earlier);
    }
  }
}
