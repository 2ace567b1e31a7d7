package simbad.sim;

import java.util.Arrays;
import simbad.kernel.belt.BeltLayout;
import simbad.kernel.geometry.Placement;
import simbad.sonar.sensing.TransducerPoses;

/** What the drawing of a sensor's rays goes by. */
final class SensorBeams {
  /** Share of a ray that is drawn while it has no echo. */
  private static final double STUB = 0.05;

  private SensorBeams() {}

  /** Returns where the rays start and point, in the sensor's own frame. */
  static TransducerPoses poses(BeltLayout layout) {
    TransducerPoses poses = new TransducerPoses(layout.size());
    layout.place(new Placement(), poses);
    return poses;
  }

  /**
   * Returns the bearing of each sensor as seen from above, counter-clockwise from straight ahead:
   * of its place, or of its direction if it sits in the middle.
   */
  static double[] anglesRad(BeltLayout layout) {
    TransducerPoses poses = poses(layout);
    double[] anglesRad = new double[layout.size()];
    // 0 - z, not -z: straight back is pi, not -pi.
    Arrays.setAll(
        anglesRad,
        i ->
            Math.hypot(poses.xM(i), poses.zM(i)) > 0
                ? Math.atan2(0.0 - poses.zM(i), poses.xM(i))
                : Math.atan2(0.0 - poses.directionZ(i), poses.directionX(i)));
    return anglesRad;
  }

  /** Returns how long each ray is drawn without an echo, metres. */
  static double[] idleLengthsM(BeltLayout layout, boolean full) {
    double[] lengthM = new double[layout.size()];
    Arrays.setAll(lengthM, i -> layout.lengthM(i) * (full ? 1 : STUB));
    return lengthM;
  }
}
