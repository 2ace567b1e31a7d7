package simbad.sonar.effect;

import java.util.ArrayList;
import java.util.List;
import simbad.sonar.check.Checks;

/**
 * A reading belongs to an earlier pose: the one of some time ago, between poses in proportion;
 * before the run began the sensor is taken to have stood where it began.
 *
 * @param delayS seconds, at least 0; 0 is neutral
 */
public record Latency(double delayS) implements PoseChange {
  /** Checks the figure; NaN is refused. */
  public Latency {
    Checks.notNegative("delayS", delayS);
  }

  @Override
  public int order() {
    return 2;
  }

  @Override
  public Track start(String sensor, double runStartS) {
    return delayS == 0 ? Track.STILL : new Delay(delayS);
  }

  private record Stamped(double timeS, TruePose pose) {}

  private static final class Delay implements Track {
    private final double delayS;

    /** The last pose before the wanted time, if there is one, and all after it. */
    private final List<Stamped> past = new ArrayList<>();

    Delay(double delayS) {
      this.delayS = delayS;
    }

    @Override
    public void next(double timeS, TruePose pose) {
      double then = timeS - delayS;
      past.add(new Stamped(timeS, pose.copy()));
      while (past.size() > 1 && past.get(1).timeS() < then) {
        past.remove(0);
      }
      Stamped earlier = past.get(0);
      if (earlier.timeS() >= then || past.size() == 1) {
        pose.set(earlier.pose());
      } else {
        Stamped later = past.get(1);
        double share = (then - earlier.timeS()) / (later.timeS() - earlier.timeS());
        pose.setBetween(earlier.pose(), later.pose(), share);
      }
    }
  }
}
