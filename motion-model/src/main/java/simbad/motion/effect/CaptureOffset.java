package simbad.motion.effect;

import java.util.List;
import simbad.motion.Capture;
import simbad.motion.MotionChange;

/** The tracked point is not the robot's centre, or the tracker's heading is turned. */
record CaptureOffset(double forwardM, double leftM, double headingRad) implements MotionChange {
  static final MotionForm POINT =
      new MotionForm(
          "capture-offset",
          "capture-offset: point",
          List.of(
              MotionParameter.smooth("forward_m", -1, 1, 0, 0.005),
              MotionParameter.smooth("left_m", -1, 1, 0, 0.005)),
          p -> new CaptureOffset(p[0], p[1], 0),
          "the tracked point is %s m ahead of the robot's centre",
          false);
  static final MotionForm HEADING =
      new MotionForm(
          "capture-offset",
          "capture-offset: heading",
          List.of(
              MotionParameter.smooth("heading_rad", -3.2, 3.2, 0, 0.01).tried(0, 1.6, -1.6, 3.1)),
          p -> new CaptureOffset(0, 0, p[0]),
          "subtract %s rad from the tracker's heading",
          false);

  @Override
  public Capture capture(Capture before) {
    return new Capture(
        before.forwardM() + forwardM, before.leftM() + leftM, before.headingRad() + headingRad);
  }
}
