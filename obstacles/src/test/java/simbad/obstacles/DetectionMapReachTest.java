package simbad.obstacles;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import javax.vecmath.Vector3d;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import simbad.sonar.model.DetectionRule;
import simbad.sonar.scene.Scene;
import simbad.sonar.sensing.Readings;
import simbad.sonar.sensing.Sensor;
import simbad.sonar.sensing.TransducerPoses;

/**
 * The noise-free shadow sensor hears what the table says, and nothing else, at 100,000 poses round
 * each shipped obstacle.
 *
 * <p>Headings are uniform. Half of the places are uniform over a square round the shadow; the other
 * half have a uniform bearing and a uniform distance up to twice the threshold there, so that the
 * narrow parts of a shadow are visited as well. Poses that depend on less than 1 mm from the edge,
 * on a tiny angle of the cone or on a micrometre of a range limit are drawn again.
 */
class DetectionMapReachTest {
  static final double OFF_THE_EDGE_M = 1e-3;

  private static final int POSES = 100_000;
  private static final Path TABLES = Path.of("..", "data", "threshold-plots");

  /** Half of an inch, and an inch's half less a sixteenth: thesis, section 3.3. */
  private static final double H = 0.0127;

  private static final double IN = 0.0127 - 0.0254 / 16;

  private static final double X_M = 1.7;
  private static final double Z_M = -0.6;
  private static final double TURN_RAD = 2.1;

  static Stream<Arguments> obstacles() {
    Vector3d at = new Vector3d(X_M, 0, Z_M);
    double[] square = {H, H, H, -H, -H, -H, -H, H};
    double[] angle = {-H, -H, H, -H, H, H, IN, H, IN, -IN, -H, -IN};
    return Stream.of(
        Arguments.argumentSet(
            "square", "square-25mm.csv", square, new SquareObstacle(at, TURN_RAD)),
        Arguments.argumentSet("round", "round-25mm.csv", circle(), new RoundObstacle(at, TURN_RAD)),
        Arguments.argumentSet("angle", "angle-25mm.csv", angle, new AngleObstacle(at, TURN_RAD)));
  }

  /** The round one is sensed as a polygon of 24 corners, the first on its +x. */
  private static double[] circle() {
    double[] corners = new double[48];
    for (int i = 0; i < 24; i++) {
      corners[2 * i] = H * Math.cos(Math.toRadians(15 * i));
      corners[2 * i + 1] = H * Math.sin(Math.toRadians(15 * i));
    }
    return corners;
  }

  @ParameterizedTest
  @MethodSource("obstacles")
  void shadowSensor_atRandomPoses_agreesWithTheTable(
      String table, double[] body, SonarObstacle obstacle) throws IOException {
    TableReference reference = new TableReference(TABLES.resolve(table), body);
    assertEquals(72, reference.size());
    Ears ears = new Ears(obstacle);
    Random random = new Random(20140617);
    int echoes = 0;
    int redrawn = 0;
    int wrong = 0;
    String firstWrong = "";
    for (int i = 0; i < POSES; i++) {
      Draw draw = Draw.of(reference, random, i % 2 == 0);
      while (!draw.expected().clear()) {
        redrawn++;
        draw = Draw.of(reference, random, i % 2 == 0);
      }
      echoes += draw.expected().echo() ? 1 : 0;
      double heard = ears.rangeM(draw);
      // Both infinite, or the same distance but for rounding.
      if (heard != draw.expected().rangeM()
          && !(Math.abs(heard - draw.expected().rangeM()) < 1e-9)) {
        wrong++;
        firstWrong =
            wrong == 1 ? "; first at pose " + i + ": " + draw + ", heard " + heard : firstWrong;
      }
    }
    String counts =
        "%s: %d of %d wrong, %.2f %% echoes, %d drawn again%s"
            .formatted(table, wrong, POSES, 100.0 * echoes / POSES, redrawn, firstWrong);
    assertEquals(0, wrong, counts);
    // A cone of 55 degrees looks at a far post in 55/360 = 15 % of its headings, and some half of
    // the second half of the poses is in the shadow: 15 % / 4 and more.
    assertTrue(echoes > 0.035 * POSES && echoes < 0.2 * POSES, counts);
    assertTrue(redrawn < 0.1 * POSES, counts);
  }

  /** The reference itself, checked where it is analytic: against many points of the outline. */
  @ParameterizedTest
  @MethodSource("obstacles")
  void reference_cone_agreesWithManyPoints(String table, double[] body, SonarObstacle unused)
      throws IOException {
    TableReference reference = new TableReference(TABLES.resolve(table), body);
    Random random = new Random(5);
    int inCone = 0;
    for (int i = 0; i < 3000; i++) {
      double x = random.nextDouble(-0.1, 0.1);
      double z = random.nextDouble(-0.1, 0.1);
      double heading = random.nextDouble(0, 2 * Math.PI);
      double many = reference.nearestOfManyM(x, z, heading, 500);
      double exact = reference.nearestInConeM(x, z, heading, reference.halfAngleRad());
      // Points lie 0.05 mm apart: the nearest of them is at most that much too far, or missed
      // where the outline only grazes the cone.
      assertTrue(exact <= many + 1e-12, "pose " + i);
      if (many < Double.POSITIVE_INFINITY) {
        assertEquals(exact, many, 2e-4, "pose " + i);
        inCone++;
      }
    }
    assertTrue(inCone > 500 && inCone < 2500, "in the cone: " + inCone);
  }

  /** A pose in the obstacle's own frame with what the table says of it. */
  private record Draw(double x, double z, double headingRad, TableReference.Verdict expected) {
    static Draw of(TableReference reference, Random random, boolean overall) {
      double heading = random.nextDouble(-Math.PI, Math.PI);
      double x = random.nextDouble(-1.1, 1.1) * reference.greatestM();
      double z = random.nextDouble(-1.1, 1.1) * reference.greatestM();
      if (!overall) {
        double bearing = random.nextDouble(0, 2 * Math.PI);
        double radius = random.nextDouble(0, 2) * reference.thresholdM(bearing);
        x = radius * Math.sin(bearing);
        z = radius * Math.cos(bearing);
      }
      return new Draw(x, z, heading, reference.verdict(x, z, heading));
    }
  }

  /**
   * The product's sensor, asked by a pose in the own frame: FORMAT's turn and move are done here.
   */
  private static final class Ears {
    private final Sensor sensor;
    private final TransducerPoses poses = new TransducerPoses(1);
    private final Readings readings = new Readings(1);

    Ears(SonarObstacle obstacle) {
      Scene scene = new Scene(List.of(obstacle.asSensed()));
      sensor = DetectionRule.SHADOW.bind(Catalogue.srf04(), scene, new Random(1));
    }

    double rangeM(Draw draw) {
      double cos = Math.cos(TURN_RAD);
      double sin = Math.sin(TURN_RAD);
      poses.setPosition(
          0, X_M + draw.x() * cos + draw.z() * sin, 0.15, Z_M - draw.x() * sin + draw.z() * cos);
      double heading = draw.headingRad() + TURN_RAD;
      poses.setDirection(0, Math.cos(heading), 0, -Math.sin(heading));
      sensor.ping(poses, 0, readings);
      return readings.isEcho(0) ? readings.rangeM(0) : Double.POSITIVE_INFINITY;
    }
  }
}
