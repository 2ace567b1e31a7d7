package simbad.motion;

import simbad.sonar.check.Checks;

/**
 * How a pose lies to one before it, in the frame of that one.
 *
 * @param alongM metres along the first heading
 * @param acrossM metres to its left
 * @param turnRad counter-clockwise
 */
public record Displacement(double alongM, double acrossM, double turnRad) {
  /** Checks that all are numbers. */
  public Displacement {
    Checks.number("alongM", alongM);
    Checks.number("acrossM", acrossM);
    Checks.number("turnRad", turnRad);
  }

  /**
   * Returns how the second pose lies to the first.
   *
   * @param from pose at the start
   * @param to pose at the end
   */
  public static Displacement between(TrackPose from, TrackPose to) {
    double x = to.xM() - from.xM();
    double y = to.yM() - from.yM();
    double cos = Math.cos(from.headingRad());
    double sin = Math.sin(from.headingRad());
    return new Displacement(
        x * cos + y * sin, y * cos - x * sin, to.headingRad() - from.headingRad());
  }

  /** Returns a component: 0 along, 1 across, 2 turn. */
  public double component(int index) {
    return switch (index) {
      case 0 -> alongM;
      case 1 -> acrossM;
      case 2 -> turnRad;
      default -> throw new IllegalArgumentException("index = " + index + " is not in [0, 2]");
    };
  }
}
