package simbad.sonar.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.sonar.fixture.Levels;
import simbad.sonar.fixture.Scenes;
import simbad.sonar.fixture.Sonars;
import simbad.sonar.frame.Placement;
import simbad.sonar.frame.Pose;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SensorLaw;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.scene.UniformDetection;
import simbad.sonar.sensing.Readings;
import simbad.sonar.sensing.Sensor;
import simbad.sonar.sensing.TransducerPoses;

/** The sensors of the level model before the model itself. */
class LevelSensorTest {
  private static final int TRANSDUCERS = 12;
  private static final double DEVIATIONS = 4.5;

  /** A wide beam and a long pulse, so that many echoes overlap. */
  private static final String WIDE =
      """
      "beam": {"two_way_db": [[0, 0], [40, -10], [180, -30]]}, "pulse_length_s": 0.001
      """;

  private static SonarSpec sensor(SonarSpec sensor, String level) {
    return sensor.withLaw(new SensorLaw(Optional.empty(), Levels.figures(level)));
  }

  private static Scene crowd(Random random, int least) {
    List<Obstacle> obstacles = new ArrayList<>();
    while (obstacles.size() < least) {
      obstacles.addAll(Scenes.any(random).obstacles());
    }
    return new Scene(obstacles);
  }

  private static void place(TransducerPoses poses, double x, double z, double turn) {
    for (int i = 0; i < TRANSDUCERS; i++) {
      double heading = turn + i * 2 * Math.PI / TRANSDUCERS;
      poses.setPosition(i, x, 0.1, z);
      poses.setDirection(i, Math.cos(heading), 0, -Math.sin(heading));
    }
  }

  /**
   * What bounds leave out is not heard: the belt reads what the model, asked without bounds and
   * without scatter, says for certain, to the little that faint echoes add to a sum.
   */
  @ParameterizedTest
  @ValueSource(strings = {"\"walk_m\": [[0, 0.03], [20, 0]]", WIDE})
  void certain_inACrowd_readsWhatTheModelSays(String level) {
    Random random = new Random(7);
    Scene scene = crowd(random, 40);
    SonarSpec sensor = sensor(Sonars.exact(27.5, 0.1, 3), level + ", \"excess_sd_db\": 0");
    LevelModel model = new LevelModel(sensor, scene);
    Sensor belt = DetectionRule.LEVEL.bind(sensor, scene, random);
    TransducerPoses poses = new TransducerPoses(TRANSDUCERS);
    Readings readings = new Readings(TRANSDUCERS);
    int echoes = 0;
    for (int step = 0; step < 400; step++) {
      place(poses, random.nextDouble(-3, 3), random.nextDouble(-3, 3), random.nextDouble(6));
      belt.ping(poses, 0, readings);
      for (int i = 0; i < TRANSDUCERS; i++) {
        Pose pose = Pose.of(poses.xM(i), poses.zM(i), poses.headingRad(i));
        ReadingDistribution expected = model.distribution(pose);
        String where = "step " + step + ", transducer " + i;
        assertEquals(expected.noEchoProbability() < 0.5, readings.isEcho(i), where);
        if (readings.isEcho(i)) {
          echoes++;
          assertEquals(expected.quantileM(0.5, 9), readings.rangeM(i), 1e-3, where);
        }
      }
    }
    assertTrue(echoes > 400 && echoes < 4700, echoes + " echoes of 4,800");
  }

  /**
   * Eight posts round the sensor, each 8.5 dB below the threshold, are heard together: 9.03 dB.
   * Each overlaps its neighbours in distance only, so that no bound may drop one for being faint
   * alone.
   */
  @ParameterizedTest
  @CsvSource({"8.5, 0, true", "9.5, 0, false", "8.5, 0.0099, true", "8.5, 0.0101, false"})
  void certain_faintEchoesTogether_areHeard(double faintDb, double stepM, boolean heard) {
    SonarSpec sensor =
        sensor(
            Sonars.exact(27.5, 0, 6),
            "\"beam\": {\"two_way_db\": [[0, 0]]}, \"temperature_c\": 20,"
                + " \"walk_m\": [[0, 0]], \"pulse_length_s\": 0.000408");
    double pulseM = sensor.levelLaw().pulseLengthM();
    assertEquals(0.07, pulseM, 1e-4);
    List<Obstacle> posts = new ArrayList<>();
    for (int i = 0; i < 8; i++) {
      double r = 1 + i * stepM;
      double threshold = sensor.levelLaw().firstLossM(sensor.levelLaw().strengthDb(r) - faintDb, 6);
      posts.add(post(r, i * Math.PI / 4, threshold));
    }
    TransducerPoses poses = new TransducerPoses(1);
    poses.setDirection(0, 1, 0, 0);
    Readings readings = new Readings(1);
    DetectionRule.LEVEL.bind(sensor, new Scene(posts), new Random(1)).ping(poses, 0, readings);
    assertEquals(heard, readings.isEcho(0));
    ReadingDistribution expected =
        new LevelModel(sensor, new Scene(posts)).distribution(Pose.of(0, 0, 0));
    assertEquals(heard, expected.noEchoProbability() < 0.5);
  }

  private static Obstacle post(double r, double bearing, double thresholdM) {
    return Scenes.box(
        new Placement(r * Math.sin(bearing), r * Math.cos(bearing), 0),
        new UniformDetection(thresholdM),
        1e-5);
  }

