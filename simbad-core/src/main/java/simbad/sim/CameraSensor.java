package simbad.sim;

/** A camera. {@link RobotFactory#addCameraSensor(Agent)} makes the usual one. */
public class CameraSensor extends Eye {
  /**
   * Creates a camera that looks ahead.
   *
   * @param radius radius and height of its housing, metres
   * @param width columns of its image
   * @param height rows of its image
   */
  CameraSensor(float radius, int width, int height) {
    super(radius, width, height);
  }
}
