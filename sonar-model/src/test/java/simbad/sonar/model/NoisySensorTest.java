package simbad.sonar.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simbad.sonar.fixture.Scenes;
import simbad.sonar.fixture.Sonars;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.Reading;
import simbad.sonar.sensing.Readings;
import simbad.sonar.sensing.Sensor;
import simbad.sonar.sensing.TransducerPoses;

/**
 * Shares over many draws. Each interval is 4.5 standard deviations to either side, which chance
 * leaves once in 150,000; 14 of them make a false alarm in less than one of 10,000 changes of the
 * generator or of the order of draws. The seed is fixed, so that equal sources give equal verdicts.
 */
class NoisySensorTest {
  private static final int DRAWS = 20_000;
  private static final double DEVIATIONS = 4.5;

  private static List<Reading> draw(SonarSpec sensor, Scene scene, int draws, long seed) {
    TransducerPoses poses = new TransducerPoses(1);
    poses.setDirection(0, 1, 0, 0);
    Readings readings = new Readings(1);
    Sensor bound = DetectionRule.NOISY.bind(sensor, scene, new Random(seed));
    List<Reading> drawn = new ArrayList<>();
    for (int i = 0; i < draws; i++) {
      bound.ping(poses, i * 0.05, readings);
      drawn.add(readings.reading(0));
    }
    return drawn;
  }

  private static double[] ranges(List<Reading> readings) {
    return readings.stream()
        .filter(Echo.class::isInstance)
        .mapToDouble(reading -> ((Echo) reading).rangeM())
        .toArray();
  }

  private static void checkShare(double expected, long count) {
    double deviation = Math.sqrt(expected * (1 - expected) / DRAWS);
    assertEquals(expected, (double) count / DRAWS, DEVIATIONS * deviation + 1e-12);
  }

  /** A box at 2 m, threshold T, edge 0.1 m, miss rate m: (1 - m) / (1 + exp((2 - T) / 0.1)). */
  @ParameterizedTest
  @CsvSource({
    "2, 0, 0.5",
    "2, 0.2, 0.4",
    "2.1, 0.1, 0.657952720767",
    "1.9, 0, 0.26894142137",
    "1, 0, 4.539786870e-5",
    "4, 0.3, 0.7",
    "0, 0, 0"
  })
  void shareOfEchoes_isTheProbability(double thresholdM, double missRate, double expected) {
    Scene scene = Scenes.of(Scenes.box(2, 0, thresholdM));
    List<Reading> drawn = draw(Sonars.noisy(0.01, 0.005, missRate, 0.1), scene, DRAWS, 11);
    checkShare(expected, ranges(drawn).length);
  }

  /** Each of two boxes is missed once in four: 3/4 read the near one, 3/16 the far one. */
  @Test
  void sharesOfTwoObstacles_areNearestFirst() {
    Scene scene = Scenes.of(Scenes.box(3, 0, 9), Scenes.box(2, 0, 9));
    double[] ranges = ranges(draw(Sonars.noisy(0, 0.01, 0.25, 0), scene, DRAWS, 12));
    long near = Arrays.stream(ranges).filter(range -> range < 2.3).count();
    checkShare(0.75, near);
    checkShare(0.1875, ranges.length - near);
  }

  /** The mean of n ranges has the deviation s / sqrt n, their deviation s / sqrt(2 n). */
  @Test
  void ranges_scatterAroundTheDistance() {
    double[] ranges =
        ranges(draw(Sonars.noisy(0, 0.02, 0, 0), Scenes.of(Scenes.box(2, 0, 9)), DRAWS, 13));
    double mean = Arrays.stream(ranges).average().orElseThrow();
    double variance = Arrays.stream(ranges).map(r -> (r - mean) * (r - mean)).sum() / (DRAWS - 1);
    assertEquals(1.875, mean, DEVIATIONS * 0.02 / Math.sqrt(DRAWS));
    assertEquals(0.02, Math.sqrt(variance), DEVIATIONS * 0.02 / Math.sqrt(2 * DRAWS));
  }

  @Test
  void ranges_areStepsOfTheResolution() {
    List<Reading> drawn =
        draw(Sonars.noisy(0.05, 0.04, 0, 0), Scenes.of(Scenes.box(2, 0, 9)), 500, 14);
    long different = drawn.stream().distinct().count();
    assertTrue(different > 3 && different < 12, different + " different readings");
    for (double range : ranges(drawn)) {
      assertEquals(0, Math.IEEEremainder(range, 0.05), 1e-12);
    }
  }

  @Test
  void sameSeed_sameReadings() {
    SonarSpec sensor = Sonars.noisy(0, 0.02, 0.3, 0.1);
    Scene scene = Scenes.of(Scenes.box(2, 0, 2.1));
    assertEquals(draw(sensor, scene, 100, 5), draw(sensor, scene, 100, 5));
    assertNotEquals(draw(sensor, scene, 100, 5), draw(sensor, scene, 100, 6));
  }
}
