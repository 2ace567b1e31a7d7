package simbad.blindworld.effect;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.IntFunction;
import java.util.function.ToDoubleFunction;
import java.util.random.RandomGenerator;
import simbad.blindworld.effect.Form.Drawn;
import simbad.blindworld.world.Change;
import simbad.blindworld.world.Pose;
import simbad.blindworld.world.Recording;
import simbad.blindworld.world.Track;

/** Effects on where the transducer really is: latency, odometry-scale, heading-drift. */
final class PoseForms {

  private PoseForms() {}

  static List<Form> all() {
    return List.of(
        Form.driven("latency", "seconds", PoseForms::latency),
        Form.driven("latency", "pings", PoseForms::latencyPings),
        Form.driven("latency", "jittered", PoseForms::latencyJittered),
        Form.driven("odometry-scale", "from the start", PoseForms::scale),
        Form.driven("odometry-scale", "along the path", PoseForms::scaleAlong),
        Form.driven("heading-drift", "in place", PoseForms::drift),
        Form.driven("heading-drift", "dead reckoning", PoseForms::driftReckoned),
        Form.driven("heading-drift", "levelling off", PoseForms::driftLevelling),
        Form.driven("heading-drift", "by the way", PoseForms::driftByWay));
  }

  /** What becomes of the poses of one track. */
  interface Course {
    List<Pose> of(Path path, RandomGenerator random);
  }

  /** One track's times and poses so far. */
  record Path(List<Double> timesS, List<Pose> poses) {

    int size() {
      return poses.size();
    }

    /** Where it was at a time, straight between pings and still before the first. */
    Pose at(double tS) {
      if (tS <= timesS.get(0)) {
        return poses.get(0);
      }
      int k = 1;
      while (k < size() - 1 && timesS.get(k) < tS) {
        k++;
      }
      double step = timesS.get(k) - timesS.get(k - 1);
      double share = step > 0 ? Math.min(1, (tS - timesS.get(k - 1)) / step) : 1;
      return poses.get(k - 1).towards(poses.get(k), share);
    }

    /** The way made since the first ping, by ping. */
    List<Double> ways() {
      List<Double> ways = new ArrayList<>(List.of(0.0));
      for (int k = 1; k < size(); k++) {
        ways.add(ways.get(k - 1) + poses.get(k - 1).distanceM(poses.get(k)));
      }
      return ways;
    }
  }

  static Change course(boolean restless, Course course) {
    return new Change() {
      @Override
      public boolean restless() {
        return restless;
      }

      @Override
      public List<Pose> poses(Recording recording, List<Pose> poses, RandomGenerator random) {
        List<Pose> changed = new ArrayList<>(poses);
        for (Track track : recording.tracks()) {
          List<Integer> rows = track.rows();
          Path path =
              new Path(
                  rows.stream().map(recording::tS).toList(),
                  rows.stream().map(poses::get).toList());
          List<Pose> moved = course.of(path, random);
          for (int k = 0; k < rows.size(); k++) {
            changed.set(rows.get(k), moved.get(k));
          }
        }
        return changed;
      }
    };
  }

  static List<Pose> each(Path path, IntFunction<Pose> pose) {
    List<Pose> moved = new ArrayList<>(path.size());
    for (int k = 0; k < path.size(); k++) {
      moved.add(pose.apply(k));
    }
    return moved;
  }

  private static double lagS(Circumstances c) {
    return c.strength() > 0 ? Math.max(c.sized(0.4), 1.2 * c.recording().periodS()) : 0;
  }

  private static Drawn latency(Circumstances c) {
    double lag = lagS(c);
    return new Drawn(
        Map.of("s", lag),
        course(false, (path, random) -> each(path, k -> path.at(path.timesS().get(k) - lag))));
  }

  private static Drawn latencyPings(Circumstances c) {
    double period = Math.max(1e-3, c.recording().periodS());
    int pings = (int) Math.round(lagS(c) / period);
    return new Drawn(
        Map.of("pings", pings, "s", pings * period),
        course(false, (path, random) -> each(path, k -> path.poses().get(Math.max(0, k - pings)))));
  }

