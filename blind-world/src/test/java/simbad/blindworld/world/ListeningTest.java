package simbad.blindworld.world;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.function.DoubleUnaryOperator;
import java.util.random.RandomGenerator;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The chance events of a set-up, thresholds in it, and the order in which changes are heard. */
class ListeningTest {

  private static final double NONE = Double.POSITIVE_INFINITY;
  private static final double NEAR = 1e-12;
  private static final Setup.Ripple FLAT = new Setup.Ripple(0, 1, 0);

  private static Setup setup(
      double tailShare, double persistence, Setup.Ripple ripple, double rim) {
    return new Setup(0.01, 0.1, 0.02, tailShare, 3, persistence, ripple, rim, 0);
  }

  /** By body: whether it is kept, and anew; then the same of the range, with its tail. */
  @Test
  void luck_isDrawnAnewOrKept() {
    Setup setup = setup(0.25, 0.5, FLAT, 0);
    double[] first = {0.1, 0.7, 0.9, 0.8, 0.1, 0.2};
    double[] second = {0.4, 0.3, 0.6, 0.35, 0.6, 0.3};
    double[] third = {0.6, 0.45, 0.4, 0.9, 0.4, 0.2};
    double[] all =
        IntStream.range(0, 18)
            .mapToDouble(i -> (i < 6 ? first : i < 12 ? second : third)[i % 6])
            .toArray();
    Luck luck = new Luck(new FixedChance(all).gaussian(1, -2, 9), 2);
    luck.draw(setup);
    assertEquals(0.7, luck.uniform(0), "nothing is kept at first");
    assertEquals(0.8, luck.uniform(1));
    assertEquals(0.06, luck.noiseM(), NEAR, "of the tail");
    luck.draw(setup);
    assertEquals(0.7, luck.uniform(0), "kept");
    assertEquals(0.35, luck.uniform(1));
    assertEquals(-0.04, luck.noiseM(), NEAR);
    luck.draw(setup);
    assertEquals(0.45, luck.uniform(0));
    assertEquals(0.35, luck.uniform(1), "kept");
    assertEquals(-0.04, luck.noiseM(), NEAR, "kept");
  }

  private static Sight sight(int body, double bearingRad, double offAxisRad) {
    return new Sight(body, 1, bearingRad, 1, offAxisRad, 2);
  }

  /** 1 + s (0.7 sin(n b + p + i) + 0.5 sin((n + 3) b - 2 p + 2 i)) at the bearing b, body i. */
  @Test
  void ripple_isTwoWavesByBearing() {
    Setup.Ripple ripple = new Setup.Ripple(0.1, 2, 0.3);
    double expected = 1 + 0.1 * (0.7 * Math.sin(1.4 + 0.3 + 1) + 0.5 * Math.sin(3.5 - 0.6 + 2));
    assertEquals(expected, ripple.factor(1, 0.7), NEAR);
    assertEquals(ripple.factor(1, 0.7), ripple.factor(1, 0.7 + 2 * Math.PI), 1e-9);
    assertEquals(2 * expected, setup(0, 0, ripple, 0).thresholdM(sight(1, 0.7, 0), 0.3), NEAR);
    assertEquals(2, setup(0, 0, FLAT, 0).thresholdM(sight(1, 0.7, 0), 0.3));
  }

  /** Over the last 0.1 rad of a cone of 0.3 rad it falls by a tenth, on either side. */
  @ParameterizedTest
  @CsvSource({"0, 2", "0.2, 2", "0.25, 1.9", "-0.25, 1.9", "0.3, 1.8", "-0.275, 1.85"})
  void threshold_fallsAtTheRim(double offAxisRad, double expectedM) {
    Sight sight = sight(0, 0, offAxisRad);
    assertEquals(expectedM, setup(0, 0, FLAT, 0.1).thresholdM(sight, 0.3), NEAR);
    assertEquals(2, setup(0, 0, FLAT, 0).thresholdM(sight, 0.3), NEAR);
  }

  @Test
  void nominal_isWhatTheSensorSays() {
    Sensor sensor = new Sensor("s", 0.3, 0.02, 5, 0.1, 343, 0.01, 0.004, 0.1, 0.03, 0.1);
    assertEquals(
        new Setup(0.03, 0.1, 0.004, 0, 1, 0, new Setup.Ripple(0, 1, 0), 0, 0),
        Setup.nominal(sensor));
  }

  private static Scene scene(Sensor sensor) {
    return new Scene(5, sensor, List.of(TestWorlds.post("p", 0, 0, 3)));
  }

