package simbad.gap.locate;

import java.util.List;
import java.util.stream.IntStream;
import simbad.gap.diagnosis.Interval;
import simbad.gap.diagnosis.Place;
import simbad.gap.slice.Nearest;
import simbad.sonar.ping.Geometry;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.Obstacle;

/** Which pings of a log lie in a place of the gap, by the words that a diagnosis has for it. */
public final class PlaceRows {
  private final Geometry geometry;
  private final PingLog log;
  private final List<Place.Condition> conditions;

  private PlaceRows(Geometry geometry, List<Place.Condition> conditions) {
    this.geometry = geometry;
    this.conditions = conditions;
    log = geometry.log();
  }

  /**
   * Finds the pings: of all of the log, where a {@link Place} counts those of the confirming half.
   *
   * @param geometry of the log under the set-up as it is believed
   * @param conditions of the place; a variable that is none of {@link Place.Condition}'s holds for
   *     no ping
   * @return indices of pings, ascending
   */
  public static int[] of(Geometry geometry, List<Place.Condition> conditions) {
    PlaceRows rows = new PlaceRows(geometry, conditions);
    return IntStream.range(0, rows.log.size()).filter(rows::holds).toArray();
  }

  private boolean holds(int ping) {
    return conditions.stream().allMatch(condition -> holds(condition, ping));
  }

  private boolean holds(Place.Condition condition, int ping) {
    if (condition.name().isPresent()) {
      return condition.name().get().equals(name(condition.variable(), ping));
    }
    double value = number(condition.variable(), ping);
    Interval ends = condition.interval().orElseThrow();
    return value >= ends.low() && value < ends.high();
  }

  private String name(String variable, int ping) {
    return switch (variable) {
      case "sensor" -> log.sensors().get(log.sensor(ping));
      case "run" -> log.runs().get(log.run(ping));
      case "obstacle" ->
          geometry.obstacles() == 0 ? "" : obstacles().get(Nearest.of(geometry, ping)).name();
      default -> "";
    };
  }

  private double number(String variable, int ping) {
    if (variable.equals("t_s")) {
      return log.timeS(ping);
    }
    if (variable.equals("speed_m_s")) {
      return log.speedMPerS(ping);
    }
    if (geometry.obstacles() == 0) {
      return Double.NaN;
    }
    int line = ping * geometry.obstacles() + Nearest.of(geometry, ping);
    return switch (variable) {
      case "distance_m" -> geometry.centreDistanceM(line);
      case "off_axis_deg" -> Math.toDegrees(geometry.offAxisRad(line));
      case "bearing_deg" -> bearingDeg(ping);
      default -> Double.NaN;
    };
  }

  /** Of the obstacle that the place names, or of the only one. */
  private double bearingDeg(int ping) {
    Obstacle seen =
        conditions.stream()
            .filter(condition -> condition.variable().equals("obstacle"))
            .flatMap(condition -> condition.name().stream())
            .flatMap(name -> obstacles().stream().filter(one -> one.name().equals(name)))
            .findFirst()
            .orElse(obstacles().get(0));
    return Math.toDegrees(seen.worldFromObstacle().bearingRad(log.xM(ping), log.zM(ping)));
  }

  private List<Obstacle> obstacles() {
    return geometry.scene().obstacles();
  }
}
