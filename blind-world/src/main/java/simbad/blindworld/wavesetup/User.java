package simbad.blindworld.wavesetup;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import simbad.blindworld.wave.Counter;
import simbad.blindworld.wave.WaveWorld;
import simbad.blindworld.world.Chance;
import simbad.blindworld.world.Obstacle;
import simbad.blindworld.world.Scene;
import simbad.blindworld.world.Sensor;
import simbad.blindworld.world.Shadow;

/**
 * Somebody who calibrates honestly and with the means of a bench: sets the counter by a tape,
 * sweeps each article out once at 72 bearings, turns the sonar for the cone, repeats pings for
 * noise, edge and misses, and writes down what came out.
 */
public final class User {

  private static final int BEARINGS = 72;
  private static final List<String> NAMES = List.of("SRF04", "SRF05", "HC-SR04", "ranger");

  private final Room room;
  private final Chance random;
  private final WaveWorld.Parts today;
  private final double stepM;
  private final double resolutionM;

  /** A user in a room, on one day at the bench. */
  public User(Room room, Chance random) {
    this.room = room;
    this.random = random;
    double thermometerK = random.nextDouble(-1, 1);
    WaveWorld.Parts day = room.onSomeDay(random);
    double speed = Math.rint(day.air().warmer(thermometerK).soundSpeedMPerS());
    stepM = 0.01 * random.nextInt(2, 5);
    resolutionM = random.nextInt(4) == 0 ? 0.005 : 0.01;
    today = day.with(new Counter(speed, 0, day.counter().tickS(), resolutionM));
  }

  /**
   * What a calibration gives.
   *
   * @param scene as it is written down
   * @param counter as it is set
   * @param notes what else was found, for the truth
   */
  public record Calibration(Scene scene, Counter counter, Map<String, Object> notes) {}

  /** Calibrates; the sonar will ping once in a period. */
  public Calibration calibrate(double periodS) {
    Stand first = stand(0, today);
    double late = lateS(first);
    Counter counter =
        new Counter(today.counter().soundSpeedMPerS(), late, today.counter().tickS(), resolutionM);
    List<Stand> stands = new ArrayList<>();
    for (int i = 0; i < room.articles().size(); i++) {
      stands.add(stand(i, today.with(counter)));
    }
    List<List<Double>> tables = stands.stream().map(this::table).toList();
    Trials trials = new Trials(stands.get(0), tables.get(0));
    Map<String, Object> notes = new LinkedHashMap<>();
    notes.put("t0", late);
    notes.put("halves", trials.halvesDeg());
    Sensor sensor = sensor(trials, periodS);
    List<Obstacle> obstacles = new ArrayList<>();
    for (int i = 0; i < tables.size(); i++) {
      obstacles.add(obstacle(i, tables.get(i)));
    }
    double noEcho = random.nextBoolean() ? room.maxRangeM() : 4;
    return new Calibration(new Scene(noEcho, sensor, obstacles), counter, notes);
  }

  private Stand stand(int index, WaveWorld.Parts parts) {
    Article article = room.articles().get(index);
    return new Stand(parts, article, article.upright(room.mountHeightM()), random);
  }

  /** How late echoes are detected, at the side that is heard best half a metre away. */
  private double lateS(Stand stand) {
    double speed = today.counter().soundSpeedMPerS();
    List<Double> late = new ArrayList<>();
    for (double distance : new double[] {0.5, 0.3, 0.8}) {
      for (int side = 0; side < BEARINGS && late.size() < 40; side++) {
        Stand.Place place = stand.at(bearing(side), distance, 0);
        if (place.heard(5) == 5) {
          for (int ping = 0; ping < 20; ping++) {
            double range = place.rangeM();
            if (range < Double.POSITIVE_INFINITY) {
              late.add(2 * (range - place.surfaceM()) / speed);
            }
          }
        }
      }
    }
    late.sort(null);
    return late.isEmpty() ? 0 : late.get(late.size() / 2);
  }

  private static double bearing(int index) {
    return 2 * Math.PI * index / BEARINGS;
  }

  private List<Double> table(Stand stand) {
    return IntStream.range(0, BEARINGS).mapToObj(i -> thresholdM(stand, bearing(i))).toList();
  }

  /**
   * Outwards in steps until two pings running are silent; half way between the last and the next.
   */
  private double thresholdM(Stand stand, double bearingRad) {
    double begin = Math.ceil((stand.article().outline().radiusM() + 0.1) / stepM) * stepM;
    double last = begin - stepM / 2;
    int silent = 0;
    for (double r = begin; r < room.maxRangeM() && silent < 2; r += stepM) {
      boolean hears = stand.at(bearingRad, r, 0).hears();
      silent = hears ? 0 : silent + 1;
      last = hears ? r : last;
    }
    return Math.round(1000 * (last + stepM / 2)) / 1000.0;
  }

  private Sensor sensor(Trials trials, double periodS) {
    return new Sensor(
        NAMES.get(random.nextInt(NAMES.size())),
        Math.toRadians(trials.halfAngleDeg()),
        trials.minRangeM(),
        room.maxRangeM(),
        room.mountHeightM(),
        today.counter().soundSpeedMPerS(),
        resolutionM,
        Math.max(0.002, Math.round(1e4 * trials.noiseM()) / 1e4),
        Math.max(0.001, Math.round(1e4 * trials.missRate()) / 1e4),
        trials.edgeM(),
        periodS);
  }

  private Obstacle obstacle(int index, List<Double> table) {
    Article article = room.articles().get(index);
    boolean even = article.isRound() && random.nextInt(3) == 0;
    double mean = table.stream().mapToDouble(Double::doubleValue).average().orElseThrow();
    Shadow shadow = even ? Shadow.uniform(Math.round(100 * mean) / 100.0) : new Shadow(table);
    return new Obstacle(
        article.kind() + (index == 0 ? "" : "-" + (index + 1)),
        room.targets().get(index).place(),
        room.turnsRad().get(index),
        article.corners(),
        shadow);
  }

  /** The bearings of a table, furthest first. */
  static List<Integer> furthest(List<Double> table) {
    return IntStream.range(0, table.size())
        .boxed()
        .sorted(Comparator.comparingDouble((Integer i) -> -table.get(i)).thenComparingInt(i -> i))
        .toList();
  }
}
