package simbad.motion;

/**
 * A change of the chain command, speeds, displacement, tracked displacement. What a change does not
 * say stays as it is, to the bit. Changes are values and may be shared.
 */
public interface MotionChange {
  /** Changes a commanded speed, m/s. */
  default double commandedSpeed(double speedMPerS) {
    return speedMPerS;
  }

  /** Changes a commanded rate of turning, rad/s. */
  default double commandedTurn(double turnRadPerS) {
    return turnRadPerS;
  }

  /** Changes a command: its speed and its rate each by itself, unless a change says otherwise. */
  default Command commanded(Command command) {
    double speed = commandedSpeed(command.speedMPerS());
    double turn = commandedTurn(command.turnRadPerS());
    boolean same = speed == command.speedMPerS() && turn == command.turnRadPerS();
    return same ? command : new Command(command.timeS(), speed, turn);
  }

  /**
   * Changes a command that comes after another one: what sticks needs more to start than to go on.
   *
   * @param command as the changes before left it
   * @param before what this change made of the command before; at first one that stands
   */
  default Command commanded(Command command, Command before) {
    return commanded(command);
  }

  /** Tells whether what was commanded before makes a difference. */
  default boolean remembers() {
    return false;
  }

  /** Changes by how many seconds commands act late. */
  default double delayS(double delayS) {
    return delayS;
  }

  /** Changes how speeds follow commands. */
  default Response response(Response response) {
    return response;
  }

  /** Tells how speeds follow, in turn, what the responses before made of commands. */
  default Response then() {
    return Response.AT_ONCE;
  }

  /**
   * Changes the speed over ground, m/s.
   *
   * @param speedMPerS as the changes before left it
   * @param turnRadPerS rate at which the drive turns, before any change
   */
  default double speed(double speedMPerS, double turnRadPerS) {
    return speedMPerS;
  }

  /**
   * Changes the rate of turning over ground, rad/s.
   *
   * @param turnRadPerS as the changes before left it
   * @param speedMPerS over ground
   */
  default double turn(double turnRadPerS, double speedMPerS) {
    return turnRadPerS;
  }

  /** Changes what the tracker reports. */
  default Capture capture(Capture capture) {
    return capture;
  }
}
