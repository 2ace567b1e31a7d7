package simbad.kernel.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.random.RandomGenerator;
import java.util.random.RandomGeneratorFactory;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;
import simbad.kernel.geometry.BallShape;
import simbad.kernel.geometry.BoxShape;
import simbad.kernel.geometry.CylinderShape;
import simbad.kernel.geometry.Placement;
import simbad.kernel.geometry.Ray;
import simbad.kernel.geometry.Shape;

class BodySceneTest {
  private static final double EPSILON = 1e-9;

  private static RandomGenerator generator(long seed) {
    return RandomGeneratorFactory.of("L64X128MixRandom").create(seed);
  }

  private static Shape randomShape(RandomGenerator random) {
    return switch (random.nextInt(3)) {
      case 0 -> BoxShape.ofSides(random.nextDouble(), random.nextDouble(), random.nextDouble());
      case 1 -> new CylinderShape(random.nextDouble(0.6), random.nextDouble());
      default -> new BallShape(random.nextDouble(0.6));
    };
  }

  private static Placement randomPlacement(RandomGenerator random) {
    Placement placement =
        Placement.at(random.nextDouble(-9, 9), random.nextDouble(), random.nextDouble(-9, 9));
    placement.turnAboutY(random.nextDouble(7));
    return placement;
  }

  private static Ray randomRay(RandomGenerator random) {
    Ray ray = new Ray();
    double heading = random.nextDouble(7);
    ray.setOrigin(random.nextDouble(-9, 9), 0.5, random.nextDouble(-9, 9));
    ray.setDirection(Math.cos(heading), 0, Math.sin(heading));
    ray.setLength(random.nextDouble(6));
    return ray;
  }

  private static Ray copy(Ray ray) {
    Ray copy = new Ray();
    copy.setToLocal(ray, new Placement());
    return copy;
  }

  /** What the tree must find: every part, one after the other. */
  private static double bruteForce(List<Solid> solids, Ray ray) {
    Ray rest = copy(ray);
    Ray local = new Ray();
    for (Solid solid : solids) {
      solid.refresh();
      if (solid.isPresent()) {
        solid.parts().forEach(part -> part.strike(rest, local));
      }
    }
    return rest.lengthM();
  }

