package simbad.gap.search;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.function.DoubleFunction;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;
import simbad.gap.calibrate.SetupMove;
import simbad.gap.calibrate.level.Along;
import simbad.gap.calibrate.level.Leeway;
import simbad.gap.fit.CalibratedLog;
import simbad.gap.fit.Hypothesis;
import simbad.sonar.ping.Geometry;

/**
 * Levels that wander smoothly along something: the bearing, the side of the sensor, the distance,
 * the time. What does so has no name of its own; each curve's marginal likelihood is by Laplace's
 * approximation (MacKay 1992), so that a curve which could be anything costs what it could be.
 */
final class Wandering {
  private static final double[] SPREADS_DB = {2, 5, 12};

  private static final Along.Axis BEARING = Along.Axis.round(10, 40);
  private static final Along.Axis SIDE = Along.Axis.between(-70, 70, 5, 20);
  private static final double DISTANCE_STEP_M = 0.15;
  private static final double DISTANCE_LENGTH_M = 1;
  private static final int TIMES = 24;
  private static final double TIME_LENGTH = 0.3;

  private final SetupMove move;
  private final Geometry geometry;
  private final double fitted;
  private final List<Way> ways = new ArrayList<>();

  /** Something to wander along, with the words for a place on it. */
  private record Way(Along along, Along.Axis axis, DoubleFunction<String> place) {
    String words(double[] atKnotsDb) {
      int most = 0;
      for (int i = 0; i < atKnotsDb.length; i++) {
        most = Math.abs(atKnotsDb[i]) > Math.abs(atKnotsDb[most]) ? i : most;
      }
      return String.format(
          Locale.ROOT,
          "echoes are %s than the set-up says, by up to %.0f dB %s",
          atKnotsDb[most] < 0 ? "weaker" : "stronger",
          Math.abs(atKnotsDb[most]),
          place.apply(axis.at(most % axis.knots())));
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
   * @param given of it
   * @param rest effects that stay as they are
   * @param durationS of the log, seconds; 0 where nothing can be said of time
   */
  Wandering(Leeway open, CalibratedLog given, Hypothesis rest, double durationS) {
    move = new SetupMove(open, given, rest);
    geometry = move.geometry();
    fitted = Arrays.stream(given.logLikelihood(rest)).sum();
    add(
        BEARING,
        true,
        line -> Math.toDegrees(geometry.bearingRad(line)),
        at -> said("at bearings of about %.0f degrees", at));
    add(
        SIDE,
        false,
        line -> Math.toDegrees(geometry.echoOffAxisRad(line)),
        at ->
            said("at about %.0f degrees ", Math.abs(at))
                + (at < 0 ? "to the right" : "to the left"));
    double most = given.setup().sensor().maxRangeM();
    add(
        Along.Axis.between(0, most, DISTANCE_STEP_M, DISTANCE_LENGTH_M),
        false,
        geometry::nearestM,
        at -> said("at distances of about %.1f m", at));
    if (durationS > 0) {
      int obstacles = geometry.obstacles();
      add(
          Along.Axis.between(0, 1, 1.0 / TIMES, TIME_LENGTH),
          false,
          line -> geometry.sinceStartS(line / obstacles) / durationS,
          at -> said("at about %.0f s after the start", at * durationS));
    }
  }

  private static String said(String words, double value) {
    return String.format(Locale.ROOT, words, value);
  }

  private void add(
      Along.Axis axis,
      boolean byObstacle,
      IntToDoubleFunction place,
      DoubleFunction<String> words) {
    int pings = geometry.log().size();
    int[] curve = new int[pings];
    double[] at = new double[pings];
    for (int ping = 0; ping < pings; ping++) {
      int line = move.line(ping);
      curve[ping] = byObstacle && line >= 0 ? line % geometry.obstacles() : 0;
      at[ping] = line >= 0 ? place.applyAsDouble(line) : Double.NaN;
    }
    ways.add(new Way(Along.of(axis, curve, at), axis, words));
  }

  /** Returns what each way and spread comes to; choosing among them costs as well. */
  List<Curve> curves() {
    double choice = Math.log(ways.size() * SPREADS_DB.length);
    // The set-up's own values cost nothing here as they cost nothing where nothing wanders.
    double cost = choice + move.logShare();
    return IntStream.range(0, ways.size() * SPREADS_DB.length)
        .parallel()
        .mapToObj(
            i -> {
              Way way = ways.get(i / SPREADS_DB.length);
              Leeway.Wandered wandered = move.levels(way.along, SPREADS_DB[i % SPREADS_DB.length]);
              double nats = fitted + move.nats(wandered.moved()) - cost;
              return new Curve(nats, way.words(wandered.atKnotsDb()));
            })
        .toList();
  }
}
