package simbad.sonar.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simbad.sonar.fixture.Scenes;
import simbad.sonar.fixture.Sonars;
import simbad.sonar.frame.Placement;
import simbad.sonar.frame.Pose;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.scene.TableDetection;
import simbad.sonar.shape.ThresholdTable;

/** Closed forms; values row by row are in {@link NominalModelGoldenTest}. */
class NominalModelTest {
  private static final Pose ORIGIN = Pose.of(0, 0, 0);

  /** A box with its centre at 2 m, its face at 1.875 m. */
  private static Sight sight(SonarSpec sensor, double thresholdM) {
    return new NominalModel(sensor, Scenes.of(Scenes.box(2, 0, thresholdM))).sight(0, ORIGIN);
  }

  /** Threshold T, edge width w, miss rate m: (1 - m) / (1 + exp((2 - T) / w)). */
  @ParameterizedTest
  @CsvSource({
    "2, 0.1, 0, 0.5",
    "2, 0.1, 0.2, 0.4",
    "2.1, 0.1, 0, 0.73105857863",
    "1.9, 0.1, 0, 0.26894142137",
    "2.1, 0.1, 0.5, 0.365529289315",
    "3, 0.01, 0.1, 0.9",
    "1, 0.01, 0, 0",
    "2, 0, 0.25, 0.75",
    "1.999, 0, 0, 0",
    "2.001, 0, 0, 1",
    "0, 0.1, 0, 0",
    "0, 100, 0, 0",
    "2, 0.1, 1, 0"
  })
  void echoProbability_falls_asTheCentreGoesBeyondTheThreshold(
      double thresholdM, double edgeWidthM, double missRate, double expected) {
    Sight sight = sight(Sonars.noisy(0.01, 0.005, missRate, edgeWidthM), thresholdM);
    assertEquals(expected, sight.echoProbability(), 1e-9);
    assertEquals(1.875, sight.nearestM().orElseThrow(), 1e-12);
    assertEquals(2, sight.centreDistanceM(), 1e-12);
    assertEquals(thresholdM, sight.thresholdM(), 1e-12);
  }

  /** The box is at 1.875 m: both ends of the sensor's reach belong to it. */
  @ParameterizedTest
  @CsvSource({
    "1.875, 6, 1",
    "1.8750001, 6, 0",
    "0.03, 1.875, 1",
    "0.03, 1.8749999, 0",
    "0.03, 6, 1",
    "1.9, 2.1, 0"
  })
  void echo_needsTheNearestPointInReach(double minRangeM, double maxRangeM, double expected) {
    Sight sight = sight(Sonars.exact(27.5, minRangeM, maxRangeM), 3);
    assertEquals(expected, sight.echoProbability());
    assertEquals(1.875, sight.nearestM().orElseThrow(), "heard or not, it is there");
  }

  @Test
  void outlineBesideTheCone_isNotHeard() {
    NominalModel model = new NominalModel(Sonars.exact(27.5, 0, 6), Scenes.of(Scenes.box(2, 0, 5)));
    Sight sight = model.sight(0, Pose.of(0, 0, Math.toRadians(40)));
    assertTrue(sight.nearestM().isEmpty());
    assertEquals(0, sight.echoProbability());
    assertEquals(2, sight.centreDistanceM(), 1e-12, "where it stands does not depend on the cone");
  }

  /** A table of 1 m ahead (+z), 2 m to the right (+x), 3 m behind, 4 m to the left. */
  @ParameterizedTest
  @CsvSource({
    "0, 2, 90, 0, 1",
    "2, 0, 180, 90, 2",
    "0, -2, -90, 180, 3",
    "-2, 0, 0, 270, 4",
  })
  void threshold_isThatOfTheSensorsBearing(
      double x, double z, double headingDeg, double bearingDeg, double thresholdM) {
    Scene scene =
        Scenes.of(
            Scenes.box(Placement.IDENTITY, new TableDetection(ThresholdTable.of(1, 2, 3, 4))));
    Pose pose = Pose.of(x, z, Math.toRadians(headingDeg));
    Sight sight = new NominalModel(Sonars.exact(27.5, 0, 6), scene).sight(0, pose);
    assertEquals(bearingDeg, Math.toDegrees(sight.bearingRad()), 1e-9);
    assertEquals(thresholdM, sight.thresholdM(), 1e-12);
    assertEquals(1.875, sight.nearestM().orElseThrow(), 1e-12);
  }

  @Test
  void distribution_ordersObstaclesByTheirNearestPoint() {
    // Far before near in the scene's order; each echoes with 0.8.
    Scene scene = Scenes.of(Scenes.box(3, 0, 5), Scenes.box(2, 0, 5), Scenes.box(-2, 0, 5));
    NominalModel model = new NominalModel(Sonars.noisy(0, 0, 0.2, 0), scene);
    ReadingDistribution distribution = model.distribution(ORIGIN);
    assertEquals(3, model.size());
    assertEquals(0.8, distribution.echoUpTo(2), 1e-12);
    assertEquals(0.8 + 0.2 * 0.8, distribution.echoUpTo(3), 1e-12);
    assertEquals(0.04, distribution.noEchoProbability(), 1e-12);
  }

  @Test
  void distribution_ofAnEmptyScene_isSilence() {
    NominalModel model = new NominalModel(Sonars.exact(27.5, 0, 6), Scenes.of());
    assertEquals(0, model.size());
    assertEquals(1, model.distribution(ORIGIN).noEchoProbability());
  }
}
