package simbad.motion;

import simbad.sonar.check.Checks;

/**
 * The way that a robot goes by a model through a run: the whole run's poses on a grid of 20 ms,
 * computed once; displacements between any two times are then read off.
 */
public final class Way {
  /** Between two poses of the grid, seconds. */
  public static final double STEP_S = 0.02;

  /** Below it an arc is its chord. */
  private static final double STRAIGHT_RAD = 1e-6;

  /** Up to it the sine's series needs five terms. */
  private static final double SMALL_RAD = 0.1;

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
    CommandSeries series = new CommandSeries(stages.commanded(run.commands()));
    way.drive(series, stages, chain.delayS(), chain.response().over(STEP_S));
    return way;
  }

  private void drive(CommandSeries series, Stages stages, double late, Response.Step follow) {
    int index = series.index(startS - late);
    double way = series.way(index, startS - late);
    double angle = series.angle(index, startS - late);
    double speed = 0;
    double turn = 0;
    for (int i = 1; i < xs.length; i++) {
      double timeS = startS + i * STEP_S - late;
      index = series.forward(index, timeS);
      double nextWay = series.way(index, timeS);
      double nextAngle = series.angle(index, timeS);
      double toSpeed = (nextWay - way) / STEP_S;
      double toTurn = (nextAngle - angle) / STEP_S;
      double nextSpeed = follow.speed().next(speed, toSpeed);
      double nextTurn = follow.turn().next(turn, toTurn);
      double speedOverGround = stages.speed(follow.speed().mean(speed, toSpeed, nextSpeed));
      double turned = follow.turn().mean(turn, toTurn, nextTurn);
      step(i, speedOverGround, stages.turn(turned, speedOverGround));
      speed = nextSpeed;
      turn = nextTurn;
      way = nextWay;
      angle = nextAngle;
    }
  }

  /**
   * The chord of the step's arc. The direction is turned on by a rotation instead of asked anew: a
   * log has tens of thousands of steps, and a search drives it thousands of times.
   */
  private void step(int i, double speedMPerS, double turnRadPerS) {
    double half = turnRadPerS * STEP_S / 2;
    double sin = sine(half);
    double cos = Math.abs(half) >= SMALL_RAD ? Math.cos(half) : Math.sqrt(1 - sin * sin);
    double chord = speedMPerS * STEP_S * (Math.abs(half) < STRAIGHT_RAD ? 1 : sin / half);
    double middleX = directionX * cos - directionY * sin;
    double middleY = directionX * sin + directionY * cos;
    xs[i] = xs[i - 1] + chord * middleX;
    ys[i] = ys[i - 1] + chord * middleY;
    headings[i] = headings[i - 1] + turnRadPerS * STEP_S;
    directionX = middleX * cos - middleY * sin;
    directionY = middleX * sin + middleY * cos;
    if (i % AFRESH == 0 || Math.abs(half) >= SMALL_RAD) {
      directionX = Math.cos(headings[i]);
      directionY = Math.sin(headings[i]);
    }
  }

  /** Exact to the last digit or two. */
  private static double sine(double rad) {
    if (Math.abs(rad) >= SMALL_RAD) {
      return Math.sin(rad);
    }
    double square = rad * rad;
    return rad * (1 - square / 6 * (1 - square / 20 * (1 - square / 42 * (1 - square / 72))));
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
