package simbad.blindworld.motion;

import simbad.blindworld.motion.MotionChange.Stage;

/** Ways in which speeds approach what is told. */
public final class Lag {

  private Lag() {}

  /** A rule that moves a speed towards another over a step of {@link MotionWorld#STEP_S}. */
  public interface Approach {
    /** The speed at the step's end, from that at its beginning and what is told. */
    double next(double from, double to);
  }

  /** A time constant for each of the two speeds; 0 for at once. */
  public static MotionChange firstOrder(double speedS, double turnS) {
    return approaching(exponential(speedS), exponential(turnS));
  }

  /** An exponential approach: what is missing falls by exp(-t/T). */
  public static Approach exponential(double constantS) {
    double left = constantS > 0 ? StrictMath.exp(-MotionWorld.STEP_S / constantS) : 0;
    return (from, to) -> to + (from - to) * left;
  }

  /** A greatest acceleration; infinite for none. */
  public static Approach limited(double perS2) {
    double most = perS2 * MotionWorld.STEP_S;
    return (from, to) -> Math.abs(to - from) <= most ? to : from + Math.signum(to - from) * most;
  }

  /** One rule where the speed's amount grows, another one where it falls. */
  public static Approach unequal(Approach growing, Approach braking) {
    return (from, to) ->
        Math.abs(to) < Math.abs(from) || to * from < 0
            ? braking.next(from, to)
            : growing.next(from, to);
  }

  /** Both speeds by rules of their own; over a step the mean of its ends counts. */
  public static MotionChange approaching(Approach speed, Approach turn) {
    return MotionChange.acting(Stage.ACTUATION, random -> new Approaching(speed, turn));
  }

  private static final class Approaching implements Acting {
    private final Approach speed;
    private final Approach turn;
    private double v;
    private double w;

    Approaching(Approach speed, Approach turn) {
      this.speed = speed;
      this.turn = turn;
    }

    @Override
    public void beginRun() {
      v = 0;
      w = 0;
    }

    @Override
    public void move(Step step) {
      double oldV = v;
      double oldW = w;
      v = speed.next(oldV, step.v());
      w = turn.next(oldW, step.w());
      step.set(mean(oldV, v, step.v()), mean(oldW, w, step.w()));
    }

    /** What has arrived counts as there from the step's beginning, as it is without a lag. */
    private static double mean(double from, double now, double to) {
      return now == to ? now : (from + now) / 2;
    }
  }
}
