package simbad.sim;

import simbad.kernel.motion.MotionPlan;
import simbad.kernel.motion.WheelCommand;

/** A list of motions that an agent goes through, a step at each {@link #doStep()}. */
public class Plan {
  private final Agent agent;
  private final MotionPlan motions = new MotionPlan();
  private boolean ended;

  /** Creates an empty plan for an agent; it does nothing until {@link #reset()} is called. */
  public Plan(Agent agent) {
    this.agent = agent;
  }

  /** Goes back to the first motion and starts. */
  public void reset() {
    motions.reset();
  }

  /** Appends a turn on the spot by an angle in radians that takes a duration in seconds. */
  public void turn(double angle, double duration) {
    motions.turn(angle, duration);
  }

  /** Appends a way in metres along the heading that takes a duration in seconds. */
  public void forward(double distance, double duration) {
    motions.forward(distance, duration);
  }

  /** Begins again after the last motion. */
  public void loop() {
    motions.loop();
  }

  /** Sets the agent's velocities for this step; stops it once, after the last motion. */
  public void doStep() {
    motions.setLagging(motions.tellsLagging() && agent.meets(Compatibility.PLANS_TIME_BY_PREVIOUS));
    boolean wasRunning = motions.isRunning();
    if (wasRunning || ended) {
      apply(motions.next());
    }
    ended = wasRunning && !motions.isRunning();
  }

  private void apply(WheelCommand command) {
    agent.setTranslationalVelocity(command.speedMPerS());
    agent.setRotationalVelocity(command.turnRadPerS());
  }
}