  private static Drawn latencyJittered(Circumstances c) {
    double lag = lagS(c);
    return new Drawn(
        Map.of("s", lag, "jitter_s", 0.15 * lag),
        course(
            true,
            (path, random) ->
                each(
                    path,
                    k ->
                        path.at(
                            path.timesS().get(k) - lag * (1 + random.nextDouble(-0.15, 0.15))))));
  }

  private static Drawn scale(Circumstances c) {
    double k = 1 + c.eitherWay(0.06);
    return new Drawn(
        Map.of("k", k), course(false, (path, random) -> each(path, i -> scaled(path, i, k))));
  }

  private static Pose scaled(Path path, int i, double k) {
    Pose start = path.poses().get(0);
    Pose pose = path.poses().get(i);
    double x = start.xM() + (pose.xM() - start.xM()) / k;
    double z = start.zM() + (pose.zM() - start.zM()) / k;
    return pose.at(x, z);
  }

  /** The robot is on its planned path, only not as far along it as it believes. */
  private static Drawn scaleAlong(Circumstances c) {
    double k = 1 + c.sized(0.07);
    return new Drawn(
        Map.of("k", k),
        course(
            false,
            (path, random) -> {
              Path byWay = new Path(path.ways(), path.poses());
              return each(path, i -> byWay.at(byWay.timesS().get(i) / k));
            }));
  }

  private static double rate(Circumstances c) {
    return Math.toRadians(c.eitherWay(8)) / Math.max(1, c.recording().longestS());
  }

  private static Drawn turned(
      Map<String, Object> parameters, ToDoubleFunction<Double> angleByTime) {
    return new Drawn(
        parameters,
        course(
            false,
            (path, random) ->
                each(
                    path,
                    k ->
                        path.poses()
                            .get(k)
                            .turned(angleByTime.applyAsDouble(path.timesS().get(k))))));
  }

  private static Drawn drift(Circumstances c) {
    double rate = rate(c);
    return turned(Map.of("deg_s", Math.toDegrees(rate)), t -> rate * t);
  }

  private static Drawn driftLevelling(Circumstances c) {
    double most = 1.2 * rate(c) * c.recording().longestS();
    double timeS = c.recording().longestS() * c.between(0.2, 0.6);
    return turned(
        Map.of("deg", Math.toDegrees(most), "time_s", timeS),
        t -> most * (1 - StrictMath.exp(-t / timeS)));
  }

  /** Steps are added up along wrong headings, so the place goes astray as well. */
  private static Drawn driftReckoned(Circumstances c) {
    double rate = rate(c);
    return new Drawn(
        Map.of("deg_s", Math.toDegrees(rate)),
        course(false, (path, random) -> reckoned(path, rate)));
  }

  private static List<Pose> reckoned(Path path, double rateRadPerS) {
    List<Pose> moved = new ArrayList<>();
    Pose last = path.poses().get(0);
    moved.add(last);
    for (int k = 1; k < path.size(); k++) {
      double angle = rateRadPerS * path.timesS().get(k);
      Pose a = path.poses().get(k - 1);
      Pose b = path.poses().get(k);
      double dx = b.xM() - a.xM();
      double dz = b.zM() - a.zM();
      double cos = StrictMath.cos(angle);
      double sin = StrictMath.sin(angle);
      Pose next =
          new Pose(
              last.xM() + dx * cos + dz * sin,
              last.zM() - dx * sin + dz * cos,
              b.headingRad() + angle);
      moved.add(next);
      last = next;
    }
    return moved;
  }

  private static Drawn driftByWay(Circumstances c) {
    double perM = Math.toRadians(c.eitherWay(2));
    return new Drawn(
        Map.of("deg_m", Math.toDegrees(perM)),
        course(
            false,
            (path, random) -> {
              List<Double> ways = path.ways();
              return each(path, k -> path.poses().get(k).turned(perM * ways.get(k)));
            }));
  }
}
