package simbad.sonar.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.sonar.fixture.Scenes;
import simbad.sonar.fixture.Sonars;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.sensing.Readings;
import simbad.sonar.sensing.Sensor;
import simbad.sonar.sensing.TransducerPoses;

/** Obstacles that are not looked at must be those that nothing hears. */
class EarshotTest {
  private static final SonarSpec SENSOR = Sonars.exact(27.5, 0.1, 3);
  private static final int TRANSDUCERS = 12;

  /** Crowds of obstacles of any kind on a plain of 6 m by 6 m. */
  private static List<Obstacle> crowd(Random random, int least) {
    List<Obstacle> obstacles = new ArrayList<>();
    while (obstacles.size() < least) {
      obstacles.addAll(Scenes.any(random).obstacles());
    }
    return obstacles;
  }

  private static PlacedObstacle[] placed(Random random, int count) {
    Scene scene = new Scene(crowd(random, count).subList(0, count));
    return PlacedObstacle.all(scene);
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 1, 2, 4, 5, 8, 9, 16, 17, 33, 100, 257})
  void find_anyCrowd_findsWhatLooksAtEachOneFind(int count) {
    Random random = new Random(count);
    PlacedObstacle[] obstacles = placed(random, count);
    double[] earshotM = random.doubles(count, 0, 1.5).toArray();
    EarshotTree tree = new EarshotTree(obstacles, earshotM);
    for (int i = 0; i < 200; i++) {
      double x = random.nextDouble(-5, 5);
      double z = random.nextDouble(-5, 5);
      double within = random.nextDouble(0.5);
      Set<Integer> expected = new TreeSet<>();
      for (int j = 0; j < count; j++) {
        if (obstacles[j].centreDistanceM(x, z) <= earshotM[j] + within) {
          expected.add(j);
        }
      }
      Set<Integer> found = new TreeSet<>();
      tree.find(x, z, within, found::add);
      assertEquals(expected, found);
    }
  }

  @Test
  void find_atTheRim_findsTheObstacle() {
    PlacedObstacle[] one = PlacedObstacle.all(Scenes.of(Scenes.box(2, 0, 1)));
    List<Integer> found = new ArrayList<>();
    new EarshotTree(one, new double[] {1}).find(1, 0, 0, found::add);
    assertEquals(List.of(0), found);
  }

  /** The logarithm: a place in a crowd 64 times as large costs hardly more than in a small one. */
  @Test
  void moveTo_largeCrowd_keepsOnlyWhatIsNear() {
    Obstacle[] row =
        IntStream.range(0, 4096).mapToObj(i -> Scenes.box(i, 0, 2)).toArray(Obstacle[]::new);
    PlacedObstacle[] obstacles = PlacedObstacle.all(Scenes.of(row));
    double[] earshotM = new double[obstacles.length];
    Arrays.fill(earshotM, 2);
    Earshot<PlacedObstacle> earshot = new Earshot<>(obstacles, earshotM);
    earshot.moveTo(2000.5, 0);
    assertTrue(earshot.size() >= 4 && earshot.size() <= 6, () -> "size " + earshot.size());
  }

  /** One obstacle at a time needs no tree; the nearest of such readings is that of all. */
  @ParameterizedTest
  @EnumSource(names = {"SHADOW", "OVERLAP", "ORIGINAL"})
  void ping_movingBeltInACrowd_readsTheNearestOfEachAlone(DetectionRule rule) {
    Random random = new Random(7);
    List<Obstacle> obstacles = crowd(random, 60);
    Sensor all = rule.bind(SENSOR, new Scene(obstacles), random);
    List<Sensor> alone =
        obstacles.stream().map(it -> rule.bind(SENSOR, Scenes.of(it), random)).toList();
    TransducerPoses poses = new TransducerPoses(TRANSDUCERS);
    for (int step = 0; step < 400; step++) {
      place(poses, step);
      Readings crowd = pinged(all, poses);
      Readings[] each = alone.stream().map(it -> pinged(it, poses)).toArray(Readings[]::new);
      for (int i = 0; i < TRANSDUCERS; i++) {
        assertEquals(nearestM(each, i), rangeM(crowd, i));
      }
    }
  }

  /** Along a spiral, with a leap in the middle; every other time on a ring round the place. */
  private static void place(TransducerPoses poses, int step) {
    double angle = 0.05 * step;
    double outM = 0.01 * step + (step < 200 ? 0 : 1);
    double ringM = step % 2 == 0 ? 0 : 0.1;
    for (int i = 0; i < TRANSDUCERS; i++) {
      double heading = angle + i * 2 * Math.PI / TRANSDUCERS;
      double x = Math.cos(heading);
      double z = -Math.sin(heading);
      poses.setPosition(
          i, outM * Math.cos(angle) + ringM * x, 0.1, outM * Math.sin(angle) + ringM * z);
      poses.setDirection(i, x, 0, z);
    }
  }

  private static Readings pinged(Sensor sensor, TransducerPoses poses) {
    Readings readings = new Readings(TRANSDUCERS);
    sensor.ping(poses, 0, readings);
    return readings;
  }

  private static double nearestM(Readings[] each, int transducer) {
    return Arrays.stream(each).mapToDouble(it -> rangeM(it, transducer)).min().orElseThrow();
  }

  private static double rangeM(Readings readings, int transducer) {
    return readings.isEcho(transducer) ? readings.rangeM(transducer) : Double.POSITIVE_INFINITY;
  }
}
