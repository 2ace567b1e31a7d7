package simbad.sonar.predict;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.sonar.change.Burst;
import simbad.sonar.change.Dropout;
import simbad.sonar.change.Gain;
import simbad.sonar.change.Hysteresis;
import simbad.sonar.change.NearerByPrevious;
import simbad.sonar.change.PreviousPing;
import simbad.sonar.change.RangeOffset;
import simbad.sonar.change.SecondBounce;
import simbad.sonar.change.SoundSpeed;
import simbad.sonar.change.StaleReading;
import simbad.sonar.fixture.Refusal;
import simbad.sonar.fixture.Scenes;
import simbad.sonar.fixture.Sonars;
import simbad.sonar.frame.Pose;
import simbad.sonar.model.ReadingDistribution;
import simbad.sonar.ping.Change;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.sensing.ReadingRow;

/**
 * Effects with memory, alone and together, against the enumeration of all histories: the chain of
 * likelihoods is the probability of a history, the forecast the average over all of them.
 */
class MemoryTest {
  private static final double FOREVER_S = 1e9;

  /** Bits: bursts, hysteresis, stale readings, ghosts of the previous ping. */
  private static final int ALL = 15;

  /**
   * Two boxes in line, 0.25 m wide; the sensor comes nearer and goes away, each step 0.05 m, with
   * pings 0.1 s apart but for one pause.
   */
  private static final double[] PLACES_M = {0, 0.05, 0.15, 0.1, -0.05};

  private static final double[] TIMES_S = {0, 0.1, 0.2, 0.5, 0.6};

  private static final SensingSetup SETUP =
      new SensingSetup(
          Sonars.noisy(HistoryTree.RESOLUTION_M, 0, HistoryTree.MISS_RATE, HistoryTree.EDGE_M),
          Scenes.of(Scenes.box(1, 0, 0.95), Scenes.box(1.6, 0, 1.5)),
          6.5);

  private static List<HistoryTree.Ping> pings() {
    List<HistoryTree.Ping> pings = new ArrayList<>();
    for (int i = 0; i < PLACES_M.length; i++) {
      double x = PLACES_M[i];
      pings.add(
          new HistoryTree.Ping(
              TIMES_S[i],
              List.of(
                  new HistoryTree.Target(0.875 - x, 1 - x, 0.95),
                  new HistoryTree.Target(1.475 - x, 1.6 - x, 1.5))));
    }
    return pings;
  }

  private static HistoryTree.World world(int bits, boolean byFactor) {
    return new HistoryTree.World(
        (bits & 1) > 0 ? 0.3 : 0.5,
        3,
        (bits & 1) > 0 ? 0.9 : 0,
        (bits & 2) > 0 ? 0.85 : 1,
        (bits & 2) > 0 ? 1.1 : 1,
        (bits & 4) > 0 ? 2.4 : 0,
        byFactor ? FOREVER_S : 0.35,
        (bits & 8) > 0 ? 0.4 : 0,
        byFactor ? 0.6 : 1,
        byFactor ? 0 : 0.31);
  }

  private static List<Change> changes(HistoryTree.World world) {
    return List.of(
        new Burst(world.burstShare(), world.burstLength(), world.burstDepth()),
        new Hysteresis(world.pickUp(), world.hold()),
        new StaleReading(world.stalePings(), world.staleForS(), 1),
        new PreviousPing(world.ghostShare(), world.ghostFactor(), world.ghostShiftM(), 0));
  }

  private static List<ReadingRow> rows(List<OptionalDouble> readings) {
    List<ReadingRow> rows = new ArrayList<>();
    for (int i = 0; i < readings.size(); i++) {
      rows.add(Logs.row(TIMES_S[i], Pose.of(PLACES_M[i], 0, 0), readings.get(i)));
    }
    return rows;
  }

