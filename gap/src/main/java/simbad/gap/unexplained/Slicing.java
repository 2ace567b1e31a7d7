package simbad.gap.unexplained;

import java.util.ArrayList;
import java.util.List;
import java.util.function.IntToDoubleFunction;
import java.util.function.IntUnaryOperator;
import simbad.gap.slice.Axis;
import simbad.gap.slice.Nearest;
import simbad.sonar.frame.Angles;
import simbad.sonar.ping.Geometry;
import simbad.sonar.ping.PingLog;

/** Ways to cut a log into slices, declared before any reading is looked at. */
final class Slicing {
  private final PingLog log;
  private final Geometry geometry;
  private final int[] nearest;

  Slicing(PingLog log, Geometry geometry) {
    this.log = log;
    this.geometry = geometry;
    nearest = new int[log.size()];
    for (int ping = 0; ping < nearest.length; ping++) {
      nearest[ping] = ping * geometry.obstacles() + Nearest.of(geometry, ping);
    }
  }

  /** Returns all of them. */
  List<Axis> all() {
    IntToDoubleFunction distance = this::nearestM;
    IntToDoubleFunction relative = this::relative;
    IntToDoubleFunction time = log::timeS;
    IntToDoubleFunction since = i -> log.timeS(i) - log.runStartS(i);
    IntToDoubleFunction offAxis =
        i -> isSeen(i) ? geometry.offAxisRad(nearest[i]) : Double.POSITIVE_INFINITY;
    List<Axis> cuts = new ArrayList<>();
    cuts.add(quantiles("time", 10, time));
    cuts.add(quantiles("time in run", 8, since));
    cuts.add(quantiles("distance", 10, distance));
    cuts.add(quantiles("relative distance", 8, relative));
    cuts.add(quantiles("off axis", 8, offAxis));
    if (geometry.ears() != null) {
      cuts.add(quantiles("level", 8, this::levelDb));
    }
    cuts.add(quantiles("heading", 8, log::headingRad));
    cuts.add(quantiles("x", 6, log::xM));
    cuts.add(quantiles("z", 6, log::zM));
    cuts.add(quantiles("speed", 5, log::speedMPerS));
    cuts.add(quantiles("turn", 5, this::turn));
    cuts.add(quantiles("reading before", 6, this::before));
    cuts.add(quantiles("step since reading before", 6, this::change));
    cuts.add(
        binned("echo before", 2, i -> i == log.sequenceStart(i) ? -1 : log.echo(i - 1) ? 1 : 0));
    cuts.add(binned("parity", 2, i -> (i - log.sequenceStart(i)) % 2));
    cuts.addAll(named(time, distance, relative, offAxis));
    return cuts;
  }

  /** By what has a name, and by two things at once. */
  private List<Axis> named(
      IntToDoubleFunction time,
      IntToDoubleFunction distance,
      IntToDoubleFunction relative,
      IntToDoubleFunction offAxis) {
    List<Axis> cuts = new ArrayList<>();
    Axis sensor = Axis.named("sensor", log.size(), log.sensors(), log::sensor);
    Axis run = Axis.named("run", log.size(), log.runs(), log::run);
    int obstacles = Math.max(1, geometry.obstacles());
    Axis obstacle = binned("obstacle", obstacles, i -> nearest[i] % obstacles);
    cuts.add(sensor);
    cuts.add(run);
    cuts.add(obstacle);
    Axis bearing = binned("bearing", 16, i -> bearing(i, 16));
    cuts.add(bearing.times(obstacle));
    cuts.add(quantiles("time", 5, time).times(quantiles("relative distance", 4, relative)));
    cuts.add(quantiles("time", 5, time).times(quantiles("distance", 4, distance)));
    cuts.add(quantiles("time", 4, time).times(sensor));
    cuts.add(quantiles("time", 4, time).times(obstacle));
    cuts.add(sensor.times(quantiles("relative distance", 4, relative)));
    cuts.add(sensor.times(quantiles("distance", 4, distance)));
    cuts.add(
        binned("bearing", 8, i -> bearing(i, 8))
            .times(quantiles("relative distance", 4, relative)));
    cuts.add(quantiles("distance", 4, distance).times(quantiles("off axis", 4, offAxis)));
    cuts.add(quantiles("speed", 3, log::speedMPerS).times(quantiles("distance", 3, distance)));
    return cuts;
  }

  private double relative(int ping) {
    if (!isSeen(ping)) {
      return Double.POSITIVE_INFINITY;
    }
    double threshold = geometry.thresholdM(nearest[ping]);
    return threshold > 0 ? geometry.centreDistanceM(nearest[ping]) / threshold : 9;
  }

  private boolean isSeen(int ping) {
    return nearestM(ping) < Double.POSITIVE_INFINITY;
  }

  /** A scene may be empty. */
  private double nearestM(int ping) {
    return geometry.obstacles() == 0 ? Double.POSITIVE_INFINITY : geometry.nearestM(nearest[ping]);
  }

  private int bearing(int ping, int sectors) {
    if (!isSeen(ping)) {
      return -1;
    }
    return (int) (geometry.bearingRad(nearest[ping]) / Angles.TURN_RAD * sectors) % sectors;
  }

  /** How loud its echo is, which what loses echoes "whatever the geometry" does not ask for. */
  private double levelDb(int ping) {
    return isSeen(ping) ? geometry.excessDb(nearest[ping]) : Double.POSITIVE_INFINITY;
  }

  private double turn(int ping) {
    return ping == log.sequenceStart(ping)
        ? Double.POSITIVE_INFINITY
        : Angles.signed(log.headingRad(ping) - log.headingRad(ping - 1));
  }

  private double before(int ping) {
    return ping > log.sequenceStart(ping) && log.echo(ping - 1)
        ? log.rangeM(ping - 1)
        : Double.POSITIVE_INFINITY;
  }

  private double change(int ping) {
    return before(ping) - nearestM(ping);
  }

  private Axis quantiles(String name, int count, IntToDoubleFunction of) {
    return Axis.quantiles(name, log.size(), count, of);
  }

  private Axis binned(String name, int count, IntUnaryOperator of) {
    return Axis.binned(name, log.size(), count, of);
  }
}
