package simbad.gap.calibrate.level;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import simbad.gap.calibrate.level.Trials.Trial;
import simbad.sonar.catalogue.LevelForms;
import simbad.sonar.frame.Angles;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.Scene;

/**
 * What a scene's cone says of the beam: at its border an obstacle is just lost at half of its
 * threshold and at three quarters. A reference often holds nothing between the axis and that.
 */
final class Cones {
  private static final double[] SHARES = {0.5, 0.75};
  private static final int BEARINGS = 3;

  /** So near to each other bearings say the same. */
  private static final int APART = 4;

  /** Of one border: a cone is read off for some target at some distance to two or three degrees. */
  static final double DEVIATION_DB = 3;

  private Cones() {}

  /**
   * Reads a cone: places where the excess is 0 dB.
   *
   * @param scene its obstacles
   * @param halfAngleRad of the cone; from a quarter turn on it says nothing
   */
  static List<Trial> of(Scene scene, double halfAngleRad) {
    List<Trial> all = new ArrayList<>();
    if (halfAngleRad < Math.PI / 2) {
      for (int target = 0; target < scene.obstacles().size(); target++) {
        add(scene.obstacles().get(target), target, halfAngleRad, all);
      }
    }
    return all;
  }

  private static void add(Obstacle obstacle, int target, double halfAngleRad, List<Trial> into) {
    List<Integer> chosen = new ArrayList<>();
    List<Integer> strongest =
        IntStream.range(0, LevelForms.BEARINGS)
            .boxed()
            .sorted(Comparator.comparingDouble(i -> -obstacle.detection().thresholdM(rad(i))))
            .toList();
    for (int i : strongest) {
      double threshold = obstacle.detection().thresholdM(rad(i));
      boolean apart = chosen.stream().allMatch(other -> steps(i, other) >= APART);
      if (threshold > Believed.WEAK_M && apart && chosen.size() < BEARINGS) {
        chosen.add(i);
        for (double share : SHARES) {
          double r = share * threshold;
          into.add(new Trial(-1, target, rad(i), r, r, halfAngleRad, false, 0, 1, 0));
        }
      }
    }
  }

  private static int steps(int one, int other) {
    int apart = Math.abs(one - other);
    return Math.min(apart, LevelForms.BEARINGS - apart);
  }

  private static double rad(int bearing) {
    return bearing * Angles.TURN_RAD / LevelForms.BEARINGS;
  }
}