  /** An echo of which one in ten is missed; at the threshold a half of the others is left. */
  @Test
  void chance_fallsAtTheThreshold() {
    Sensor sensor = new Sensor("s", 0.3, 0.5, 4, 0.1, 343, 0, 0, 0.1, 0.02, 0.1);
    Recording rows = TestWorlds.approach(3.04, 2.96, 3);
    World.Listening listening = new World(scene(sensor), Setup.nominal(sensor), List.of()).at(rows);
    double[] chances = chances(listening, rows);
    assertEquals(0.9 / (1 + Math.exp(2)), chances[0], 1e-9);
    assertEquals(0.45, chances[1], 1e-9);
    assertEquals(0.9 / (1 + Math.exp(-2)), chances[2], 1e-9);
  }

  /** The post's surface is 0.02 m before its middle; it is read from 0.5 to 2.5 m. */
  @Test
  void chance_isNoneOutsideTheRanges() {
    Sensor sensor = new Sensor("s", 0.3, 0.5, 2.5, 0.1, 343, 0, 0, 0, 1e-6, 0.1);
    Recording rows = TestWorlds.approach(2.53, 0.49, 103);
    World.Listening listening = new World(scene(sensor), Setup.nominal(sensor), List.of()).at(rows);
    double[] chances = chances(listening, rows);
    assertEquals(0, chances[0]);
    assertEquals(1, chances[1], NEAR);
    // 0.53 m is the last but two: 0.51, 0.49 are too near.
    assertEquals(1, chances[100], NEAR);
    assertEquals(0, chances[101]);
  }

  private static double[] chances(World.Listening listening, Recording rows) {
    return IntStream.range(0, rows.size())
        .mapToDouble(i -> listening.chance(i, listening.sights().get(i).get(0)))
        .toArray();
  }

  /** A post at 1 m is 1.15 degrees to each side; a cone of 10 degrees, 3 wider, has it until 14. */
  @Test
  void wideningAndChanges_makeTheBeam() {
    Sensor sensor = TestWorlds.sureSensor(10);
    Setup wide = new Setup(1e-6, 0, 0, 0, 1, 0, FLAT, 0, Math.toRadians(3));
    Change twice =
        new Change() {
          @Override
          public Beam beam(String name, Beam beam) {
            return new Beam(beam.axisRad(), (name.equals("s") ? 2 : 1) * beam.halfAngleRad());
          }
        };
    assertEquals(14, widestDeg(new World(scene(sensor), wide, List.of()), "s"));
    assertEquals(27, widestDeg(new World(scene(sensor), wide, List.of(twice)), "s"));
    assertEquals(14, widestDeg(new World(scene(sensor), wide, List.of(twice)), "t"));
  }

  private static int widestDeg(World world, String name) {
    int widest = 0;
    for (int deg = 0; deg < 40; deg++) {
      Row row = new Row("r", name, 0, new Pose(-1, 0, Math.toRadians(deg)));
      double[] read = world.at(new Recording(List.of(row))).read(1);
      widest = read[0] < NONE ? deg : widest;
    }
    return widest;
  }

  private static Change heard(DoubleUnaryOperator threshold, DoubleUnaryOperator all) {
    Hearing hearing =
        new Hearing() {
          @Override
          public double thresholdM(double thresholdM, Sight sight, Ping ping) {
            return threshold.applyAsDouble(thresholdM);
          }

          @Override
          public double echoM(double distanceM, Ping ping) {
            return all.applyAsDouble(distanceM);
          }

          @Override
          public double rangeM(double rangeM, Ping ping) {
            return all.applyAsDouble(rangeM);
          }

          @Override
          public double steppedM(double readingM, double rangeM, Ping ping) {
            return all.applyAsDouble(readingM);
          }

          @Override
          public double reportedM(double readingM, Ping ping) {
            return all.applyAsDouble(readingM);
          }
        };
    return new Change() {
      @Override
      public Hearing hearing(Recording recording, Track track, long repeatSeed) {
        return hearing;
      }
    };
  }

  /** Each place of the way doubles and then adds one: 4 times 2 x + 1 of 0.98 m. */
  @Test
  void changes_actInTheirOrderAtEachPlace() {
    Scene scene = scene(TestWorlds.sureSensor(15));
    Recording rows = TestWorlds.approach(1, 1, 2);
    List<Change> changes = List.of(heard(t -> t, x -> 2 * x), heard(t -> t, x -> x + 1));
    double[] read = TestWorlds.read(scene, rows, changes);
    assertEquals(16 * 0.98 + 15, read[0], 1e-3);
    List<Change> deaf = List.of(heard(t -> 3 * t, x -> x), heard(t -> t - 8.5, x -> x));
    assertEquals(NONE, TestWorlds.read(scene, rows, deaf)[0], "3 * 3 - 8.5 m is nearer than it is");
    List<Change> hears = List.of(heard(t -> t - 2.5, x -> x), heard(t -> 3 * t, x -> x));
    assertEquals(0.98, TestWorlds.read(scene, rows, hears)[0], 1e-4);
    List<Change> never = List.of(heard(t -> 0, x -> x));
    assertEquals(NONE, TestWorlds.read(scene, rows, never)[0]);
  }

