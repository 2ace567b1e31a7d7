package simbad.motion;

/**
 * What a robot was told, held until the next command of its run.
 *
 * @param timeS when, seconds
 * @param speedMPerS along the heading
 * @param turnRadPerS counter-clockwise
 */
public record Command(double timeS, double speedMPerS, double turnRadPerS) {
  /** Of a robot that stands. */
  public static final Command STAND = new Command(0, 0, 0);

  /** Checks that all are finite. */
  public Command {
    if (!Double.isFinite(timeS + speedMPerS + turnRadPerS)) {
      throw new IllegalArgumentException(
          "command = (" + timeS + ", " + speedMPerS + ", " + turnRadPerS + ") is not finite");
    }
  }

  /** Tells whether another command asks for the same, whenever it was given. */
  public boolean asksTheSameAs(Command other) {
    return speedMPerS == other.speedMPerS && turnRadPerS == other.turnRadPerS;
  }
}
