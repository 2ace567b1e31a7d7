package simbad.blindworld.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

/** Scenes whose readings follow from a drawing. */
class WorldTest {

  private static final double NONE = Double.POSITIVE_INFINITY;

  @Test
  void postAhead_isReadAtItsSurface() {
    Scene scene = new Scene(5, TestWorlds.sureSensor(15), List.of(TestWorlds.post("p", 0, 0, 2)));
    double[] read = TestWorlds.read(scene, TestWorlds.approach(2.5, 0.5, 5), List.of());
    // The edge is sharp at 2 m from the centre; the surface is 2 cm nearer than that.
    assertEquals(NONE, read[0]);
    for (int k = 2; k < 5; k++) {
      assertEquals(2.5 - 0.5 * k - 0.02, read[k], 1e-4);
    }
  }

  @Test
  void nearestOfTwo_isRead_andASilentOneIsNot() {
    Scene scene =
        new Scene(
            5,
            TestWorlds.sureSensor(15),
            List.of(TestWorlds.post("near", -0.5, 0, 0), TestWorlds.post("far", 0, 0, 3)));
    double[] read = TestWorlds.read(scene, TestWorlds.approach(2, 1, 2), List.of());
    assertArrayEquals(new double[] {1.98, 0.98}, read, 1e-4);
  }

  @Test
  void postBesideTheAxis_isSeenOnlyWithinTheCone() {
    Scene scene = new Scene(5, TestWorlds.sureSensor(20), List.of(TestWorlds.post("p", 0, 0, 3)));
    // Seen from 1 m the post's rim lies asin(0.02) = 1.146 degrees beside its middle.
    for (double beside : new double[] {0, 15, 21, 22, -21, -22}) {
      Pose pose = new Pose(-1, 0, Math.toRadians(beside));
      Recording one = new Recording(List.of(new Row("r", "s", 0, pose)));
      boolean heard = TestWorlds.read(scene, one, List.of())[0] < NONE;
      assertEquals(Math.abs(beside) < 21.14, heard, beside + " degrees");
    }
  }

  @Test
  void chord_betweenFourEqualRadii_isTheSquaresSide() {
    Shadow square = new Shadow(List.of(1.0, 1.0, 1.0, 1.0));
    assertEquals(Math.sqrt(0.5), square.atM(Math.PI / 4), 1e-12);
    assertEquals(1, square.atM(-Math.PI / 2), 1e-12);
    assertEquals(0, new Shadow(List.of(0.0, 0.0, 1.0)).atM(0), 1e-12);
  }

  @Test
  void bearing_growsWhenAnObstacleTurnsClockwise() {
    Body post = Body.of(TestWorlds.post("p", 0, 0, 1));
    Pose pose = new Pose(0, 1, Math.PI / 2);
    Beam beam = new Beam(0, 0.3);
    double before = post.seenFrom(pose, beam, 0).bearingRad();
    double after = post.turned(Math.toRadians(-5)).seenFrom(pose, beam, 0).bearingRad();
    assertEquals(0, before, 1e-12);
    assertEquals(5, Math.toDegrees(after - before), 1e-9);
  }

  @Test
  void obstacleThatLeaves_isHeardOnlyWhileItIsThere() {
    Scene scene = new Scene(5, TestWorlds.sureSensor(15), List.of(TestWorlds.post("p", 0, 0, 3)));
    Change leaves =
        new Change() {
          @Override
          public List<Body> bodies(List<Body> bodies) {
            return List.of(bodies.get(0).during(Double.NEGATIVE_INFINITY, 0.25));
          }
        };
    double[] read = TestWorlds.read(scene, TestWorlds.approach(2, 1, 6), List.of(leaves));
    assertArrayEquals(
        new boolean[] {true, true, true, false, false, false},
        heard(read),
        "pings at 0, 0.1, ... 0.5 s");
  }

  private static void assertArrayEquals(boolean[] expected, boolean[] found, String message) {
    org.junit.jupiter.api.Assertions.assertArrayEquals(expected, found, message);
  }

