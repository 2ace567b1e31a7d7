package simbad.blindworld.motion;

import java.util.Arrays;
import java.util.function.UnaryOperator;
import simbad.blindworld.check.Checks;

/**
 * Speeds as they are told to a robot, each held until the next; before the first it stands.
 *
 * <p>Rising times in seconds; speeds in metres per second, forward positive; turn rates in radians
 * per second, counter-clockwise positive.
 */
public final class Commands {

  private final double[] timesS;
  private final double[] speeds;
  private final double[] turns;

  /** Speeds at one moment. */
  public record Speeds(double vMPerS, double wRadPerS) {
    /** Refuses what is no such thing. */
    public Speeds {
      Checks.finite("speed", vMPerS);
      Checks.finite("turn rate", wRadPerS);
    }

    /** Standing still. */
    public static final Speeds ZERO = new Speeds(0, 0);

    /** The rim speed of the left wheel. */
    public double left(double baseM) {
      return vMPerS - wRadPerS * baseM / 2;
    }

    /** The rim speed of the right wheel. */
    public double right(double baseM) {
      return vMPerS + wRadPerS * baseM / 2;
    }

    /** Of two rims. */
    public static Speeds ofRims(double left, double right, double baseM) {
      return new Speeds((left + right) / 2, (right - left) / baseM);
    }

    /** Both wheels' speeds, changed by the same rule. */
    public Speeds rims(double baseM, UnaryOperator<Double> rule) {
      return ofRims(rule.apply(left(baseM)), rule.apply(right(baseM)), baseM);
    }
  }

  /** Commands at rising times; the arrays are copied. */
  public Commands(double[] timesS, double[] speeds, double[] turns) {
    if (timesS.length != speeds.length || timesS.length != turns.length) {
      throw new IllegalArgumentException("commands: columns of unequal length");
    }
    Checks.numbers("times", timesS);
    Checks.numbers("speeds", speeds);
    Checks.numbers("turn rates", turns);
    for (int i = 1; i < timesS.length; i++) {
      if (!(timesS[i] >= timesS[i - 1])) {
        throw new IllegalArgumentException("commands: times that fall, expected rising ones");
      }
    }
    this.timesS = timesS.clone();
    this.speeds = speeds.clone();
    this.turns = turns.clone();
  }

  /** How many there are. */
  public int size() {
    return timesS.length;
  }

  /** When one of them is told. */
  public double timeS(int index) {
    return timesS[index];
  }

  /** One of them. */
  public Speeds at(int index) {
    return new Speeds(speeds[index], turns[index]);
  }

  /** The same times with each command changed by a rule, which is asked in the order of time. */
  public Commands each(UnaryOperator<Speeds> rule) {
    double[] v = new double[size()];
    double[] w = new double[size()];
    for (int i = 0; i < size(); i++) {
      Speeds changed = rule.apply(at(i));
      v[i] = changed.vMPerS();
      w[i] = changed.wRadPerS();
    }
    return new Commands(timesS, v, w);
  }

  /** The same commands at other times; a command never overtakes the one before. */
  public Commands atTimes(double[] otherS) {
    double[] times = otherS.clone();
    for (int i = 1; i < times.length; i++) {
      times[i] = Math.max(times[i], times[i - 1]);
    }
    return new Commands(times, speeds, turns);
  }

  /** All later by the same time. */
  public Commands later(double byS) {
    return atTimes(Arrays.stream(timesS).map(t -> t + byS).toArray());
  }

  /** A quantile of the absolute speeds, over commands that move the robot; 0 without any. */
  public double speedQuantile(double level) {
    return quantile(speeds, level);
  }

  /** A quantile of the absolute turn rates, over commands that turn the robot; 0 without any. */
  public double turnQuantile(double level) {
    return quantile(turns, level);
  }

  private static double quantile(double[] values, double level) {
    double[] sorted = Arrays.stream(values).map(Math::abs).filter(x -> x > 1e-9).sorted().toArray();
    return sorted.length == 0
        ? 0
        : sorted[(int) Math.min(sorted.length - 1.0, level * sorted.length)];
  }

  /** Goes through the commands once and says their means over intervals that follow each other. */
  final class Means {
    private int next;

    /** The mean speeds from a time on over a while. */
    Speeds over(double fromS, double whileS) {
      double toS = fromS + whileS;
      double v = 0;
      double w = 0;
      double at = fromS;
      while (next < timesS.length && timesS[next] < toS) {
        if (timesS[next] > at) {
          v += held(speeds) * (timesS[next] - at);
          w += held(turns) * (timesS[next] - at);
          at = timesS[next];
        }
        next++;
      }
      return new Speeds(
          (v + held(speeds) * (toS - at)) / whileS, (w + held(turns) * (toS - at)) / whileS);
    }

    private double held(double[] of) {
      return next == 0 ? 0 : of[next - 1];
    }
  }

  Means means() {
    return new Means();
  }
}
