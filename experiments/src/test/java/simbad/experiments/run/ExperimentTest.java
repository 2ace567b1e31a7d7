package simbad.experiments.run;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.obstacles.Catalogue;
import simbad.obstacles.CrossSections;
import simbad.obstacles.ObstacleType;
import simbad.sonar.format.TableDocument;
import simbad.sonar.frame.Point;
import simbad.sonar.model.DetectionRule;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.ReadingRow;
import simbad.sonar.sensing.Readings;
import simbad.sonar.sensing.Sensor;
import simbad.sonar.sensing.TransducerPoses;
import simbad.sonar.shape.ThresholdTable;

/** The main job itself, and its figures against the targets. */
class ExperimentTest {
  private static final List<SensorKind> MAIN = List.of(SensorKind.ORIGINAL, SensorKind.SHADOW);
  private static final AtomicInteger done = new AtomicInteger();
  private static List<RunResult> results = List.of();

  private static RunSettings settings(
      List<ObstacleType> types, List<SensorKind> sensors, double speed) {
    return new RunSettings(types, sensors, Catalogue.srf04(), speed, Optional.empty(), 1);
  }

  private static RunResult one(ThresholdTable table, SensorKind sensor, Optional<Point> start) {
    ObstacleType type =
        new ObstacleType("own", CrossSections.round(), new TableDocument(table, Map.of()));
    RunSettings settings =
        new RunSettings(List.of(type), List.of(sensor), Catalogue.srf04(), 0.1, start, 1);
    return Experiment.run(settings, result -> {}).get(0);
  }

  @BeforeAll
  static void run() {
    results =
        Experiment.run(
            settings(Catalogue.types(), MAIN, RunSettings.THESIS_SPEED_M_PER_S),
            result -> done.incrementAndGet());
  }

  private static RunResult find(String obstacle, SensorKind sensor) {
    return results.stream()
        .filter(result -> result.type().name().equals(obstacle) && result.sensor().equals(sensor))
        .findFirst()
        .orElseThrow();
  }

  /** Each sonar where it was when it pinged, all round from the first step on. */
  @Test
  void readings_areKeptOnDemand() {
    ObstacleType type = Catalogue.find("round").orElseThrow();
    RunSettings plain = settings(List.of(type), List.of(SensorKind.SHADOW), 0.5);
    RunResult kept = Experiment.run(plain.keepingReadings(), result -> {}).get(0);
    List<ReadingRow> rows = kept.trace().readings();
    assertEquals(SensorKind.SONARS * kept.trace().size(), rows.size());
    Sensor rule =
        DetectionRule.SHADOW.bind(Catalogue.srf04(), kept.world(), new SplittableRandom(1));
    TransducerPoses at = new TransducerPoses(1);
    Readings expected = new Readings(1);
    int echoes = 0;
    for (int i = 0; i < rows.size(); i++) {
      ReadingRow row = rows.get(i);
      assertEquals(Math.floorDiv(i, SensorKind.SONARS) * Circuit.STEP_S, row.timeS(), 1e-9);
      double heading = row.pose().heading().radians();
      at.setPosition(0, row.pose().position().xM(), 0.15, row.pose().position().zM());
      at.setDirection(0, Math.cos(heading), 0, -Math.sin(heading));
      rule.ping(at, 0, expected);
      assertEquals(expected.isEcho(0), row.reading() instanceof Echo, row.toString());
      if (row.reading() instanceof Echo echo) {
        assertEquals(expected.rangeM(0), echo.rangeM(), 1e-6, row.toString());
        echoes++;
      }
    }
    assertTrue(echoes > 50, echoes + " echoes");
    RunResult other = Experiment.run(plain, result -> {}).get(0);
    assertEquals(List.of(), other.trace().readings());
    assertEquals(kept.errors(), other.errors());
  }

  @Test
  void results_comeObstacleByObstacle() {
    assertEquals(
        List.of(
            "square original",
            "square shadow",
            "round original",
            "round shadow",
            "angle original",
            "angle shadow"),
        results.stream().map(result -> result.type().name() + " " + result.sensor()).toList());
    assertEquals(6, done.get());
  }

  /**
   * The targets: mean radial error at most 3 cm, at most a tenth of the original's; 1 cm beside.
   */
  @ParameterizedTest
  @ValueSource(strings = {"square", "round", "angle"})
  void shadowSensor_reachesTheTargets(String obstacle) {
    RunResult shadow = find(obstacle, SensorKind.SHADOW);
    double original = find(obstacle, SensorKind.ORIGINAL).errors().meanM().orElseThrow();
    double mean = shadow.errors().meanM().orElseThrow();
    assertTrue(shadow.trace().isClosed());
    assertEquals(72, shadow.errors().radialM().size());
    assertEquals(0, shadow.errors().unreachedBearings());
    assertTrue(mean <= 0.03, obstacle + ": mean " + mean);
    assertTrue(mean <= original / 10, obstacle + ": mean " + mean + ", original " + original);
    assertTrue(shadow.errors().lateralMeanM() <= 0.01, "" + shadow.errors().lateralMeanM());
    assertTrue(shadow.errors().lateralP95M() <= shadow.errors().lateralMaxM());
    assertEquals(1 - mean / original, shadow.reductionVsOriginal().orElseThrow(), 1e-12);
  }

