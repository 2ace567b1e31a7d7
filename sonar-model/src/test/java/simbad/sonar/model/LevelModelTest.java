package simbad.sonar.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.sonar.fixture.Scenes;
import simbad.sonar.fixture.Shapes;
import simbad.sonar.fixture.Sonars;
import simbad.sonar.frame.Placement;
import simbad.sonar.frame.Point;
import simbad.sonar.frame.Pose;
import simbad.sonar.level.Beam;
import simbad.sonar.level.Curve;
import simbad.sonar.level.CurveBeam;
import simbad.sonar.level.LevelLaw;
import simbad.sonar.level.TargetStrength;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.scene.TableDetection;
import simbad.sonar.scene.UniformDetection;
import simbad.sonar.shape.Outline;
import simbad.sonar.shape.ThresholdTable;

/** The level model in closed form. */
class LevelModelTest {
  private static final SonarSpec EXACT = Sonars.exact(27.5, 0.03, 6);

  /** 1 dB of scatter, 1 dB per degree off the axis, no walk; a pulse of 4 cm. */
  private static LevelLaw law(double levelDb) {
    return new LevelLaw(
        levelDb,
        1.5,
        1.3,
        new CurveBeam(Curve.of(0, 0, 180, -180)),
        Curve.of(0, 20, 1, 0),
        1,
        Curve.constant(0),
        Curve.constant(0.005),
        0.04);
  }

  private static LevelModel model(SonarSpec sensor, LevelLaw law, Obstacle... obstacles) {
    List<TargetStrength> strengths = new ArrayList<>();
    for (int i = 0; i < obstacles.length; i++) {
      strengths.add(TargetStrength.uniform(0));
    }
    return new LevelModel(sensor, law, List.of(obstacles), strengths);
  }

  private static Obstacle disc(double xM, double zM, double radiusM) {
    List<Point> corners = new ArrayList<>();
    for (int i = 0; i < 720; i++) {
      double angle = Math.toRadians(i / 2.0);
      corners.add(new Point(radiusM * Math.sin(angle), radiusM * Math.cos(angle)));
    }
    return new Obstacle(
        "disc", new Placement(xM, zM, 0), Outline.of(corners), new UniformDetection(1));
  }

  /**
   * On the axis the distances of a table come back to a millimetre, at every bearing and at those
   * between, whatever the receiver: walking away, the chance passes 1/2 there.
   */
  @ParameterizedTest
  @ValueSource(ints = {3, 36, 72})
  void table_onTheAxis_comesBack(int size) {
    Random random = new Random(size);
    ThresholdTable table = Shapes.anyTable(random, size, false);
    Obstacle post =
        new Obstacle(
            "post",
            new Placement(0.3, -0.2, 0.7),
            Shapes.square(0, 0, 1e-5),
            new TableDetection(table));
    LevelModel model = new LevelModel(Sonars.noisy(0, 0, 0, 0), Scenes.of(post));
    for (int i = 0; i < 4 * size; i++) {
      double bearing = i * Math.PI / (2 * size);
      double threshold = table.thresholdM(bearing);
      if (threshold > 0.05) {
        assertTrue(chance(model, post, bearing, threshold - 0.001) > 0.5, "inside, " + i);
        assertTrue(chance(model, post, bearing, threshold + 0.001) < 0.5, "outside, " + i);
      }
    }
  }

  /** A sensor that looks at the centre. */
  private static double chance(LevelModel model, Obstacle post, double bearing, double r) {
    Placement at = post.worldFromObstacle();
    double turned = bearing + at.turnRad();
    double x = at.xM() + r * Math.sin(turned);
    double z = at.zM() + r * Math.cos(turned);
    return model.sight(0, Pose.of(x, z, Math.atan2(z - at.zM(), at.xM() - x))).echoProbability();
  }

  /** 2 m from the centre of a disc of 0.2 m, 10 degrees beside it: 40 + 0 - 10 - loss(2 m). */
  @Test
  void disc_byHand() {
    LevelModel model = model(EXACT, law(40), disc(2, 0, 0.2));
    LevelSight sight = model.sight(0, Pose.of(0, 0, Math.toRadians(10)));
    assertEquals(2, sight.centreDistanceM(), 1e-12);
    assertEquals(1.8, sight.nearestM(), 1e-12);
    assertEquals(10, Math.toDegrees(sight.offAxisRad()), 1e-9);
    assertEquals(40 - 10 - 30 * Math.log10(2) - 5.2, sight.excessDb(), 1e-9);
    assertEquals(1, sight.echoProbability(), 1e-12);
  }

