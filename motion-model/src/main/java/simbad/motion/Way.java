package simbad.motion;

import simbad.sonar.check.Checks;

/**
 * The way that a robot goes by a model through a run: the whole run's poses on a grid of 20 ms,
 * computed once; displacements between any two times are then read off.
 */
public final class Way {
  /** Between two poses of the grid, seconds. */
  public static final double STEP_S = 0.02;

  /** Up to it the series of sine and cosine need five terms. */
  private static final double SMALL_RAD = 0.1;

  /** The last of the sine's. */
  private static final double LAST = 1.0 / 362880;

  /** Rounding of so many rotations stays beneath any use. */
  private static final int AFRESH = 256;

  private final double startS;
  private final double[] xs;
  private final double[] ys;
  private final double[] headings;
  private final Capture capture;
  private double directionX = 1;
  private double directionY;

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
    int size = (int) Math.ceil((toS - fromS) / STEP_S) + 2;
    Way way = new Way(fromS, size, chain.capture());
    Stages stages = Stages.of(chain);
    CommandSeries means =
        CommandSeries.of(stages.commanded(run.commands()), fromS - chain.delayS(), size);
    Response.Step follow = chain.response().over(STEP_S);
    follow.speed().follow(means.speeds());
    follow.turn().follow(means.turns());
    way.drive(stages, means);
    return way;
  }

  private void drive(Stages stages, CommandSeries means) {
    for (int i = 1; i < xs.length; i++) {
      double speed = stages.speed(means.speeds()[i]);
      step(i, speed, stages.turn(means.turns()[i], speed));
    }
  }

  /**
   * The chord of the step's arc. The direction is turned on by a rotation instead of asked anew: a
   * log has tens of thousands of steps, and a search drives it thousands of times.
   */
  private void step(int i, double speedMPerS, double turnRadPerS) {
    double half = turnRadPerS * STEP_S / 2;
    double square = half * half;
    boolean small = Math.abs(half) < SMALL_RAD;
    double chord = small ? chord(square) : Math.sin(half) / half;
    double sin = half * chord;
    double cos = small ? cosine(square) : Math.cos(half);
    double middleX = directionX * cos - directionY * sin;
    double middleY = directionX * sin + directionY * cos;
    double way = speedMPerS * STEP_S * chord;
    xs[i] = xs[i - 1] + way * middleX;
    ys[i] = ys[i - 1] + way * middleY;
    headings[i] = headings[i - 1] + turnRadPerS * STEP_S;
    directionX = middleX * cos - middleY * sin;
    directionY = middleX * sin + middleY * cos;
    if (i % AFRESH == 0 || !small) {
      directionX = Math.cos(headings[i]);
      directionY = Math.sin(headings[i]);
    }
  }

  /** An angle's sine over the angle, by its square; exact to the last digit or two. */
  private static double chord(double square) {
    return 1 + square * (-1.0 / 6 + square * (1.0 / 120 + square * (-1.0 / 5040 + square * LAST)));
  }

  /** The same of the cosine. */
  private static double cosine(double square) {
    return 1
        + square
            * (-1.0 / 2 + square * (1.0 / 24 + square * (-1.0 / 720 + square * (1.0 / 40320))));
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
    double place = Math.max(0, Math.min(xs.length - 1.000001, (timeS - startS) / STEP_S));
    int i = (int) place;
    double share = place - i;
    return new TrackPose(
        timeS,
        xs[i] + share * (xs[i + 1] - xs[i]),
        ys[i] + share * (ys[i + 1] - ys[i]),
        headings[i] + share * (headings[i + 1] - headings[i]));
  }
}
