package simbad.blindworld.effect;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.random.RandomGenerator;
import simbad.blindworld.effect.Form.Drawn;
import simbad.blindworld.world.Change;
import simbad.blindworld.world.Pose;
import simbad.blindworld.world.Recording;

/**
 * Placement errors: what is put in place by hand stands a little elsewhere, each time by its own
 * amount. All readings that are taken there have the same error.
 */
final class PlacementForms {

  /** As a tape is read in passing: standard deviation. */
  private static final double PRACTICAL_M = 0.01;

  /** Nobody is further off than this many standard deviations. */
  private static final double MOST_DEVIATIONS = 2.5;

  private PlacementForms() {}

  static List<Form> all(String name) {
    return List.of(
        new Form(name, "any way", Circumstances::placed, c -> nudged(c, PlacementForms::anyWay)),
        new Form(name, "along", Circumstances::placed, c -> nudged(c, PlacementForms::along)));
  }

  /** Where a pose really is, for a standard deviation in metres. */
  private interface Nudge {
    Pose of(Pose pose, double deviationM, RandomGenerator random);
  }

  private static Drawn nudged(Circumstances c, Nudge nudge) {
    double deviationM = c.sized(PRACTICAL_M);
    Change change =
        new Change() {
          @Override
          public boolean restless() {
            return true;
          }

          @Override
          public List<Pose> poses(Recording recording, List<Pose> poses, RandomGenerator random) {
            List<Pose> moved = new ArrayList<>(poses);
            for (List<Integer> placement : recording.placements()) {
              Pose believed = poses.get(placement.get(0));
              Pose real = nudge.of(believed, deviationM, random);
              double dxM = real.xM() - believed.xM();
              double dzM = real.zM() - believed.zM();
              for (int row : placement) {
                Pose pose = poses.get(row);
                moved.set(row, pose.at(pose.xM() + dxM, pose.zM() + dzM));
              }
            }
            return moved;
          }
        };
    return new Drawn(Map.of("deviation_m", deviationM), change);
  }

  private static double limited(double deviations) {
    return Math.max(-MOST_DEVIATIONS, Math.min(MOST_DEVIATIONS, deviations));
  }

  private static Pose anyWay(Pose pose, double deviationM, RandomGenerator random) {
    double dx = deviationM * limited(random.nextGaussian());
    double dz = deviationM * limited(random.nextGaussian());
    return pose.at(pose.xM() + dx, pose.zM() + dz);
  }

  /** Evenly to and fro on the axis, as a tape that is read to its nearest mark. */
  private static Pose along(Pose pose, double deviationM, RandomGenerator random) {
    double onM = deviationM * Math.sqrt(3) * (2 * random.nextDouble() - 1);
    return pose.at(
        pose.xM() + onM * StrictMath.cos(pose.headingRad()),
        pose.zM() - onM * StrictMath.sin(pose.headingRad()));
  }
}