  /** Shares and means of 20,000 draws at places where several may be read. */
  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4})
  void noisy_drawsTheModelsDistribution(long seed) {
    Random random = new Random(seed);
    Scene scene = crowd(random, 8);
    SonarSpec sensor =
        sensor(Sonars.noisy(0.01, 0.02, 0.1, 0), WIDE + ", \"excess_sd_db\": 6, \"level_db\": 30");
    LevelModel model = new LevelModel(sensor, scene);
    Pose pose = Pose.of(random.nextDouble(-2, 2), random.nextDouble(-2, 2), random.nextDouble(6));
    ReadingDistribution expected = model.distribution(pose);
    int draws = 20_000;
    double[] ranges = draw(DetectionRule.LEVEL_NOISY.bind(sensor, scene, random), pose, draws);
    for (double limit = 0; limit < 6; limit += 0.25) {
      long upTo = 0;
      for (double range : ranges) {
        upTo += range <= limit + 1e-9 ? 1 : 0;
      }
      double share = expected.echoUpTo(limit);
      double deviation = Math.sqrt(share * (1 - share) / draws);
      assertEquals(share, (double) upTo / draws, DEVIATIONS * deviation + 1e-4, "to " + limit);
    }
  }

  private static double[] draw(Sensor sensor, Pose pose, int draws) {
    TransducerPoses poses = new TransducerPoses(1);
    poses.setPosition(0, pose.position().xM(), 0.1, pose.position().zM());
    double heading = pose.heading().radians();
    poses.setDirection(0, Math.cos(heading), 0, -Math.sin(heading));
    Readings readings = new Readings(1);
    double[] ranges = new double[draws];
    for (int i = 0; i < draws; i++) {
      sensor.ping(poses, i, readings);
      ranges[i] = readings.isEcho(0) ? readings.rangeM(0) : 99;
    }
    return ranges;
  }

  @Test
  void noisy_sameSeed_sameReadings() {
    Scene scene = crowd(new Random(1), 8);
    SonarSpec sensor = sensor(Sonars.noisy(0.01, 0.02, 0.1, 0), "\"excess_sd_db\": 6");
    Pose pose = Pose.of(0, 0, 1);
    double[] one = draw(DetectionRule.LEVEL_NOISY.bind(sensor, scene, new Random(3)), pose, 100);
    double[] again = draw(DetectionRule.LEVEL_NOISY.bind(sensor, scene, new Random(3)), pose, 100);
    assertEquals(List.of(boxed(one)), List.of(boxed(again)));
  }

  private static Double[] boxed(double[] values) {
    return java.util.Arrays.stream(values).boxed().toArray(Double[]::new);
  }

  /** A sensor that looks straight up has no heading on the plane, and hears nothing of it. */
  @ParameterizedTest
  @EnumSource(names = {"LEVEL", "LEVEL_NOISY"})
  void straightUp_hearsNothing(DetectionRule rule) {
    for (String level : List.of("", WIDE)) {
      TransducerPoses poses = new TransducerPoses(1);
      poses.setDirection(0, 0, 1, 0);
      Readings readings = new Readings(1);
      SonarSpec sensor = sensor(Sonars.exact(27.5, 0, 6), level);
      rule.bind(sensor, Scenes.of(Scenes.box(1, 0, 4)), new Random(1)).ping(poses, 0, readings);
      assertFalse(readings.isEcho(0));
    }
  }

  /** On the outline itself the distance is 0, and there is no angle. */
  @Test
  void onTheOutline_isHeard() {
    TransducerPoses poses = new TransducerPoses(1);
    poses.setPosition(0, 0.875, 0.1, 0);
    poses.setDirection(0, -1, 0, 0);
    Readings readings = new Readings(1);
    DetectionRule.LEVEL
        .bind(Sonars.exact(27.5, 0, 6), Scenes.of(Scenes.box(1, 0, 4)), new Random(1))
        .ping(poses, 0, readings);
    assertTrue(readings.isEcho(0));
    assertEquals(0, readings.rangeM(0), 1e-12);
  }

  /** Once everything has been used a reading of a belt allocates nothing, noisy or not. */
  @ParameterizedTest
  @EnumSource(names = {"LEVEL", "LEVEL_NOISY"})
  void ping_afterWarmUp_allocatesNothing(DetectionRule rule) {
    ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    Sensor belt =
        rule.bind(
            Sonars.noisy(0.01, 0.01, 0.01, 0), crowd(new Random(2), 100), new SplittableRandom(1));
    TransducerPoses poses = new TransducerPoses(TRANSDUCERS);
    Readings readings = new Readings(TRANSDUCERS);
    double bytesPerPing = Double.POSITIVE_INFINITY;
    for (int round = 0; round < 60 && bytesPerPing >= 1; round++) {
      long before = threads.getCurrentThreadAllocatedBytes();
      for (int step = 0; step < 2000; step++) {
        place(poses, Math.sin(step * 0.01), Math.cos(step * 0.01), step * 0.01);
        belt.ping(poses, 0, readings);
      }
      bytesPerPing = (threads.getCurrentThreadAllocatedBytes() - before) / 2000.0;
    }
    assertTrue(bytesPerPing < 1, bytesPerPing + " bytes per ping");
  }
}