  /** Round the disc it is the same echo from everywhere, as long as the sensor looks at it. */
  @Test
  void disc_isAlikeAllRound() {
    LevelModel model = model(EXACT, law(14), disc(0, 0, 0.2));
    for (int i = 0; i < 72; i++) {
      double bearing = Math.toRadians(5 * i);
      double x = 2 * Math.sin(bearing);
      double z = 2 * Math.cos(bearing);
      LevelSight sight = model.sight(0, Pose.of(x, z, Math.atan2(z, -x)));
      assertEquals(14 - 30 * Math.log10(2) - 5.2, sight.excessDb(), 1e-9);
      assertEquals(1.8, sight.nearestM(), 1e-12);
    }
  }

  /**
   * A wall answers from the foot of its normal, where half way to the sensor's mirror image: 3 m
   * before a wall at x = 3 the off-axis angle is the heading, and the range stays 3 m.
   */
  @ParameterizedTest
  @CsvSource({"0", "5", "-20", "45"})
  void wall_isTheMirrorImage(double headingDeg) {
    Outline slab = Shapes.outline(0, -5, 0.1, -5, 0.1, 5, 0, 5);
    Obstacle wall = new Obstacle("wall", new Placement(3, 0, 0), slab, new UniformDetection(4));
    LevelLaw law =
        new LevelLaw(
            60,
            1,
            1.3,
            law(0).beam(),
            Curve.constant(0),
            1,
            Curve.constant(0),
            Curve.constant(0),
            0.04);
    LevelModel model = model(EXACT, law, wall);
    // The mirror image stands at (6, 1.3); half way is the foot.
    Point sensor = new Point(0, 1.3);
    double mirrorM = sensor.distanceM(new Point(6, 1.3));
    LevelSight sight =
        model.sight(0, new Pose(sensor, simbad.sonar.frame.Heading.ofDegrees(headingDeg)));
    assertEquals(mirrorM / 2, sight.nearestM(), 1e-12);
    assertEquals(Math.abs(headingDeg), Math.toDegrees(sight.offAxisRad()), 1e-9);
    double r = Math.hypot(3, 1.3);
    assertEquals(60 - Math.abs(headingDeg) - 20 * Math.log10(r) - 2.6 * r, sight.excessDb(), 1e-9);
  }

  /**
   * A scene and its mirror image at the x axis read alike; the axis of symmetry belongs to both.
   */
  @Test
  void mirroredScenes_readAlike() {
    Outline bracket =
        Shapes.outline(-0.1, -0.1, 0.1, -0.1, 0.1, -0.08, -0.08, -0.08, -0.08, 0.1, -0.1, 0.1);
    ThresholdTable lobes = ThresholdTable.of(2, 1, 0.4, 1.5, 2.5, 1.7, 0.6, 1.2);
    ThresholdTable mirroredLobes = ThresholdTable.of(2.5, 1.5, 0.4, 1, 2, 1.2, 0.6, 1.7);
    Random random = new Random(3);
    for (int i = 0; i < 500; i++) {
      double turn = random.nextDouble(-3, 3);
      double z = random.nextDouble(-1, 1);
      Obstacle one =
          new Obstacle("a", new Placement(1, z, turn), bracket, new TableDetection(lobes));
      // At the x axis: z changes its sign, and a body of bearing b has bearing pi - b.
      Obstacle other =
          new Obstacle(
              "a",
              new Placement(1, -z, -turn),
              Shapes.mirrored(bracket),
              new TableDetection(mirroredLobes));
      double heading = random.nextDouble(-1, 1);
      ReadingDistribution here =
          new LevelModel(EXACT, Scenes.of(one)).distribution(Pose.of(0, 0, heading));
      ReadingDistribution there =
          new LevelModel(EXACT, Scenes.of(other)).distribution(Pose.of(0, 0, -heading));
      assertEquals(here.noEchoProbability(), there.noEchoProbability(), 1e-9, "case " + i);
    }
  }

