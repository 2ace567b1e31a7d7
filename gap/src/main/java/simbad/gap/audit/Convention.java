package simbad.gap.audit;

import java.util.ArrayList;
import java.util.List;
import simbad.sonar.frame.Pose;

/**
 * Another way to write poses down, and how it is brought to the scene's: positions first, then
 * headings.
 *
 * @param words what was done instead
 * @param mend options of {@code dataset mend}
 * @param steps one after the other
 */
record Convention(String words, String mend, List<Step> steps) {

  /** Brings a pose nearer to the scene's frame. */
  interface Step {
    Pose mended(Pose pose);
  }

  private static final double[] UNITS = {0.01, 0.001, 0.0254, 0.3048, 100, 1000};

  /** Simple ones first: of those that do the same the first is named. */
  static List<Convention> all() {
    List<Convention> all = new ArrayList<>();
    Convention flipZ = of("z points up the page", "--flip-z", p -> at(p, p.x(), -p.z()));
    Convention flipX = of("x points to the left", "--flip-x", p -> at(p, -p.x(), p.z()));
    Convention swap = of("x and z are exchanged", "--swap-xz", p -> at(p, p.z(), p.x()));
    Convention clockwise =
        of("headings turn clockwise", "--heading-clockwise", p -> to(p, -p.heading()));
    Convention radians =
        of("headings are radians", "--heading-radians", p -> to(p, Math.toDegrees(p.heading())));
    all.addAll(List.of(flipZ, clockwise, radians, flipX, swap));
    for (int deg : new int[] {90, -90, 180}) {
      all.add(offset(deg));
    }
    Convention compass = clockwise.and(offset(90));
    all.add(compass);
    all.addAll(List.of(radians.and(clockwise), flipZ.and(radians), flipZ.and(compass)));
    all.addAll(List.of(flipZ.and(clockwise), flipX.and(clockwise), swap.and(clockwise)));
    all.add(swap.and(compass));
    all.add(flipZ.and(offset(180)));
    all.add(clockwise.and(offset(180)));
    all.add(radians.and(clockwise).and(offset(90)));
    for (double unit : UNITS) {
      all.add(
          of(
              "positions are not in metres",
              "--pose-scale " + Say.number(unit),
              p -> at(p, unit * p.x(), unit * p.z())));
    }
    return all;
  }

  private static Convention offset(int deg) {
    return of(
        "headings count from elsewhere",
        "--heading-offset " + deg,
        p -> to(p, p.heading() + Math.toRadians(deg)));
  }

  /** A pose as plain numbers. */
  private record Plain(double x, double z, double heading) {}

  private interface Map {
    Pose mended(Plain pose);
  }

  private static Convention of(String words, String mend, Map map) {
    return new Convention(
        words,
        mend,
        List.of(
            pose ->
                map.mended(
                    new Plain(
                        pose.position().xM(), pose.position().zM(), pose.heading().radians()))));
  }

  private static Pose at(Plain pose, double x, double z) {
    return Pose.of(x, z, pose.heading());
  }

  private static Pose to(Plain pose, double heading) {
    return Pose.of(pose.x(), pose.z(), heading);
  }

  private Convention and(Convention next) {
    List<Step> both = new ArrayList<>(steps);
    both.addAll(next.steps);
    return new Convention(words + ", " + next.words, mend + " " + next.mend, both);
  }

  Pose mended(Pose pose) {
    Pose mended = pose;
    for (Step step : steps) {
      mended = step.mended(mended);
    }
    return mended;
  }
}
