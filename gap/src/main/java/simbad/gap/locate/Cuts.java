package simbad.gap.locate;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import simbad.gap.slice.Axis;
import simbad.gap.slice.Nearest;
import simbad.gap.slice.Slice;
import simbad.sonar.frame.Placement;
import simbad.sonar.ping.Geometry;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.Obstacle;

/**
 * The ways to cut a log that places are looked for in, declared before any reading is looked at. A
 * ping belongs to the obstacle that is nearest in the cone; where none is, to the one whose centre
 * is. Bearing, distance (to the centre) and off-axis angle are of that obstacle.
 */
final class Cuts {
  private static final double BEARING_STEP_DEG = 5;

  // Differences that are no more than the last digits of poses (0.1 mm, 0.001 degrees), or what
  // these make of a speed at 50 ms and of an angle at 10 cm.
  private static final double SAME_S = 1e-3;
  private static final double SAME_M = 1e-3;
  private static final double SAME_M_PER_S = 5e-3;
  private static final double SAME_DEG = 0.1;

  private final PingLog log;
  private final Geometry geometry;
  private final int[] obstacle;

  private Cuts(Geometry geometry) {
    this.geometry = geometry;
    log = geometry.log();
    obstacle = IntStream.range(0, log.size()).map(ping -> Nearest.of(geometry, ping)).toArray();
  }

  /** Returns all cuts: by one variable first, the names before the numbers, then by two. */
  static List<Scan.Cut> of(Geometry geometry) {
    return new Cuts(geometry).all();
  }

  private int line(int ping) {
    return ping * geometry.obstacles() + obstacle[ping];
  }

  private List<Scan.Cut> all() {
    int size = log.size();
    List<Scan.Cut> cuts = new ArrayList<>();
    Axis sensor = Axis.named("sensor", size, log.sensors(), log::sensor);
    Axis run = Axis.named("run", size, log.runs(), log::run);
    Axis time = Axis.numbered("t_s", size, log::timeS, SAME_S);
    Axis speed = Axis.numbered("speed_m_s", size, log::speedMPerS, SAME_M_PER_S);
    single(cuts, sensor);
    single(cuts, run);
    if (geometry.obstacles() > 0) {
      obstacles(cuts, sensor, time, speed);
    }
    single(cuts, time);
    single(cuts, speed);
    pair(cuts, sensor, time);
    pair(cuts, run, time);
    return cuts;
  }

  private void obstacles(List<Scan.Cut> cuts, Axis sensor, Axis time, Axis speed) {
    int size = log.size();
    List<Obstacle> all = geometry.scene().obstacles();
    Axis which =
        Axis.named("obstacle", size, all.stream().map(Obstacle::name).toList(), i -> obstacle[i]);
    Axis distance =
        Axis.numbered("distance_m", size, i -> geometry.centreDistanceM(line(i)), SAME_M);
    Axis offAxis =
        Axis.numbered(
            "off_axis_deg", size, i -> Math.toDegrees(geometry.offAxisRad(line(i))), SAME_DEG);
    single(cuts, which);
    single(cuts, distance);
    single(cuts, offAxis);
    for (int o = 0; o < all.size(); o++) {
      bearings(cuts, which, o, distance);
    }
    pair(cuts, distance, offAxis);
    pair(cuts, which, distance);
    pair(cuts, which, offAxis);
    pair(cuts, which, time);
    pair(cuts, sensor, distance);
    pair(cuts, sensor, offAxis);
    pair(cuts, distance, time);
    pair(cuts, distance, speed);
    pair(cuts, offAxis, speed);
  }

  /** A bearing means little without the obstacle that it is seen from. */
  private void bearings(List<Scan.Cut> cuts, Axis which, int index, Axis distance) {
    Slice none = new Slice(List.of());
    Slice within = which.count() == 1 ? none : none.and(new Slice.Range(which, index, index + 1));
    Placement place = geometry.scene().obstacles().get(index).worldFromObstacle();
    Axis bearing =
        Axis.numbered(
            "bearing_deg",
            log.size(),
            BEARING_STEP_DEG,
            i -> Math.toDegrees(place.bearingRad(log.xM(i), log.zM(i))));
    cuts.add(new Scan.Cut(within, List.of(bearing)));
    cuts.add(new Scan.Cut(within, List.of(bearing, distance)));
  }

  /** Of a variable that can tell pings apart. */
  private static void single(List<Scan.Cut> cuts, Axis axis) {
    if (axis.count() > 1) {
      cuts.add(new Scan.Cut(new Slice(List.of()), List.of(axis)));
    }
  }

  /** Of two variables that both can tell pings apart. */
  private static void pair(List<Scan.Cut> cuts, Axis one, Axis other) {
    if (one.count() > 1 && other.count() > 1) {
      cuts.add(new Scan.Cut(new Slice(List.of()), List.of(one, other)));
    }
  }
}
