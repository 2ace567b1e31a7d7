package simbad.obstacles;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Map;
import java.util.Random;
import java.util.SplittableRandom;
import java.util.concurrent.atomic.AtomicInteger;
import javax.media.j3d.TriangleArray;
import javax.vecmath.Point3d;
import javax.vecmath.Vector3d;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.lifecycle.AfterContainer;
import simbad.sonar.format.TableDocument;
import simbad.sonar.model.DetectionRule;
import simbad.sonar.shape.ThresholdTable;

/**
 * An echo never happens without the sensor's cone overlapping the triangles of the shadow's mesh:
 * the mesh that the window shows, turned and moved here, not by the product.
 */
class EchoNeedsOverlapTest {
  private static final double HALF_ANGLE_RAD = Math.toRadians(27.5);
  private static final double MAX_RANGE_M = 6;
  private static final int POSES_A_TRY = 10;
  private static final int TRIES = 150;

  private static final AtomicInteger pings = new AtomicInteger();
  private static final AtomicInteger shadowEchoes = new AtomicInteger();
  private static final AtomicInteger overlapEchoes = new AtomicInteger();
  private static final AtomicInteger overlaps = new AtomicInteger();

  @Property(tries = TRIES, seed = "20140617")
  void shadowEcho_meansOverlap(
      @ForAll @IntRange(max = 3) int which,
      @ForAll @DoubleRange(min = -3, max = 3) double x,
      @ForAll @DoubleRange(min = -3, max = 3) double z,
      @ForAll @DoubleRange(min = -7, max = 7) double turnRad,
      @ForAll long seed) {
    SonarObstacle obstacle = obstacle(which, x, z, turnRad, seed);
    shadowEchoes.addAndGet(check(DetectionRule.SHADOW, obstacle, turnRad, seed));
  }

  @Property(tries = TRIES, seed = "20140618")
  void overlapEcho_meansOverlap_andTheOtherWayRound(
      @ForAll @IntRange(max = 3) int which,
      @ForAll @DoubleRange(min = -3, max = 3) double x,
      @ForAll @DoubleRange(min = -3, max = 3) double z,
      @ForAll @DoubleRange(min = -7, max = 7) double turnRad,
      @ForAll long seed) {
    SonarObstacle obstacle = obstacle(which, x, z, turnRad, seed);
    overlapEchoes.addAndGet(check(DetectionRule.OVERLAP, obstacle, turnRad, seed));
  }

  /** So that nothing passes on nothing. Twelve sonars ping at each pose. */
  @AfterContainer
  static void echoes_wereSubstantial() {
    int perRule = TRIES * POSES_A_TRY * Bench.SONARS;
    String counts =
        "%d and %d echoes, %d overlaps, of %d pings"
            .formatted(shadowEchoes.get(), overlapEchoes.get(), overlaps.get(), pings.get());
    assertTrue(pings.get() == 2 * perRule, counts);
    assertTrue(shadowEchoes.get() > 0.02 * perRule, counts);
    assertTrue(overlapEchoes.get() > 0.1 * perRule, counts);
    assertTrue(overlaps.get() < 0.8 * pings.get(), counts);
  }

  private static SonarObstacle obstacle(int which, double x, double z, double turnRad, long seed) {
    Vector3d at = new Vector3d(x, 0, z);
    return switch (which) {
      case 0 -> new SquareObstacle(at, turnRad);
      case 1 -> new RoundObstacle(at, turnRad);
      case 2 -> new AngleObstacle(at, turnRad);
      default -> new SonarObstacle(at, turnRad, anyType(new Random(seed)));
    };
  }

  /** A spiky table of 3 to 40 bearings, some of 0. */
  private static ObstacleType anyType(Random random) {
    double[] thresholds = new double[random.nextInt(3, 41)];
    for (int i = 0; i < thresholds.length; i++) {
      thresholds[i] = random.nextInt(6) == 0 ? 0 : random.nextDouble(0.05, 3);
    }
    return new ObstacleType(
        "any", CrossSections.angle(), new TableDocument(ThresholdTable.of(thresholds), Map.of()));
  }

  /** Pings at several poses; returns the echoes. */
  private static int check(DetectionRule rule, SonarObstacle obstacle, double turnRad, long seed) {
    SonarBelt belt =
        new SonarBelt(Bench.SONARS, Catalogue.srf04(), rule, new SplittableRandom(seed));
    Bench bench = new Bench(belt, obstacle);
    double[][][] mesh = worldMesh(obstacle, turnRad);
    Random random = new Random(seed);
    int echoes = 0;
    for (int i = 0; i < POSES_A_TRY; i++) {
      double distance = random.nextDouble(0, i % 2 == 0 ? 9 : 2);
      double direction = random.nextDouble(0, 2 * Math.PI);
      Vector3d at = place(obstacle);
      bench.ping(
          at.x + distance * Math.cos(direction),
          at.z + distance * Math.sin(direction),
          random.nextDouble(-Math.PI, Math.PI));
      echoes += checkPing(rule, bench, mesh);
    }
    return echoes;
  }

  private static int checkPing(DetectionRule rule, Bench bench, double[][][] mesh) {
    Point3d robot = new Point3d();
    bench.robot.getCoords(robot);
    int echoes = 0;
    for (int i = 0; i < Bench.SONARS; i++) {
      double heading = bench.robot.getHeadingRad() + Math.toRadians(30 * i);
      boolean echo = bench.robot.belt.hasHit(i);
      boolean overlap = overlap(robot.x, robot.z, heading, mesh);
      String where = rule + " at " + robot + ", heading " + heading;
      assertTrue(overlap || !echo, where + ": echo without overlap");
      assertTrue(echo || !overlap || rule != DetectionRule.OVERLAP, where + ": overlap, no echo");
      pings.incrementAndGet();
      overlaps.addAndGet(overlap ? 1 : 0);
      echoes += echo ? 1 : 0;
    }
    return echoes;
  }

  private static boolean overlap(double x, double z, double heading, double[][][] mesh) {
    Sector cone = new Sector(x, z, heading, HALF_ANGLE_RAD, MAX_RANGE_M);
    for (double[][] triangle : mesh) {
      if (cone.overlaps(triangle[0], triangle[1], triangle[2])) {
        return true;
      }
    }
    return false;
  }

  private static Vector3d place(SonarObstacle obstacle) {
    javax.media.j3d.Transform3D transform = new javax.media.j3d.Transform3D();
    obstacle.getTranslationTransform(transform);
    Vector3d place = new Vector3d();
    transform.get(place);
    return place;
  }

  /** The triangles seen from above, x, z in the world: FORMAT's turn and move. */
  private static double[][][] worldMesh(SonarObstacle obstacle, double turnRad) {
    TriangleArray mesh = ShadowShape.geometry(obstacle.shadow(), 1);
    Vector3d at = place(obstacle);
    double[][][] triangles = new double[mesh.getVertexCount() / 3][3][];
    float[] own = new float[3];
    for (int i = 0; i < mesh.getVertexCount(); i++) {
      mesh.getCoordinate(i, own);
      double cos = Math.cos(turnRad);
      double sin = Math.sin(turnRad);
      triangles[i / 3][i % 3] =
          new double[] {at.x + own[0] * cos + own[2] * sin, at.z - own[0] * sin + own[2] * cos};
    }
    return triangles;
  }
}