  private static boolean[] heard(double[] read) {
    boolean[] heard = new boolean[read.length];
    for (int i = 0; i < read.length; i++) {
      heard[i] = read[i] < NONE;
    }
    return heard;
  }

  @Test
  void persistence_repeatsWhatChanceDid() {
    Sensor sensor = new Sensor("s", 0.3, 0.02, 5, 0.1, 343, 0, 0.01, 0.5, 0.01, 0.1);
    Scene scene = new Scene(5, sensor, List.of(TestWorlds.post("p", 0, 0, 3)));
    Setup nominal = Setup.nominal(sensor);
    Setup together = new Setup(0.01, 0.5, 0.01, 0, 1, 0.9, nominal.ripple(), 0, 0);
    Recording still = TestWorlds.approach(1, 1, 2000);
    assertTrue(changes(scene, together, still) < 0.2 * changes(scene, nominal, still));
  }

  private static long changes(Scene scene, Setup setup, Recording rows) {
    double[] read = new World(scene, setup, List.of()).at(rows).read(3);
    return IntStream.range(1, read.length)
        .filter(i -> (read[i] < NONE) != (read[i - 1] < NONE))
        .count();
  }

  @Test
  void missRateAndNoise_areWhatTheSceneSays() {
    Sensor sensor = new Sensor("s", 0.3, 0.02, 5, 0.1, 343, 0, 0.01, 0.2, 0.01, 0.1);
    Scene scene = new Scene(5, sensor, List.of(TestWorlds.post("p", 0, 0, 3)));
    double[] read = TestWorlds.read(scene, TestWorlds.approach(1, 1, 20000), List.of());
    double[] echoes = Arrays.stream(read).filter(r -> r < NONE).toArray();
    // Five standard errors: 0.2 +- 0.0028 and 0.01 +- 0.00006 over 20,000 pings.
    assertEquals(0.8, echoes.length / 20000.0, 0.014);
    double mean = Arrays.stream(echoes).average().orElseThrow();
    double variance =
        Arrays.stream(echoes).map(r -> (r - mean) * (r - mean)).average().orElseThrow();
    assertEquals(0.98, mean, 4e-4);
    assertEquals(0.01, Math.sqrt(variance), 3e-4);
  }

  @Test
  void readings_areSteps() {
    Sensor sensor = new Sensor("s", 0.3, 0.02, 5, 0.1, 343, 0.02, 0.01, 0, 0.01, 0.1);
    Scene scene = new Scene(5, sensor, List.of(TestWorlds.post("p", 0, 0, 3)));
    for (double r : TestWorlds.read(scene, TestWorlds.approach(2, 1, 500), List.of())) {
      assertEquals(Math.rint(r / 0.02), r / 0.02, 1e-6);
    }
  }

  @Test
  void sameSeed_readsTheSame() {
    Sensor sensor = new Sensor("s", 0.3, 0.02, 5, 0.1, 343, 0.01, 0.01, 0.1, 0.03, 0.1);
    Scene scene = new Scene(5, sensor, List.of(TestWorlds.post("p", 0, 0, 1.5)));
    World.Listening rows =
        new World(scene, Setup.nominal(sensor), List.of()).at(TestWorlds.approach(2, 1, 500));
    org.junit.jupiter.api.Assertions.assertArrayEquals(rows.read(4), rows.read(4));
    assertTrue(!Arrays.equals(rows.read(4), rows.read(5)));
  }

  @Test
  void badShadowsAndOutlines_areRefused() {
    assertThrows(IllegalArgumentException.class, () -> new Shadow(List.of(1.0, 2.0)));
    assertThrows(IllegalArgumentException.class, () -> new Shadow(List.of(1.0, Double.NaN, 2.0)));
    assertThrows(
        IllegalArgumentException.class,
        () -> new Obstacle("o", new Point(0, 0), 0, List.of(), Shadow.uniform(1)));
  }

  private static void assertArrayEquals(double[] expected, double[] found, double delta) {
    org.junit.jupiter.api.Assertions.assertArrayEquals(expected, found, delta);
  }
}