  @Property(tries = 200, seed = "20140914")
  void strike_agreesWithBruteForce(
      @ForAll @IntRange(min = 0, max = 300) int count, @ForAll long seed) {
    RandomGenerator random = generator(seed);
    BodyScene scene = new BodyScene();
    List<Solid> solids = new ArrayList<>();
    List<Placement> placements = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      placements.add(randomPlacement(random));
      solids.add(new Solid(placements.get(i)).add(randomShape(random)));
      if (random.nextBoolean()) {
        scene.addFixed(solids.get(i));
      } else {
        scene.addMoving(solids.get(i));
      }
    }
    checkRays(scene, solids, random);
    for (int i = 0; i < count; i += 3) {
      placements.get(i).copyFrom(randomPlacement(random));
      solids.get(i).moved();
    }
    checkRays(scene, solids, random);
    for (int i = 0; i < count; i += 4) {
      solids.get(i).setPresent(false);
    }
    checkRays(scene, solids, random);
  }

  private static void checkRays(BodyScene scene, List<Solid> solids, RandomGenerator random) {
    Solid nobody = new Solid(new Placement());
    Neighbourhood near = new Neighbourhood();
    Ball ball = new Ball();
    for (int i = 0; i < 20; i++) {
      Ray ray = randomRay(random);
      final double expected = bruteForce(solids, ray);
      ball.set(ray.originX(), ray.originY(), ray.originZ(), ray.lengthM());
      scene.gather(ball, nobody, near);
      Ray local = copy(ray);
      assertEquals(expected < ray.lengthM(), near.strike(local));
      assertEquals(expected, local.lengthM(), EPSILON);
      scene.strike(ray);
      assertEquals(expected, ray.lengthM(), EPSILON);
    }
  }

  @Property(tries = 200, seed = "20140914")
  void strike_turnsWithTheScene(
      @ForAll @DoubleRange(min = -7, max = 7) double turnRad, @ForAll long seed) {
    RandomGenerator random = generator(seed);
    Placement turn = new Placement();
    turn.turnAboutY(turnRad);
    BodyScene straight = new BodyScene();
    BodyScene turned = new BodyScene();
    for (int i = 0; i < 30; i++) {
      Placement placement = randomPlacement(random);
      Placement turnedPlacement = new Placement();
      turnedPlacement.compose(turn, placement);
      Shape shape = randomShape(random);
      straight.addFixed(new Solid(placement).add(shape));
      turned.addFixed(new Solid(turnedPlacement).add(shape));
    }
    Ray ray = randomRay(random);
    Ray turnedRay = copy(ray);
    Placement back = new Placement();
    back.turnAboutY(-turnRad);
    turnedRay.setToLocal(ray, back);
    straight.strike(ray);
    turned.strike(turnedRay);
    assertEquals(ray.lengthM(), turnedRay.lengthM(), 1e-7);
  }

  @Property(tries = 200, seed = "20140914")
  void stopsBall_agreesWithBruteForce(
      @ForAll @IntRange(min = 0, max = 200) int count, @ForAll long seed) {
    RandomGenerator random = generator(seed);
    BodyScene scene = new BodyScene();
    List<Solid> solids = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      Solid solid = new Solid(randomPlacement(random)).add(randomShape(random));
      solid.setTraversable(i % 5 == 0);
      solid.setPresent(i % 7 != 0);
      solids.add(solid);
      scene.addFixed(solid);
    }
    for (int i = 0; i < 20; i++) {
      double x = random.nextDouble(-9, 9);
      double z = random.nextDouble(-9, 9);
      boolean expected =
          solids.stream()
              .filter(solid -> solid.isPresent() && !solid.isTraversable())
              .anyMatch(solid -> solid.extentTouchesBall(x, 0.5, z, 0.3));
      assertEquals(expected, scene.stopsBall(x, 0.5, z, 0.3));
    }
  }

  @Test
  void strike_passesThroughTheCarrier() {
    BodyScene scene = new BodyScene();
    Solid carrier = new Solid(new Placement()).add(new BallShape(0.5));
    scene.addMoving(carrier);
    scene.addMoving(new Solid(Placement.at(2, 0, 0)).add(new BallShape(0.5)));
    Ray ray = new Ray();
    ray.setDirection(1, 0, 0);
    ray.setLength(5);
    assertTrue(scene.strike(ray, carrier));
    assertEquals(1.5, ray.lengthM(), EPSILON);
  }

  @Test
  void stopsBall_isNotStoppedByMovingSolids() {
    BodyScene scene = new BodyScene();
    scene.addMoving(new Solid(new Placement()).add(new BallShape(0.5)));
    assertFalse(scene.stopsBall(0, 0, 0, 0.3));
  }

  @Test
  void solid_inAnotherScene_leavesTheFirst() {
    BodyScene first = new BodyScene();
    BodyScene second = new BodyScene();
    Solid solid = new Solid(new Placement()).add(new BallShape(0.5));
    first.addFixed(solid);
    assertTrue(first.stopsBall(0, 0, 0, 0.1));
    second.addFixed(solid);
    assertFalse(first.stopsBall(0, 0, 0, 0.1));
    assertTrue(second.stopsBall(0, 0, 0, 0.1));
  }

  @Test
  void ballTest_decidesNearTheExtent() {
    BodyScene scene = new BodyScene();
    Solid solid = new Solid(new Placement()).add(BoxShape.ofSides(2, 2, 2));
    solid.setBallTest((x, y, z, radius) -> x > 0);
    scene.addFixed(solid);
    assertTrue(scene.stopsBall(0.5, 0, 0, 0.1));
    assertFalse(scene.stopsBall(-0.5, 0, 0, 0.1));
    assertFalse(scene.stopsBall(5, 0, 0, 0.1));
  }

  @Test
  void spreadingSolids_areStillFound() {
    BodyScene scene = new BodyScene();
    List<Placement> placements = new ArrayList<>();
    List<Solid> solids = new ArrayList<>();
    for (int i = 0; i < 20; i++) {
      placements.add(Placement.at(0.01 * i, 0.5, 0));
      solids.add(new Solid(placements.get(i)).add(new BallShape(0.1)));
      scene.addMoving(solids.get(i));
    }
    RandomGenerator random = generator(3);
    for (int step = 0; step < 200; step++) {
      for (int i = 0; i < solids.size(); i++) {
        placements.get(i).moveBy(0.05 * Math.cos(i), 0, 0.05 * Math.sin(i));
        solids.get(i).moved();
      }
      checkRays(scene, solids, random);
    }
  }

  @Property(tries = 200, seed = "20140914")
  void nearPairs_agreeWithBruteForce(
      @ForAll @IntRange(min = 0, max = 60) int count, @ForAll long seed) {
    RandomGenerator random = generator(seed);
    NearPairs pairs = new NearPairs();
    double[][] balls = new double[count][4];
    for (int round = 0; round < 3; round++) {
      pairs.resize(count);
      for (int i = 0; i < count; i++) {
        for (int k = 0; k < 3; k++) {
          balls[i][k] = random.nextDouble(5);
        }
        balls[i][3] = random.nextDouble();
        pairs.setCentre(i, balls[i][0], balls[i][1], balls[i][2]);
        pairs.setRadius(i, balls[i][3]);
      }
      List<String> found = new ArrayList<>();
      pairs.sweep((lower, higher) -> found.add(lower + " " + higher));
      assertEquals(touching(balls), found);
    }
  }

  private static List<String> touching(double[][] balls) {
    List<String> pairs = new ArrayList<>();
    for (int i = 0; i < balls.length; i++) {
      for (int j = i + 1; j < balls.length; j++) {
        double dx = balls[i][0] - balls[j][0];
        double dy = balls[i][1] - balls[j][1];
        double dz = balls[i][2] - balls[j][2];
        double reach = balls[i][3] + balls[j][3];
        if (dx * dx + dy * dy + dz * dz <= reach * reach) {
          pairs.add(i + " " + j);
        }
      }
    }
    return pairs;
  }
}
