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

  private record Motion(Command command, int steps) {}

  private final List<Motion> motions = new ArrayList<>();
  private boolean looping;
  private boolean running;
  private int current;
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
    add(new Command(distanceM / durationS, 0), durationS);
  }

  /**
   * Appends a turn on the spot.
   *
   * @param angleRad radians, counter-clockwise
   * @param durationS seconds; the steps are this times 20, rounded down
   */
  public void turn(double angleRad, double durationS) {
    add(new Command(0, angleRad / durationS), durationS);
  }

  /** Motions too short for a step are left out: they would move nothing. */
  private void add(Command command, double durationS) {
    int steps = (int) (durationS * STEPS_PER_S);
    if (steps > 0) {
      motions.add(new Motion(command, steps));
    }
  }

  /** Begins again after the last motion, for ever. */
  public void loop() {
    looping = true;
  }

  /** Goes back to the first motion and starts. */
  public void reset() {
    running = true;
    current = 0;
    stepsDone = 0;
  }

  /** Returns true if the plan was started and has a motion left. */
  public boolean isRunning() {
    return running && current < motions.size();
  }

  /**
   * Lets a step pass.
   *
   * @return what to do in this step; {@link Command#STOP} before the start and after the end
   */
  public Command next() {
    if (!isRunning()) {
      return Command.STOP;
    }
    Motion motion = motions.get(current);
    stepsDone++;
    if (stepsDone == motion.steps) {
      stepsDone = 0;
      current++;
      current = looping && current == motions.size() ? 0 : current;
    }
    return motion.command;
  }
}
