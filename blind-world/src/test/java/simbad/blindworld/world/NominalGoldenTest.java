package simbad.blindworld.world;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import simbad.blindworld.file.Csv;

/** Without changes the world is the nominal model of the format, which says its own numbers. */
class NominalGoldenTest {

  /** Sampled points stand at most half a millimetre apart where the nearest one is. */
  private static final double SAMPLING_M = 0.0005;

  @TestFactory
  List<DynamicTest> goldenNumbers() {
    return List.of("two", "uniform", "table36-turned", "step-edge").stream()
        .map(name -> DynamicTest.dynamicTest(name, () -> check(name)))
        .toList();
  }

  private static void check(String name) throws Exception {
    Scene scene = Golden.scene(name);
    World.Listening listening =
        new World(scene, Setup.nominal(scene.sensor()), List.of()).at(Golden.rows(name));
    Csv golden = Csv.read(Golden.FOLDER.resolve("nominal-golden.csv"));
    int[] lines =
        IntStream.range(0, golden.size()).filter(i -> golden.text(i, 0).equals(name)).toArray();
    assertEquals(true, lines.length >= 60);
    int coneDiffers = 0;
    for (int line : lines) {
      int row = (int) golden.number(line, 1) - 1;
      Sight sight = sight(scene, listening, row, golden.text(line, 2));
      String where = name + " row " + (row + 1);
      assertEquals(golden.number(line, 3), sight.centreM(), 1e-4, where);
      assertEquals(golden.number(line, 5), sight.thresholdM(), 2e-4, where);
      boolean inCone = golden.number(line, 6) == 1;
      if (inCone != sight.inCone()) {
        coneDiffers++;
      } else if (inCone) {
        assertEquals(golden.number(line, 7), sight.distanceM(), SAMPLING_M, where);
        assertEquals(golden.number(line, 8), listening.chance(row, sight), 2e-3, where);
      }
    }
    // A rim of the cone may pass between two sampled points.
    assertEquals(0, coneDiffers, 1);
  }

  private static Sight sight(Scene scene, World.Listening listening, int row, String obstacle) {
    int index =
        IntStream.range(0, scene.obstacles().size())
            .filter(i -> scene.obstacles().get(i).name().equals(obstacle))
            .findFirst()
            .orElseThrow();
    return listening.sights().get(row).get(index);
  }

  @Test
  void chanceAtAStepEdge_isOneBeforeAndNoneBehind() {
    Sensor step = new Sensor("s", 0.3, 0.02, 4, 0.1, 343, 0.01, 0.004, 0, 0, 0.1);
    Obstacle post =
        new Obstacle(
            "post",
            new Point(0, 0),
            0,
            List.of(new Point(-0.01, -0.01), new Point(0.01, -0.01), new Point(0, 0.01)),
            Shadow.uniform(1));
    Scene scene = new Scene(4, step, List.of(post));
    Recording rows =
        new Recording(
            List.of(
                new Row("r", "s", 0, new Pose(-0.99, 0, 0)),
                new Row("r", "s", 1, new Pose(-1, 0, 0)),
                new Row("r", "s", 2, new Pose(-1.01, 0, 0))));
    World.Listening listening = new World(scene, Setup.nominal(step), List.of()).at(rows);
    double[] chances =
        IntStream.range(0, 3)
            .mapToDouble(i -> listening.chance(i, listening.sights().get(i).get(0)))
            .toArray();
    assertEquals(1, chances[0], 1e-12);
    assertEquals(0.5, chances[1], 1e-12);
    assertEquals(0, chances[2], 1e-12);
  }
}