  /** What is not heard has no range, but a report. */
  @Test
  void silence_isReportedOnly() {
    Scene scene = scene(TestWorlds.sureSensor(15));
    Change code =
        new Change() {
          @Override
          public Hearing hearing(Recording recording, Track track, long repeatSeed) {
            return new Hearing() {
              @Override
              public double rangeM(double rangeM, Ping ping) {
                return 7;
              }

              @Override
              public double reportedM(double readingM, Ping ping) {
                return Math.min(readingM, 9);
              }
            };
          }
        };
    double[] read = TestWorlds.read(scene, TestWorlds.approach(3.5, 1, 2), List.of(code));
    assertArrayEquals(new double[] {9, 7}, read, NEAR);
  }

  /** Steps go down; a range is never below nothing. */
  @Test
  void range_isStepped() {
    Sensor sensor = new Sensor("s", 0.3, 0.02, 5, 0.1, 343, 0.05, 0, 0, 1e-6, 0.1);
    Recording rows = TestWorlds.approach(1.01, 1.01, 2);
    assertEquals(0.95, TestWorlds.read(scene(sensor), rows, List.of())[0], 1e-9);
    Change negative =
        new Change() {
          @Override
          public Hearing hearing(Recording recording, Track track, long repeatSeed) {
            return new Hearing() {
              @Override
              public double rangeM(double rangeM, Ping ping) {
                return -3;
              }
            };
          }
        };
    assertEquals(0, TestWorlds.read(scene(sensor), rows, List.of(negative))[0], NEAR);
  }

  private static Change aside(boolean restless) {
    return new Change() {
      @Override
      public boolean restless() {
        return restless;
      }

      @Override
      public List<Pose> poses(Recording recording, List<Pose> poses, RandomGenerator random) {
        double by = random.nextDouble(0, 0.5);
        return poses.stream().map(p -> p.at(p.xM() - by, p.zM())).toList();
      }
    };
  }

  /** Poses by chance are one and the same for all repeats, unless the change is restless. */
  @Test
  void restlessPoses_areOthersInEachRepeat() {
    Scene scene = scene(TestWorlds.sureSensor(15));
    Setup setup = Setup.nominal(scene.sensor());
    Recording rows = TestWorlds.approach(1, 0.9, 2);
    World.Listening still = new World(scene, setup, List.of(aside(false))).at(rows);
    assertEquals(still.read(1)[0], still.read(2)[0]);
    World.Listening restless = new World(scene, setup, List.of(aside(true))).at(rows);
    assertNotEquals(restless.read(1)[0], restless.read(2)[0]);
    assertEquals(restless.read(1)[0], restless.read(1)[0]);
    double[] read = restless.read(3);
    assertEquals(0.1, read[0] - read[1], 1e-3);
  }

  /** 19 levels of 0.05 to 0.95; of 20 repeats each is a value of its own. */
  @Test
  void quantiles_areValuesOfTheRepeats() {
    int[] repeat = {20};
    Repeats falling = seed -> new double[] {repeat[0]--, 2, repeat[0] > 9 ? NONE : 1};
    Forecast forecast = Forecast.of(falling, 30, 20, 1);
    assertEquals(3, forecast.size());
    double[] rising = IntStream.rangeClosed(1, 19).mapToDouble(q -> q).toArray();
    assertArrayEquals(rising, forecast.row(0));
    double[] half = forecast.row(2);
    assertEquals(1, half[9]);
    assertEquals(30, half[10]);
    half[9] = 99;
    assertEquals(1, forecast.row(2)[9], "a copy");
    assertEquals(0.05, Forecast.level(0), NEAR);
    assertThrows(IllegalArgumentException.class, () -> Forecast.of(falling, 0, 1, 1));
  }

  /** By a metre under the upper ten of 19, or over the lower nine, and over two rows the mean. */
  @Test
  void loss_weighsEachLevelByItsSide() {
    double[] stairs = new double[Forecast.LEVELS];
    Arrays.fill(stairs, 9, 19, 1);
    Forecast forecast = new Forecast(new double[][] {stairs, stairs});
    double under = 100 * 2 * 0.05 * 55 / 19;
    double over = 100 * 2 * 0.05 * 45 / 19;
    assertEquals(under, forecast.lossCm(0, 0), 1e-9);
    assertEquals(over, forecast.lossCm(1, 1), 1e-9);
    assertEquals((under + over) / 2, forecast.gapCm(new double[] {0, NONE}, 1), 1e-9);
    assertTrue(forecast.csv().endsWith("0.0000,1.0000,1.0000" + ",1.0000".repeat(8) + "\n"));
  }
}