  /**
   * Before an angle that is open towards the sensor both free edges are equally near. Which of them
   * answers must not depend on the side to which the sensor looks.
   */
  @Test
  void symmetricBody_readsAlikeToBothSides() {
    Outline open = Shapes.outline(0.1, -0.3, 0.4, 0, 0.1, 0.3, 0.42, 0);
    Obstacle angle = new Obstacle("angle", new Placement(1, 0, 0), open, new UniformDetection(2));
    LevelModel model = new LevelModel(EXACT, Scenes.of(angle));
    for (double heading = 0; heading < 0.6; heading += 0.02) {
      LevelSight left = model.sight(0, Pose.of(0, 0, heading));
      LevelSight right = model.sight(0, Pose.of(0, 0, -heading));
      assertEquals(Math.hypot(1.1, 0.3), left.nearestM(), 1e-12);
      assertEquals(left.offAxisRad(), right.offAxisRad(), 1e-12);
      assertEquals(left.excessDb(), right.excessDb(), 1e-9);
    }
    double tip = Math.atan2(0.3, 1.1);
    assertEquals(0, model.sight(0, Pose.of(0, 0, tip)).offAxisRad(), 1e-12);
  }

  /** The chance is (1 - m) Phi(excess / sd): 1/2 at the threshold, 0.8413 at one deviation. */
  @ParameterizedTest
  @CsvSource({"0, 0, 0.5", "1, 0, 0.841344746", "-2, 0, 0.022750132", "1, 0.25, 0.63100856"})
  void chance_isTheNormalDistributions(double excessDb, double missRate, double expected) {
    LevelLaw law = law(excessDb + 30 * Math.log10(2) + 5.2);
    LevelModel model = model(Sonars.noisy(0, 0, missRate, 0), law, disc(2, 0, 0.1));
    assertEquals(expected, model.sight(0, Pose.of(0, 0, 0)).echoProbability(), 1e-8);
    assertEquals(1 - expected, model.distribution(Pose.of(0, 0, 0)).noEchoProbability(), 1e-8);
  }

  /** Without scatter it is a step; at the threshold itself it is heard, as by the shadow. */
  @Test
  void chance_withoutScatter_isAStep() {
    assertEquals(1, Crossings.chance(0, 0, 0));
    assertEquals(0, Crossings.chance(-1e-6, 0, 0));
    assertEquals(0.9, Crossings.chance(3, 0, 0.1), 1e-12);
  }

  @ParameterizedTest
  @CsvSource({"1.9, 6, 1", "1.91, 6, 0", "0.03, 1.9, 1", "0.03, 1.89, 0"})
  void range_limitsBelongToIt(double minRangeM, double maxRangeM, double expected) {
    LevelModel model = model(Sonars.exact(27.5, minRangeM, maxRangeM), law(60), disc(2, 0, 0.1));
    assertEquals(expected, model.sight(0, Pose.of(0, 0, 0)).echoProbability(), 1e-12);
    assertEquals(1 - expected, model.distribution(Pose.of(0, 0, 0)).noEchoProbability(), 1e-12);
  }

  /** Two discs of equal strength to either side, equally near: 3.01 dB more than each alone. */
  @Test
  void energies_ofEqualEchoes_add() {
    LevelLaw law = law(21.5);
    LevelModel both = model(EXACT, law, disc(2, 0.3, 0.1), disc(2, -0.3, 0.1));
    double alone = both.sight(0, Pose.of(0, 0, 0)).excessDb();
    double sum = alone + 10 * Math.log10(2);
    assertTrue(alone < -1 && sum > 1, "alone " + alone);
    assertEquals(
        1 - NormalDistribution.cumulative(sum),
        both.distribution(Pose.of(0, 0, 0)).noEchoProbability(),
        1e-9);
  }

  /** 3.9 cm apart they overlap: the chance is that of the sum; 4.1 cm apart each has its own. */
  @ParameterizedTest
  @CsvSource({"0.039, true", "0.041, false"})
  void energies_addWithinOnePulse(double apartM, boolean overlap) {
    LevelLaw law = law(21);
    LevelModel model = model(EXACT, law, disc(2, 0.3, 0.1), disc(2 + apartM, -0.3, 0.1));
    Pose pose = Pose.of(0, 0, 0);
    double near = model.sight(0, pose).excessDb();
    double far = model.sight(1, pose).excessDb();
    double apartInRange = model.sight(1, pose).nearestM() - model.sight(0, pose).nearestM();
    assertEquals(apartM, apartInRange, 0.001);
    double sum = 10 * Math.log10(Math.pow(10, near / 10) + Math.pow(10, far / 10));
    double silent =
        overlap
            ? 1 - NormalDistribution.cumulative(sum)
            : (1 - NormalDistribution.cumulative(near)) * (1 - NormalDistribution.cumulative(far));
    ReadingDistribution reading = model.distribution(pose);
    assertEquals(silent, reading.noEchoProbability(), 1e-9);
    double middle = (model.sight(0, pose).nearestM() + model.sight(1, pose).nearestM()) / 2;
    assertEquals(NormalDistribution.cumulative(near), reading.echoUpTo(middle), 1e-3);
  }

