package simbad.motion;

/**
 * The way that a robot goes by a model through a run: the whole run's poses on a grid of 20 ms,
 * computed once; displacements between any two times are then read off.
 */
public final class Way {
  /** Between two poses of the grid, seconds. */
  public static final double STEP_S = 0.02;

  private final double startS;
  private final double[] xs;
  private final double[] ys;
  private final double[] headings;
  private final Capture capture;

  private Way(double startS, int size, Capture capture) {
    this.startS = startS;
    this.capture = capture;
    xs = new double[size];
    ys = new double[size];
    headings = new double[size];
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
    int size = (int) Math.ceil((toS - fromS) / STEP_S) + 2;
    Way way = new Way(fromS, size, chain.capture());
    way.drive(new CommandSeries(run.commands(), chain), chain);
    return way;
  }

  private void drive(CommandSeries series, MotionChain chain) {
    Response response = chain.response();
    double late = chain.delayS();
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
      speed = response.speed(speed, (nextWay - way) / STEP_S, STEP_S);
      turn = response.turn(turn, (nextAngle - angle) / STEP_S, STEP_S);
      way = nextWay;
      angle = nextAngle;
      double speedOverGround = chain.speed(speed);
      step(i, speedOverGround, chain.turn(turn, speedOverGround));
    }
  }

  private void step(int i, double speedMPerS, double turnRadPerS) {
    double turn = turnRadPerS * STEP_S;
    double chord = speedMPerS * STEP_S * Unicycle.chordShare(turn);
    double heading = headings[i - 1] + turn / 2;
    xs[i] = xs[i - 1] + chord * Math.cos(heading);
    ys[i] = ys[i - 1] + chord * Math.sin(heading);
    headings[i] = headings[i - 1] + turn;
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
