package simbad.blindworld.motion;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;
import simbad.blindworld.check.Checks;
import simbad.blindworld.world.Chance;

/**
 * A robot with everything that is at work in it. Speeds are constant over steps of a fiftieth of a
 * second, in each of which the robot drives an arc; what is told acts by its mean over a step.
 */
public final class MotionWorld {

  /** How long a step is. */
  public static final double STEP_S = 0.02;

  private final Robot robot;
  private final Seeing seeing;
  private final List<MotionChange> changes;

  /**
   * How the tracker scatters.
   *
   * @param scatter its standard deviations
   * @param tails 0 for Gaussian; else the share of frames that scatter three times as much
   */
  public record Seeing(Robot.Scatter scatter, double tails) {
    /** Refuses what is no such thing. */
    public Seeing {
      Checks.share("share of tails", tails);
    }
  }

  /**
   * A robot with changes.
   *
   * @param robot as it is believed to be
   * @param seeing how the tracker scatters
   * @param changes what is at work, which is sorted by its stages
   */
  public MotionWorld(Robot robot, Seeing seeing, List<MotionChange> changes) {
    this.robot = robot;
    this.seeing = seeing;
    this.changes =
        Stream.concat(believed(robot.beliefs()).stream(), changes.stream())
            .sorted(Comparator.comparing(MotionChange::stage))
            .toList();
  }

  /** The robot as it is believed to be, before a tracker as it is said to be. */
  public static MotionWorld nominal(Robot robot) {
    return new MotionWorld(robot, new Seeing(robot.tracker(), 0), List.of());
  }

  /** What a simulator that believes this does. */
  private static List<MotionChange> believed(Robot.Beliefs beliefs) {
    List<MotionChange> own = new ArrayList<>();
    double least = Math.min(beliefs.maxSpeedMPerS(), beliefs.maxTurnRadPerS());
    if (least < Double.POSITIVE_INFINITY) {
      own.add(
          MotionChange.commands(
              s ->
                  new Commands.Speeds(
                      within(s.vMPerS(), beliefs.maxSpeedMPerS()),
                      within(s.wRadPerS(), beliefs.maxTurnRadPerS()))));
    }
    if (beliefs.latencyS() > 0) {
      own.add(MotionChange.latency(beliefs.latencyS()));
    }
    if (beliefs.timeConstantS() > 0) {
      own.add(Lag.firstOrder(beliefs.timeConstantS(), beliefs.timeConstantS()));
    }
    return own;
  }

  private static double within(double value, double most) {
    return Math.max(-most, Math.min(most, value));
  }

  /** What the tracker says of the robot on an outing, by chance of this seed. */
  public Track drive(Outing outing, long seed) {
    Chance random = new Chance(seed);
    List<Acting> acting = new ArrayList<>();
    for (MotionChange change : changes) {
      acting.add(change.begin().apply(random.split()));
    }
    Track track = new Track();
    Step step = new Step(outing.durationS());
    double before = 0;
    for (Outing.Run run : outing.runs()) {
      acting.forEach(Acting::beginRun);
      new OneRun(run, step, acting, before).drive(track.begin(run.frames()), random);
      before += run.endS() - run.beginS();
    }
    return track;
  }

  /** One run of a repeat. */
  private final class OneRun {
    private final Outing.Run run;
    private final Step step;
    private final List<Acting> acting;
    private final double beforeS;
    private final Sight sight = new Sight();
    private double x;
    private double z;
    private double heading;
    private double cos;
    private double sin;

    OneRun(Outing.Run run, Step step, List<Acting> acting, double beforeS) {
      this.run = run;
      this.step = step;
      this.acting = acting;
      this.beforeS = beforeS;
    }