  /**
   * The original sensor goes round on a circle of 2.5 m to the post's face: about 2.51 m to the
   * centre. Against the round table of 2 m that is 51 cm; the reduction against itself is 0.
   */
  @Test
  void originalSensor_goesRoundOnItsCircle() {
    RunResult original = find("round", SensorKind.ORIGINAL);
    assertEquals(0.512, original.errors().meanM().orElseThrow(), 0.003);
    assertEquals(0, original.reductionVsOriginal().orElseThrow());
    assertEquals(0, original.errors().unreachedBearings());
  }

  /** Some cells' centres lie within the outline's size of the edge; everywhere else they agree. */
  @ParameterizedTest
  @ValueSource(strings = {"square", "round", "angle"})
  void map_agreesForTheShadowSensorOnly(String obstacle) {
    assertTrue(find(obstacle, SensorKind.SHADOW).map().agreement() > 0.999);
    double original = find(obstacle, SensorKind.ORIGINAL).map().agreement();
    assertTrue(original < 0.9, obstacle + ": " + original);
  }

  /** Round: the original disagrees in the ring from 2 to 2.51 m of a square of 2 * 1.15 * 2.5 m. */
  @Test
  void map_ofTheOriginal_isTheRing() {
    double ring = Math.PI * (2.512 * 2.512 - 2 * 2) / Math.pow(2 * 1.15 * 2.5, 2);
    assertEquals(1 - ring, find("round", SensorKind.ORIGINAL).map().agreement(), 0.005);
  }

  @ParameterizedTest
  @MethodSource("simbad.experiments.run.SensorKind#plain")
  void anySensor_endsWithinItsSteps(SensorKind sensor) {
    ThresholdTable table = ThresholdTable.of(1, 0.6, 1, 0.6, 1, 0.6, 1, 0.6);
    RunResult result = one(table, sensor, Optional.empty());
    // 30 times the way of 2.5 m all round, at 5 mm a step.
    assertTrue(result.trace().size() <= 30 * 2 * Math.PI * 2.5 / 0.005 + 1);
    assertTrue(result.trace().size() > 100);
    assertTrue(result.map().agreement() >= 0 && result.map().agreement() <= 1);
    assertTrue(result.reductionVsOriginal().isEmpty() || sensor.equals(SensorKind.ORIGINAL));
  }

  @Test
  void noisySensor_getsRound() {
    RunResult result = one(ThresholdTable.uniform(36, 1), SensorKind.NOISY, Optional.empty());
    assertTrue(result.trace().isClosed());
    assertEquals(0, result.errors().unreachedBearings());
    assertTrue(result.errors().meanM().orElseThrow() < 0.15);
  }

  /** A threshold of 0 never echoes: nothing is heard, nothing reached, and the run ends. */
  @Test
  void zeroTable_isNeverHeard_andEnds() {
    RunResult result = one(ThresholdTable.uniform(8, 0), SensorKind.SHADOW, Optional.empty());
    for (int i = 0; i < result.trace().size(); i++) {
      assertFalse(result.trace().heard(i));
    }
    assertFalse(result.trace().isClosed());
    assertEquals(8, result.errors().unreachedBearings());
    assertEquals(1, result.map().agreement());
  }

  /** From 2 m out, where a table of 0.5 m is not heard: the robot drives in and then round. */
  @Test
  void start_whereNothingIsHeard_getsRound() {
    Optional<Point> start = Optional.of(new Point(1.2, -1.6));
    RunResult result = one(ThresholdTable.uniform(8, 0.5), SensorKind.SHADOW, start);
    assertEquals(1.2, result.trace().xM(0), 0.01);
    assertEquals(-1.6, result.trace().zM(0), 0.01);
    assertTrue(result.trace().isClosed());
  }

  @Test
  void settings_refuseImpossibleSpeeds() {
    for (double speed : new double[] {0, -1, Double.NaN, 1.5, Double.POSITIVE_INFINITY}) {
      assertThrows(IllegalArgumentException.class, () -> settings(Catalogue.types(), MAIN, speed));
    }
  }

  @Test
  void sensorNames_roundTrip() {
    for (SensorKind kind : SensorKind.plain()) {
      assertEquals(Optional.of(kind), SensorKind.find(kind.word()));
      assertFalse(kind.meaning().isEmpty());
    }
    assertEquals(Optional.empty(), SensorKind.find("SHADOW"));
    assertEquals(
        "original, ray, shadow, overlap, noisy, level, level-noisy, diagnosed:DIR",
        SensorKind.words());
  }
}
