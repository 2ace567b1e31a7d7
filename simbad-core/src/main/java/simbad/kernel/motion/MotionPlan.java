package simbad.kernel.motion;

import java.util.ArrayList;
import java.util.List;

/**
 * A list of motions, each of which lasts a whole number of steps, with no step lost between them.
 * Does nothing until it is reset for the first time.
 */
public final class MotionPlan {
  /** A plan counts twenty steps to the second, whatever the simulation does. */
  private static final int STEPS_PER_S = 20;

  private record Motion(WheelCommand command, int steps) {}

  private final List<Motion> motions = new ArrayList<>();
  private int loopingFrom;
  private boolean looping;
  private boolean lagging;
  private boolean running;
  private int current;
  private int before;
  private int stepsDone;

  /** Creates a plan without motions. */
  public MotionPlan() {}

  /**
   * Appends a straight motion.
   *
   * @param distanceM metres along the heading, negative to go back
   * @param durationS seconds; the steps are this times 20, rounded down
   */
  public void forward(double distanceM, double durationS) {
    add(distanceM / durationS, 0, durationS);
  }

  /**
   * Appends a turn on the spot.
   *
   * @param angleRad radians, counter-clockwise
   * @param durationS seconds; the steps are this times 20, rounded down
   */
  public void turn(double angleRad, double durationS) {
    add(0, angleRad / durationS, durationS);
  }

  /** Motions too short for a step are left out: they would move nothing. */
  private void add(double speedMPerS, double turnRadPerS, double durationS) {
    int steps = (int) (durationS * STEPS_PER_S);
    if (steps > 0) {
      motions.add(new Motion(new WheelCommand(speedMPerS, turnRadPerS), steps));
    }
  }

  /** Begins again after the last motion, for ever. */
  public void loop() {
    loopingFrom = looping ? loopingFrom : motions.size();
    looping = true;
  }

  /**
   * Lets each motion but the first last as long as the one before it should, lets the last one go
   * on for ever, and begins again where {@link #loop()} was called first, whatever follows there;
   * or not.
   */
  public void setLagging(boolean newLagging) {
    lagging = newLagging;
  }

  /**
   * Returns true if lagging is of consequence: the motions are of different lengths, or the plan
   * ends, or goes on behind its loop.
   */
  public boolean tellsLagging() {
    boolean even = motions.stream().mapToInt(Motion::steps).distinct().count() <= 1;
    return !motions.isEmpty() && !(even && looping && loopingFrom == motions.size());
  }

  /** Goes back to the first motion and starts. */
  public void reset() {
    running = true;
    current = 0;
    before = 0;
    stepsDone = 0;
  }

  /** Returns true if the plan was started and has a motion left. */
  public boolean isRunning() {
    return running && current < motions.size();
  }

  /**
   * Lets a step pass.
   *
   * @return what to do in this step; {@link WheelCommand#STOP} before the start and after the end
   */
  public WheelCommand next() {
    if (!isRunning()) {
      return WheelCommand.STOP;
    }
    Motion motion = motions.get(current);
    stepsDone++;
    if (stepsDone >= (lagging ? motions.get(Math.max(0, before)).steps : motion.steps)) {
      advance();
    }
    return motion.command;
  }

  private void advance() {
    int end = lagging && looping ? loopingFrom : motions.size();
    boolean last = current + 1 >= end;
    if (last && lagging && !looping) {
      return;
    }
    stepsDone = 0;
    before = current;
    current = last && looping ? 0 : current + 1;
  }
}
