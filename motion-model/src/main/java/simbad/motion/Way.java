package simbad.motion;

import java.util.List;
import simbad.sonar.check.Checks;

/**
 * The way that a robot goes by a model through a run: the whole run's poses on a grid of 20 ms,
 * computed once; displacements between any two times are then read off.
 */
public final class Way {
  /** Between two poses of the grid, seconds. */
  public static final double STEP_S = 0.02;

  /** Rounding of so many rotations stays beneath any use. */
  private static final int AFRESH = 256;

  private final double startS;
  private final double[] xs;
  private final double[] ys;
  private final double[] headings;
  private final Capture capture;
  private final Facing facing = new Facing();

  private Way(double startS, int size, Capture capture) {
    this.startS = startS;
    this.capture = capture;
    xs = new double[size];
    ys = new double[size];
    headings = new double[size];
  }

  /**
   * Computes the way of a whole run, from its first command to a second after its track.
   *
   * @param run of which the track says only how long it is
   * @param chain how the robot moves
   */
  public static Way of(MotionRun run, MotionChain chain) {
    double from = run.commands().get(0).timeS();
    double to = run.track().isEmpty() ? from : run.track().get(run.track().size() - 1).timeS();
    return of(run, chain, from, Math.max(from, to) + 1);
  }

  /**
   * Computes the way.
   *
   * @param run of which the commands are used, never the track
   * @param chain how the robot moves
   * @param fromS where the way begins; the robot stands there unless commands hold before
   * @param toS where it ends, not before fromS
   */
  public static Way of(MotionRun run, MotionChain chain, double fromS, double toS) {
    Checks.atLeast("toS", toS, Checks.finite("fromS", fromS));
    int size = size(fromS, toS);
    Way way = new Way(fromS, size, chain.capture());
    Stages stages = Stages.of(chain);
    CommandSeries means =
        CommandSeries.of(
            Held.of(run.commands()).taken(List.of(stages.commands())),
            fromS - chain.delayS(),
            size);
    means.follow(chain.responses());
    way.drive(stages, means);
    return way;
  }

  private void drive(Stages stages, CommandSeries means) {
    for (int i = 1; i < xs.length; i++) {
      double speed = stages.speed(means.speeds()[i], means.turns()[i]);
      step(i, speed, stages.turn(means.turns()[i], speed));
    }
  }

  /** The chord of the step's arc. */
  private void step(int i, double speedMPerS, double turnRadPerS) {
    facing.turn(turnRadPerS * STEP_S);
    double way = speedMPerS * STEP_S * facing.chord();
    xs[i] = xs[i - 1] + way * facing.middleX();
    ys[i] = ys[i - 1] + way * facing.middleY();
    headings[i] = headings[i - 1] + turnRadPerS * STEP_S;
    if (i % AFRESH == 0 || !facing.isExact()) {
      facing.face(headings[i]);
    }
  }

  /**
   * Returns what the tracker would report of the way between two times.
   *
   * @param fromS within the way
   * @param toS within the way
   */
  public Displacement between(double fromS, double toS) {
    return capture.of(Displacement.between(at(fromS), at(toS)));
  }

  private TrackPose at(double timeS) {
    double place = place(timeS, startS, xs.length);
    int i = (int) place;
    double share = place - i;
    return new TrackPose(
        timeS,
        xs[i] + share * (xs[i + 1] - xs[i]),
        ys[i] + share * (ys[i + 1] - ys[i]),
        headings[i] + share * (headings[i + 1] - headings[i]));
  }

  /** Returns where a time stands on a grid of so many poses: the pose before it, and a share. */
  static double place(double timeS, double startS, int size) {
    return Math.max(0, Math.min(size - 1.000001, (timeS - startS) / STEP_S));
  }

  /** Returns of how many poses a grid is that reaches over a time. */
  static int size(double fromS, double toS) {
    return (int) Math.ceil((toS - fromS) / STEP_S) + 2;
  }
}