    void drive(double[][] poses, Chance random) {
      Commands heard = run.commands();
      for (MotionChange change : changes) {
        heard = change.heard().apply(heard, random.split());
      }
      Path path = path(heard.means());
      Chance luck = random.split();
      for (int frame = 0; frame < run.frames(); frame++) {
        see(path, run.frameS(frame));
        double tail = seeing.tails() > 0 && luck.nextDouble() < seeing.tails() ? 3 : 1;
        double position = tail * seeing.scatter().positionM();
        double turn = tail * seeing.scatter().headingRad();
        poses[0][frame] = sight.xM() + (position > 0 ? position * luck.nextGaussian() : 0);
        poses[1][frame] = sight.zM() + (position > 0 ? position * luck.nextGaussian() : 0);
        poses[2][frame] = sight.headingRad() + (turn > 0 ? turn * luck.nextGaussian() : 0);
      }
    }

    private void see(Path path, double frameS) {
      double ago = 0;
      double share = (beforeS + frameS - run.beginS()) / step.logS();
      for (Acting one : acting) {
        ago += one.agoS(frameS, share);
      }
      path.at(frameS - ago, sight);
      for (Acting one : acting) {
        one.see(sight);
      }
    }

    /** The true poses at the ends of the steps. */
    private Path path(Commands.Means means) {
      double begin = run.beginS();
      int steps = (int) Math.ceil((run.endS() - begin) / STEP_S);
      Path path = new Path(begin, steps + 1);
      x = run.start().xM();
      z = run.start().zM();
      heading = run.start().headingRad();
      cos = StrictMath.cos(heading);
      sin = StrictMath.sin(heading);
      path.put(0, x, z, heading);
      step.set(0, 0);
      step.end();
      for (int i = 0; i < steps; i++) {
        double at = begin + i * STEP_S;
        step.begin(at, STEP_S, beforeS + i * STEP_S, means.over(at, STEP_S));
        step.place(x, z, cos, sin);
        for (Acting one : acting) {
          one.move(step);
        }
        step.end();
        advance();
        path.put(i + 1, x, z, heading);
      }
      return path;
    }

    /**
     * An arc: the chord of an arc of angle a and length s is s sin(a/2)/(a/2), at half the angle.
     * Sine and cosine of half the angle by their series, exact to 3e-11 for a turn rate of 5 rad/s.
     */
    private void advance() {
      double half = step.w() * STEP_S / 2;
      double square = half * half;
      double sinc = 1 - square / 6 + square * square / 120;
      double sine = half * sinc;
      double cosine = 1 - square / 2 + square * square / 24;
      double midCos = cos * cosine - sin * sine;
      double midSin = sin * cosine + cos * sine;
      double along = step.v() * STEP_S * sinc;
      double left = step.left() * STEP_S * sinc;
      x += along * midCos - left * midSin + step.driftX() * STEP_S;
      z += -along * midSin - left * midCos + step.driftZ() * STEP_S;
      double length = (3 - (midCos * midCos + midSin * midSin)) / 2;
      cos = (midCos * cosine - midSin * sine) * length;
      sin = (midSin * cosine + midCos * sine) * length;
      heading += 2 * half;
    }
  }

  /** Poses at even times, straight between them; before the first and after the last it stands. */
  private static final class Path {
    private final double beginS;
    private final double[] xs;
    private final double[] zs;
    private final double[] headings;

    Path(double beginS, int size) {
      this.beginS = beginS;
      this.xs = new double[size];
      this.zs = new double[size];
      this.headings = new double[size];
    }

    void put(int index, double x, double z, double heading) {
      xs[index] = x;
      zs[index] = z;
      headings[index] = heading;
    }

    void at(double timeS, Sight sight) {
      double place = Math.max(0, Math.min(xs.length - 1.0, (timeS - beginS) / STEP_S));
      int low = (int) Math.min(xs.length - 2.0, Math.floor(place));
      double share = place - low;
      sight.set(
          xs[low] + share * (xs[low + 1] - xs[low]),
          zs[low] + share * (zs[low + 1] - zs[low]),
          headings[low] + share * (headings[low + 1] - headings[low]));
    }
  }

  /** What the simulator believes of the robot. */
  public Robot robot() {
    return robot;
  }
}