  private static List<ReadingRow> rowsWithoutReadings() {
    return rows(Collections.nCopies(PLACES_M.length, Logs.SILENCE));
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15})
  void likelihood_isTheProbabilityOfTheHistory(int bits) {
    for (boolean byFactor : new boolean[] {false, true}) {
      HistoryTree.World world = world(bits, byFactor);
      HistoryTree tree = new HistoryTree(world, pings());
      double sum = 0;
      for (Map.Entry<List<OptionalDouble>, Double> history : tree.histories().entrySet()) {
        double chain = 1;
        for (double one : Logs.likelihood(SETUP, rows(history.getKey()), changes(world))) {
          chain *= one;
        }
        assertEquals(history.getValue(), chain, 1e-12, bits + " " + history.getKey());
        sum += chain;
      }
      assertEquals(1, sum, 1e-9);
      assertTrue(tree.histories().size() >= 243, "3 outcomes in each of 5 pings at least");
    }
  }

  /** To 1e-4: a forecast leaves out what hardly ever happens. */
  @ParameterizedTest
  @ValueSource(ints = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15})
  void forecast_isTheAverageOverHistories(int bits) {
    for (boolean byFactor : new boolean[] {false, true}) {
      HistoryTree.World world = world(bits, byFactor);
      HistoryTree tree = new HistoryTree(world, pings());
      List<ReadingDistribution> forecast =
          Logs.forecast(SETUP, rowsWithoutReadings(), changes(world));
      for (int ping = 0; ping < PLACES_M.length; ping++) {
        double silent = 0;
        Map<Double, Double> read = new TreeMap<>();
        for (Map.Entry<List<OptionalDouble>, Double> one : tree.histories().entrySet()) {
          OptionalDouble reading = one.getKey().get(ping);
          if (reading.isPresent()) {
            read.merge(reading.getAsDouble(), one.getValue(), Double::sum);
          } else {
            silent += one.getValue();
          }
        }
        assertEquals(silent, forecast.get(ping).noEchoProbability(), 1e-4, bits + " " + ping);
        for (Map.Entry<Double, Double> one : read.entrySet()) {
          double step = forecast.get(ping).probabilityOfStep(one.getKey());
          assertEquals(one.getValue(), step, 1e-4, bits + " ping " + ping + " " + one.getKey());
        }
      }
    }
  }

  /** All that a sequence remembers ends with it: each run's forecast is the first run's. */
  @Test
  void forecast_startsAnewWithEachRun() {
    List<ReadingRow> two = new ArrayList<>(rowsWithoutReadings());
    for (ReadingRow row : rowsWithoutReadings()) {
      two.add(new ReadingRow("other", row.sensor(), row.timeS(), row.pose(), row.reading()));
    }
    List<ReadingDistribution> forecast = Logs.forecast(SETUP, two, changes(world(ALL, false)));
    for (int ping = 0; ping < PLACES_M.length; ping++) {
      ReadingDistribution again = forecast.get(ping + PLACES_M.length);
      for (double range = 0; range < 2; range += 0.05) {
        assertEquals(forecast.get(ping).echoUpTo(range), again.echoUpTo(range), 0);
      }
    }
  }

  /** So many pings are in bursts that bursts of the length asked for would leave none between. */
  @ParameterizedTest
  @CsvSource({"0.9, 1, 1", "0.6, 1.2, 0.7", "0.5, 1, 1"})
  void bursts_keepTheirShare(double share, double length, double depth) {
    Burst burst = new Burst(share, length, depth);
    assertEquals(share, share * (1 - burst.ends()) + (1 - share) * burst.begins(), 1e-15);
    assertTrue(burst.begins() <= 1 && burst.ends() <= 1);
    List<ReadingDistribution> forecast =
        Logs.forecast(SETUP, rowsWithoutReadings(), List.of(burst));
    List<ReadingDistribution> plain = Logs.forecast(SETUP, rowsWithoutReadings(), List.of());
    for (int ping = 0; ping < PLACES_M.length; ping++) {
      double heard = 1 - plain.get(ping).noEchoProbability();
      double expected = heard * (1 - share * depth);
      assertEquals(expected, 1 - forecast.get(ping).noEchoProbability(), 1e-12);
    }
  }

  /** A range that is scaled and shifted is so once, not again in its ghost. */
  @Test
  void ghost_ofAScaledReading_isScaledOnce() {
    List<Change> changes =
        List.of(new PreviousPing(1, 1, 0.5, 0), new SoundSpeed(1.1), new RangeOffset(0.2));
    double first = HistoryTree.rounded(1.1 * 0.875 + 0.2);
    double ghost = 1.1 * (0.875 - 0.5) + 0.2;
    List<ReadingRow> rows =
        List.of(
            Logs.row(0, Pose.of(0, 0, 0), OptionalDouble.of(first)),
            Logs.row(1, Pose.of(0, 0, 0), OptionalDouble.of(HistoryTree.rounded(ghost))));
    assertEquals(1, Logs.likelihood(SETUP, rows, changes)[1], 1e-12);
  }

  /** Twice 0.875 m less what was read before and so much that 0.575 m is left. */
  @Test
  void nearerByPrevious_standsInThePlaceOfTheEcho() {
    double shift = 2 * 0.875 - HistoryTree.rounded(0.875) - 0.575;
    List<Change> changes = List.of(new NearerByPrevious(0.4, 2, -1, shift, 0));
    double[] plain = Logs.likelihood(SETUP, twice(0.875, 0.875), List.of());
    assertEquals(0.4 * plain[1], Logs.likelihood(SETUP, twice(0.875, 0.575), changes)[1], 1e-12);
    assertEquals(0.6 * plain[1], Logs.likelihood(SETUP, twice(0.875, 0.875), changes)[1], 1e-12);
    double far = Logs.likelihood(SETUP, twice(0.875, 1.475), List.of())[1];
    assertEquals(far, Logs.likelihood(SETUP, twice(0.875, 1.475), changes)[1], 1e-12);
    // After a miss there is nothing that could come first.
    List<ReadingRow> missed = List.of(Logs.row(0, Pose.of(0, 0, 0), OptionalDouble.of(0.875)));
    assertEquals(
        Logs.likelihood(SETUP, missed, List.of())[0],
        Logs.likelihood(SETUP, missed, changes)[0],
        1e-12);
  }

  /** Twice 0.875 m less what was read before and what sound does in the pause: 0.575 m. */
  @Test
  void secondBounce_standsInThePlaceOfTheEcho() {
    double shift = 2 * 0.875 - HistoryTree.rounded(0.875) - 0.575;
    List<Change> changes = List.of(new SecondBounce(0.4, shift, 0, 0.02));
    double[] plain = Logs.likelihood(SETUP, twice(0.875, 0.875), List.of());
    assertEquals(0.4 * plain[1], Logs.likelihood(SETUP, twice(0.875, 0.575), changes)[1], 1e-12);
    assertEquals(0.6 * plain[1], Logs.likelihood(SETUP, twice(0.875, 0.875), changes)[1], 1e-12);
    // What is hardly nearer than the echo, or comes while the sensor is deaf, is none.
    for (Change none :
        List.of(
            new SecondBounce(0.4, shift + 0.575 - 0.85, 0, 0.02),
            new SecondBounce(0.4, shift, 0, 0.6))) {
      assertEquals(plain[1], Logs.likelihood(SETUP, twice(0.875, 0.875), List.of(none))[1], 1e-12);
    }
  }

  /** The threshold of 0.95 m is 0.1 m less after a miss, so that 1 m is 0.15 m beyond it. */
  @Test
  void hysteresis_inMetres() {
    List<Change> changes = List.of(new Hysteresis(1, 1, 0.1));
    SensingSetup nearer = new SensingSetup(SETUP.sensor(), Scenes.of(Scenes.box(1, 0, 0.85)), 6.5);
    SensingSetup alone = new SensingSetup(SETUP.sensor(), Scenes.of(Scenes.box(1, 0, 0.95)), 6.5);
    List<ReadingRow> rows = twice(0.875, 0.875);
    assertEquals(
        Logs.likelihood(nearer, rows, List.of())[0],
        Logs.likelihood(alone, rows, changes)[0],
        1e-12);
    assertEquals(
        Logs.likelihood(alone, rows, List.of())[1],
        Logs.likelihood(alone, rows, changes)[1],
        1e-12);
  }

  private static List<ReadingRow> twice(double firstM, double thenM) {
    return List.of(
        Logs.row(0, Pose.of(0, 0, 0), OptionalDouble.of(HistoryTree.rounded(firstM))),
        Logs.row(1, Pose.of(0, 0, 0), OptionalDouble.of(HistoryTree.rounded(thenM))));
  }

  /**
   * Ghosts come of the echo, not of the noise in its reading: against 200,000 histories drawn at
   * random.
   */
  @Test
  void forecast_ofGhostsWithNoise_isTheAverageOverDraws() {
    SensingSetup noisy =
        new SensingSetup(Sonars.noisy(0, 0.05, 0, 0), Scenes.of(Scenes.box(1, 0, 2)), 6.5);
    List<Change> changes = List.of(new PreviousPing(0.5, 0.8, 0, 0), new Dropout(0.2));
    Random random = new Random(5);
    double[] sums = new double[3];
    double[] squares = new double[3];
    int[] echoes = new int[3];
    for (int draw = 0; draw < 200_000; draw++) {
      double before = -1;
      for (int ping = 0; ping < 3; ping++) {
        double distance = before > 0 && random.nextDouble() < 0.5 ? 0.8 * before : 0.875;
        before = random.nextDouble() < 0.2 ? -1 : distance;
        if (before > 0) {
          double read = distance + 0.05 * random.nextGaussian();
          echoes[ping]++;
          sums[ping] += read;
          squares[ping] += read * read;
        }
      }
    }
    List<ReadingRow> rows = rowsWithoutReadings().subList(0, 3);
    List<ReadingRow> still =
        rows.stream().map(r -> Logs.row(r.timeS(), Pose.of(0, 0, 0), Logs.SILENCE)).toList();
    List<ReadingDistribution> forecast = Logs.forecast(noisy, still, changes);
    for (int ping = 0; ping < 3; ping++) {
      double mean = 0;
      double square = 0;
      for (double range = 0; range < 2; range += 0.001) {
        double mass =
            forecast.get(ping).echoUpTo(range + 0.001) - forecast.get(ping).echoUpTo(range);
        mean += mass * (range + 0.0005);
        square += mass * (range + 0.0005) * (range + 0.0005);
      }
      assertEquals(echoes[ping] / 200_000.0, 1 - forecast.get(ping).noEchoProbability(), 0.004);
      assertEquals(sums[ping] / 200_000, mean, 0.003, "ping " + ping);
      assertEquals(squares[ping] / 200_000, square, 0.003, "ping " + ping);
    }
  }

  @Test
  void memoryOfOneKind_twice_isRefused() {
    List<Change> twice = List.of(new Hysteresis(0.9, 1), new Gain(1.1), new Hysteresis(1, 1.1));
    Refusal.check(() -> new ChangedModel(SETUP, twice), "Hysteresis", "at most one");
  }
}
