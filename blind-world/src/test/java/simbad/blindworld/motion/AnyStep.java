package simbad.blindworld.motion;

/** Steps and sights for changes, as a world would begin them. */
public final class AnyStep {

  private static final double LOG_S = 100;

  private AnyStep() {}

  /** A step of a robot at the origin that looks along x, the first of a log. */
  public static Step told(double v, double w) {
    return told(v, w, 0);
  }

  /** The same after a share of the log. */
  public static Step told(double v, double w, double logShare) {
    Step step = new Step(LOG_S);
    next(step, v, w);
    step.begin(LOG_S * logShare, MotionWorld.STEP_S, LOG_S * logShare, new Commands.Speeds(v, w));
    return step;
  }

  /** A step of a robot somewhere else. */
  public static Step at(double xM, double zM, double headingRad, double v) {
    Step step = told(v, 0);
    step.place(xM, zM, Math.cos(headingRad), Math.sin(headingRad));
    return step;
  }

  /** A step of a robot that has made a way. */
  public static Step after(double wayM, double v, double w) {
    Step step = told(wayM / MotionWorld.STEP_S, 0);
    step.end();
    next(step, v, w);
    return step;
  }

  /** Begins the next step, in which something else is told. */
  public static void next(Step step, double v, double w) {
    step.begin(0, MotionWorld.STEP_S, 0, new Commands.Speeds(v, w));
    step.place(0, 0, 1, 0);
  }

  /** The speeds over the floor by which a step is moved besides: to the right, down the page. */
  public static double[] drift(Step step) {
    return new double[] {step.driftX(), step.driftZ()};
  }

  /** A pose that a tracker sees. */
  public static Sight seen(double xM, double zM, double headingRad) {
    Sight sight = new Sight();
    sight.set(xM, zM, headingRad);
    return sight;
  }
}
