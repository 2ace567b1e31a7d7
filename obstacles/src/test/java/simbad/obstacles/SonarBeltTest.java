package simbad.obstacles;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import java.util.concurrent.atomic.AtomicInteger;
import javax.vecmath.Vector3d;
import javax.vecmath.Vector3f;
import org.junit.jupiter.api.Test;
import simbad.sim.Box;
import simbad.sim.EnvironmentDescription;
import simbad.sonar.model.DetectionRule;
import simbad.sonar.sensing.Readings;
import simbad.sonar.sensing.Sensor;
import simbad.sonar.sensing.TransducerPoses;

class SonarBeltTest {
  private static Vector3d at(double x, double z) {
    return new Vector3d(x, 0, z);
  }

  private static String heard(SonarBelt belt) {
    StringBuilder numbers = new StringBuilder();
    for (int i = 0; i < belt.getNumSensors(); i++) {
      numbers.append(belt.hasHit(i) ? i + " " : "");
    }
    return numbers.toString().strip();
  }

  /**
   * The round post 1 m ahead, threshold 2 m. Sonars look every 30 degrees with cones of 27.5 either
   * side: a centre 0 degrees off is in the cone of sonar 0 alone; at 1 m its outline spans 0.7
   * degrees, too little to reach the cones of 1 and 11, which begin 2.5 degrees off.
   */
  @Test
  void postAhead_isHeardAheadAlone() {
    SonarBelt belt = Bench.belt(DetectionRule.SHADOW);
    Bench bench = new Bench(belt, new RoundObstacle(at(1, 0), 0));
    bench.ping(0, 0, 0);
    assertEquals("0", heard(belt));
    // The polygon's corner at its -x is nearest.
    assertEquals(1 - 0.0127, belt.getMeasurement(0), 1e-9);
  }

  /** 15 degrees off, it is in two cones; to the left, which is -z at heading 0. */
  @Test
  void postBetweenTwoSonars_isHeardByBoth() {
    SonarBelt belt = Bench.belt(DetectionRule.SHADOW);
    double angle = Math.toRadians(15);
    Bench bench = new Bench(belt, new RoundObstacle(at(Math.cos(angle), -Math.sin(angle)), 0));
    bench.ping(0, 0, 0);
    assertEquals("0 1", heard(belt));
    bench.ping(0, 0, Math.toRadians(90));
    // Turned left by 90 degrees, what was 15 degrees left is 75 degrees right: 285 = 9.5 * 30.
    assertEquals("9 10", heard(belt));
  }

  /** Two metres is the round post's threshold, to its centre; straight bits lie 2 mm inside. */
  @Test
  void threshold_isToTheCentre() {
    SonarBelt belt = Bench.belt(DetectionRule.SHADOW);
    Bench bench = new Bench(belt, new RoundObstacle(at(0, 0), 0));
    bench.ping(-1.997, 0, 0);
    assertEquals("0", heard(belt));
    bench.ping(-2.001, 0, 0);
    assertEquals("", heard(belt));
  }

  @Test
  void original_hearsToTwoAndAHalfMetres() {
    SonarBelt belt = Bench.belt(DetectionRule.ORIGINAL);
    Bench bench = new Bench(belt, new RoundObstacle(at(0, 0), 0));
    bench.ping(-2.51, 0, 0);
    // Nearest point 2.51 - 0.0127 = 2.4973 m.
    assertEquals("0", heard(belt));
    bench.ping(-2.52, 0, 0);
    assertEquals("", heard(belt));
  }

  @Test
  void detachedObstacle_isNotHeard() {
    SonarBelt belt = Bench.belt(DetectionRule.SHADOW);
    RoundObstacle post = new RoundObstacle(at(1, 0), 0);
    Bench bench = new Bench(belt, post);
    bench.ping(0, 0, 0);
    assertTrue(belt.oneHasHit());
    post.detach();
    bench.ping(0, 0, 0);
    assertFalse(belt.oneHasHit());
    post.attach();
    bench.ping(0, 0, 0);
    assertTrue(belt.oneHasHit());
  }

  @Test
  void movedObstacle_isHeardWhereItIsNow() {
    SonarBelt belt = Bench.belt(DetectionRule.SHADOW);
    RoundObstacle post = new RoundObstacle(at(1, 0), 0);
    Bench bench = new Bench(belt, post);
    bench.ping(0, 0, 0);
    post.translateTo(at(0.5, 0));
    bench.ping(0, 0, 0);
    assertEquals(1.5 - 0.0127, belt.getMeasurement(0), 1e-9);
    post.translateTo(at(-3, 0));
    bench.ping(0, 0, 0);
    // Now at -1.5: behind.
    assertEquals("6", heard(belt));
  }

  /** The angle's threshold is 3.16 m at bearing 0 (+z) and 0.22 m at 25 degrees. */
  @Test
  void turnedObstacle_isHeardAsTurned() {
    SonarBelt belt = Bench.belt(DetectionRule.SHADOW);
    AngleObstacle angle = new AngleObstacle(at(0, 0), 0);
    Bench bench = new Bench(belt, angle);
    bench.ping(0, 2, Math.PI / 2);
    assertEquals("0", heard(belt));
    angle.rotateY(-Math.toRadians(25));
    bench.ping(0, 2, Math.PI / 2);
    assertEquals("", heard(belt));
  }

  @Test
  void boxes_areNotHeard() {
    SonarBelt belt = Bench.belt(DetectionRule.ORIGINAL);
    EnvironmentDescription unused = new EnvironmentDescription();
    Bench bench = new Bench(belt, new Box(at(1, 0), new Vector3f(0.2f, 1, 0.2f), unused));
    bench.ping(0, 0, 0);
    assertEquals("", heard(belt));
  }

  @Test
  void twoObstacles_theNearerIsRead() {
    SonarBelt belt = Bench.belt(DetectionRule.SHADOW);
    Bench bench = new Bench(belt, new RoundObstacle(at(1.5, 0), 0), new RoundObstacle(at(1, 0), 0));
    bench.ping(0, 0, 0);
    assertEquals(1 - 0.0127, belt.getMeasurement(0), 1e-9);
  }

  /** Bound once, then again only when the static objects change; a reset reaches the sensor. */
  @Test
  void sensor_isBoundAnewOnlyWhenTheWorldChanges() {
    AtomicInteger bindings = new AtomicInteger();
    AtomicInteger resets = new AtomicInteger();
    SonarBelt belt =
        new SonarBelt(
            1,
            Catalogue.srf04(),
            (spec, scene, random) -> {
              bindings.incrementAndGet();
              return new Deaf(resets);
            },
            new SplittableRandom(1));
    RoundObstacle post = new RoundObstacle(at(1, 0), 0);
    Bench bench = new Bench(belt, post);
    bench.ping(0, 0, 0);
    bench.ping(0, 1, 0);
    assertEquals(1, bindings.get());
    post.rotateY(1);
    bench.ping(0, 0, 0);
    assertEquals(2, bindings.get());
    bench.reset();
    assertEquals(1, resets.get());
  }

  private record Deaf(AtomicInteger resets) implements Sensor {
    @Override
    public void ping(TransducerPoses poses, double timeS, Readings readings) {
      readings.clear();
    }

    @Override
    public void reset() {
      resets.incrementAndGet();
    }
  }
}
