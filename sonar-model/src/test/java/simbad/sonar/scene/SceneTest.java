package simbad.sonar.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.sonar.fixture.Refusal;
import simbad.sonar.fixture.Scenes;
import simbad.sonar.fixture.Sonars;
import simbad.sonar.frame.Placement;
import simbad.sonar.frame.Point;
import simbad.sonar.shape.ThresholdTable;

class SceneTest {
  @Test
  void scene_copiesItsObstacles() {
    List<Obstacle> obstacles = new ArrayList<>(List.of(Scenes.box(1, 2, 3)));
    Scene scene = new Scene(obstacles);
    obstacles.clear();
    assertEquals(1, scene.obstacles().size());
  }

  @Test
  void worldOutline_isTheOutlinePlaced() {
    Obstacle box = Scenes.box(new Placement(1, 2, Math.PI / 2), new UniformDetection(1));
    // The corner (-1/8, -1/8) goes to (x, z) = (z, -x) = (-1/8, 1/8), then to the box's place.
    assertEquals(0, box.worldOutline().corners().get(0).distanceM(new Point(0.875, 2.125)), 1e-12);
  }

  @Test
  void thresholds_byBearing() {
    Detection uniform = new UniformDetection(2);
    Detection table = new TableDetection(ThresholdTable.of(1, 2, 3, 4));
    assertEquals(2, uniform.thresholdM(5));
    assertEquals(2, uniform.greatestM());
    assertEquals(2, table.thresholdM(Math.PI / 2), 1e-12);
    assertEquals(4, table.greatestM());
  }

  @ParameterizedTest
  @ValueSource(doubles = {-0.1, 100.1, 1e9, Double.NaN, Double.POSITIVE_INFINITY})
  void uniformThreshold_outOfItsDomain_isRefused(double bad) {
    Refusal.check(() -> new UniformDetection(bad), "rangeM = " + bad, "[0, 100.0] m");
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, -1, Double.NaN, Double.POSITIVE_INFINITY})
  void noEchoRange_outOfItsDomain_isRefused(double bad) {
    Scene empty = Scenes.of();
    Refusal.check(
        () -> new SensingSetup(Sonars.exact(10, 0, 1), empty, bad),
        "noEchoM = " + bad,
        "(0, infinity)");
    assertTrue(empty.obstacles().isEmpty());
  }
}
