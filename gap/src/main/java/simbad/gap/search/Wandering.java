package simbad.gap.search;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;
import simbad.gap.calibrate.level.Along;
import simbad.gap.calibrate.level.Leeway;
import simbad.gap.calibrate.SetupMove;
import simbad.gap.fit.Evidence;
import simbad.gap.fit.Hypothesis;
import simbad.sonar.ping.Geometry;

/**
 * Levels that wander smoothly along something: the bearing, the side of the sensor, the distance,
 * the time. What does so has no name of its own; each curve's marginal likelihood is by Laplace's
 * approximation (MacKay 1992), so that a curve which could be anything costs what it could be.
 */
final class Wandering {
  private static final double[] SPREADS_DB = {2, 6};

  private static final Along.Axis BEARING = Along.Axis.round(7.5, 20);
  private static final Along.Axis SIDE = Along.Axis.between(-70, 70, 5, 12);
  private static final double DISTANCE_STEP_M = 0.15;
  private static final double DISTANCE_LENGTH_M = 0.5;
  private static final int TIMES = 24;
  private static final double TIME_LENGTH = 0.15;

  private final SetupMove move;
  private final Geometry geometry;
  private final double fitted;
  private final List<Way> ways = new ArrayList<>();

  /** Something to wander along, with the words for a place on it. */
  private record Way(Along along, Along.Axis axis, String words, double unit) {
    String told(double[] atKnotsDb) {
      int most = 0;
      for (int i = 0; i < atKnotsDb.length; i++) {
        most = Math.abs(atKnotsDb[i]) > Math.abs(atKnotsDb[most]) ? i : most;
      }
      double at = axis.at(most % axis.knots()) * unit;
      return String.format(
          Locale.ROOT,
          "echoes are %s %s, by up to %.0f dB (%s)",
          atKnotsDb[most] < 0 ? "weaker" : "stronger",
          "than the set-up says",
          Math.abs(atKnotsDb[most]),
          String.format(Locale.ROOT, words, at));
    }
  }

  /**
   * What was found.
   *
   * @param nats of the log with a curve beside a set of effects, comparable to that of a set
   * @param what it does, in words
   */
  record Curve(double nats, String what) {}

  /**
   * Asks a log.
   *
   * @param open how far its set-up may move
   * @param evidence of it
   * @param rest effects that stay as they are
   * @param durationS of the log, seconds; 0 where nothing can be said of time
   */
  Wandering(Leeway open, Evidence evidence, Hypothesis rest, double durationS) {
    move = new SetupMove(open, evidence, rest);
    geometry = move.geometry();
    fitted = Arrays.stream(evidence.logLikelihood(rest)).sum();
    add(BEARING, true, line -> Math.toDegrees(geometry.bearingRad(line)), "most at a bearing of %.0f degrees", 1);
    add(
        SIDE,
        false,
        line -> Math.toDegrees(geometry.nearestSignedOffAxisRad(line)),
        "most at %.0f degrees to the left of where the sensor looks",
        1);
    double most = evidence.setup().sensor().maxRangeM();
    Along.Axis distance = Along.Axis.between(0, most, DISTANCE_STEP_M, DISTANCE_LENGTH_M);
    add(distance, false, geometry::nearestM, "most at a distance of %.1f m", 1);
    if (durationS > 0) {
      Along.Axis time = Along.Axis.between(0, 1, 1.0 / TIMES, TIME_LENGTH);
      int obstacles = geometry.obstacles();
      add(
          time,
          false,
          line -> geometry.sinceStartS(line / obstacles) / durationS,
          "most after %.0f s",
          durationS);
    }
  }

  private void add(
      Along.Axis axis, boolean byObstacle, IntToDoubleFunction place, String words, double unit) {
    int pings = geometry.log().size();
    int[] curve = new int[pings];
    double[] at = new double[pings];
    for (int ping = 0; ping < pings; ping++) {
      int line = move.line(ping);
      curve[ping] = byObstacle && line >= 0 ? line % geometry.obstacles() : 0;
      at[ping] = line >= 0 ? place.applyAsDouble(line) : Double.NaN;
    }
    ways.add(new Way(Along.of(axis, curve, at), axis, words, unit));
  }

  /** Returns each way and spread, with what choosing among them costs. */
  List<Curve> curves() {
    double choice = Math.log(ways.size() * SPREADS_DB.length);
    return IntStream.range(0, ways.size() * SPREADS_DB.length)
        .parallel()
        .mapToObj(
            i -> {
              Way way = ways.get(i / SPREADS_DB.length);
              Leeway.Wandered wandered =
                  move.levels(way.along, SPREADS_DB[i % SPREADS_DB.length]);
              double nats = fitted + move.nats(wandered.moved()) - choice;
              return new Curve(nats, way.told(wandered.atKnotsDb()));
            })
        .toList();
  }
}
