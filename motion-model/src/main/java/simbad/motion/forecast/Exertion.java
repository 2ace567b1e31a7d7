package simbad.motion.forecast;

import java.util.List;
import simbad.motion.Command;
import simbad.motion.MotionRun;

/**
 * How much is asked of a robot in a window: the way and the turn that are commanded, and how much
 * the commands change. A robot that stands is where it was; one that starts and turns may be off.
 */
public final class Exertion {
  /** A radian moves what stands so far from the centre by as much as a metre of way. */
  private static final double ARM_M = 0.1;

  /** A change of command is worth the way that it makes in this time. */
  private static final double CHANGE_S = 0.3;

  /** What was commanded shortly before still acts. */
  private static final double BEFORE_S = 0.5;

  private final double[] timesS;
  private final double[] rates;
  private final double[] sums;
  private final double[] changes;

  private Exertion(int size) {
    timesS = new double[size];
    rates = new double[size];
    sums = new double[size];
    changes = new double[size];
  }

  /** Prepares the commands of a run. */
  public static Exertion of(MotionRun run) {
    List<Command> commands = run.commands();
    Exertion own = new Exertion(commands.size());
    double speed = 0;
    double turn = 0;
    for (int i = 0; i < commands.size(); i++) {
      Command c = commands.get(i);
      own.timesS[i] = c.timeS();
      own.rates[i] = Math.abs(c.speedMPerS()) + ARM_M * Math.abs(c.turnRadPerS());
      double change = Math.abs(c.speedMPerS() - speed) + ARM_M * Math.abs(c.turnRadPerS() - turn);
      own.changes[i] = (i == 0 ? 0 : own.changes[i - 1]) + CHANGE_S * change;
      double held = i == 0 ? 0 : c.timeS() - own.timesS[i - 1];
      own.sums[i] = i == 0 ? 0 : own.sums[i - 1] + own.rates[i - 1] * held;
      speed = c.speedMPerS();
      turn = c.turnRadPerS();
    }
    return own;
  }

  /**
   * Returns how much is asked between two times, metres.
   *
   * @param fromS start of the window
   * @param toS its end
   */
  public double between(double fromS, double toS) {
    return way(toS) - way(fromS) + changed(toS) - changed(fromS - BEFORE_S);
  }

  private double way(double timeS) {
    int i = index(timeS);
    return i < 0 ? 0 : sums[i] + rates[i] * (timeS - timesS[i]);
  }

  private double changed(double timeS) {
    int i = index(timeS);
    return i < 0 ? 0 : changes[i];
  }

  private int index(double timeS) {
    int low = 0;
    int high = timesS.length;
    while (low < high) {
      int middle = (low + high) >>> 1;
      if (timesS[middle] <= timeS) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    return low - 1;
  }
}
