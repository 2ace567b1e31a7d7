package simbad.experiments.dataset;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.random.RandomGenerator;
import simbad.obstacles.ObstacleType;
import simbad.sonar.frame.Angles;
import simbad.sonar.frame.Placement;
import simbad.sonar.frame.Pose;
import simbad.sonar.model.NominalModel;
import simbad.sonar.scene.Detection;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.scene.TableDetection;
import simbad.sonar.scene.UniformDetection;
import simbad.sonar.sensing.ReadingRow;

/**
 * Readings round an obstacle as its threshold table decides them, before a scene that knows one
 * range for all bearings: that of Simbad's original sensor, 2.5 m.
 *
 * <p>The sensor looks at the obstacle's centre from every fifth degree and 42 distances, and reads
 * what the nominal model draws with the table. The places are visited in an order drawn by chance,
 * 5 s apart, so that nothing else changes along with the place.
 */
public final class TableGrid {
  /** What the original sensor hears. */
  public static final double ORIGINAL_M = 2.5;

  private static final int BEARINGS = 72;
  private static final int DISTANCES = 42;
  private static final double NEAREST_M = 0.06;
  private static final double BEYOND_M = 0.3;
  private static final double PERIOD_S = 5;

  private TableGrid() {}

  /**
   * Makes the data set.
   *
   * @param type the obstacle with its table
   * @param sonar the sensor's figures
   * @param random source of chance
   */
  public static MadeDataSet of(ObstacleType type, SonarSpec sonar, RandomGenerator random) {
    Detection table = new TableDetection(type.thresholds().table());
    NominalModel real = new NominalModel(sonar, scene(type, table));
    List<Pose> poses = poses(type.thresholds().table().greatestM() + BEYOND_M);
    shuffle(poses, random);
    List<ReadingRow> rows = new ArrayList<>();
    for (Pose pose : poses) {
      rows.add(
          new ReadingRow(
              "grid",
              sonar.name(),
              rows.size() * PERIOD_S,
              pose,
              real.distribution(pose).sample(random)));
    }
    Scene believed = scene(type, new UniformDetection(ORIGINAL_M));
    return new MadeDataSet(new SensingSetup(sonar, believed, sonar.maxRangeM()), rows);
  }

  private static List<Pose> poses(double furthestM) {
    double step = (furthestM - NEAREST_M) / (DISTANCES - 1);
    List<Pose> poses = new ArrayList<>();
    for (int bearing = 0; bearing < BEARINGS; bearing++) {
      for (int place = 0; place < DISTANCES; place++) {
        poses.add(facing(bearing * Angles.TURN_RAD / BEARINGS, NEAREST_M + place * step));
      }
    }
    return poses;
  }

  /** Fisher and Yates, with a generator of any kind. */
  private static void shuffle(List<Pose> poses, RandomGenerator random) {
    for (int i = poses.size() - 1; i > 0; i--) {
      Collections.swap(poses, i, random.nextInt(i + 1));
    }
  }

  private static Scene scene(ObstacleType type, Detection detection) {
    return new Scene(
        List.of(new Obstacle(type.name(), Placement.IDENTITY, type.outline(), detection)));
  }

  /** Bearing 0 lies along +z, from where the sensor looks along -z, which is a quarter turn. */
  private static Pose facing(double bearingRad, double distanceM) {
    return Pose.of(
        distanceM * Math.sin(bearingRad),
        distanceM * Math.cos(bearingRad),
        bearingRad + Math.PI / 2);
  }
}