  /** Of the rest of a pair that overlaps, both share the scatter: none is heard twice. */
  @Test
  void shares_anyCrowd_addUpToOne() {
    Random random = new Random(11);
    LevelLaw wide = law(14.5).withBeam(Beam.everywhere());
    for (int i = 0; i < 300; i++) {
      Crossings crossings = new Crossings(walking(wide), 0.1);
      int size = random.nextInt(1, 9);
      for (int k = 0; k < size; k++) {
        crossings.add(random.nextDouble(1, 1.2), Math.exp(random.nextGaussian()));
      }
      crossings.settle();
      double sum = crossings.silence(size - 1);
      for (int k = 0; k < size; k++) {
        assertTrue(crossings.share(k) >= 0, "case " + i);
        assertTrue(k == 0 || crossings.meanM(k) >= crossings.meanM(k - 1), "case " + i);
        sum += crossings.share(k);
      }
      assertEquals(1, sum, 1e-12);
    }
  }

  private static LevelLaw walking(LevelLaw law) {
    return new LevelLaw(
        law.levelDb(),
        law.spreadingExponent(),
        law.absorptionDbPerM(),
        law.beam(),
        law.receiverThresholdDb(),
        law.excessSdDb(),
        Curve.of(0, 0.03, 20, 0),
        law.noiseM(),
        law.pulseLengthM());
  }

  /** A weak near echo walks 3 cm; a strong one 1 cm behind it crosses first and is read. */
  @Test
  void crossings_theEarliestIsRead() {
    Crossings crossings = new Crossings(walking(law(0)), 0);
    crossings.add(1, 1);
    crossings.add(1.01, 1000);
    crossings.settle();
    assertEquals(1.01, crossings.meanM(0), 1e-3);
    assertEquals(1, crossings.share(0), 1e-9);
    assertEquals(0, crossings.share(1), 1e-9);
    assertEquals(1.01, crossings.firstM(), 1e-3);
  }

  /** Weaker by 3 dB, the same targets: what was lost at 2 m is lost where 3 dB less is lost. */
  @Test
  void heardBy_keepsTheTargetsStrength() {
    Scene scene = Scenes.of(disc(2, 0, 0.1));
    SonarSpec sensor = Sonars.noisy(0, 0, 0, 0);
    LevelModel believed =
        new LevelModel(
            sensor,
            Scenes.of(
                new Obstacle(
                    "disc",
                    new Placement(2, 0, 0),
                    scene.obstacles().get(0).outline(),
                    new UniformDetection(2))));
    LevelModel weaker = believed.heardBy(believed.law().withLevelDb(believed.law().levelDb() - 3));
    assertEquals(0, believed.sight(0, Pose.of(0, 0, 0)).excessDb(), 1e-9);
    assertEquals(-3, weaker.sight(0, Pose.of(0, 0, 0)).excessDb(), 1e-9);
    assertEquals(believed.size(), weaker.size());
  }

  /** The walk and the noise are those of the excess; the resolution comes last. */
  @Test
  void reading_isDistanceWalkNoiseResolution() {
    LevelLaw law =
        new LevelLaw(
            40,
            0,
            0,
            Beam.everywhere(),
            Curve.constant(20),
            0,
            Curve.of(0, 0.03, 40, 0),
            Curve.of(0, 0.02, 40, 0),
            0.04);
    LevelModel model = model(Sonars.noisy(0.05, 9, 0, 0), law, disc(2, 0, 0.1));
    ReadingDistribution reading = model.distribution(Pose.of(0, 0, 0));
    // Excess 20 dB: walk 1.5 cm, noise 1 cm round 1.915 m, in steps of 5 cm.
    assertEquals(NormalDistribution.cumulative((1.95 - 1.915) / 0.01), reading.echoUpTo(1.9), 1e-6);
    assertEquals(NormalDistribution.cumulative((1.9 - 1.915) / 0.01), reading.echoUpTo(1.85), 1e-6);
  }
}
