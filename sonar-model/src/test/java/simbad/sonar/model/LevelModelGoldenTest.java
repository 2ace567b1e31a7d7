package simbad.sonar.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.sonar.format.ReadingsFile;
import simbad.sonar.format.SceneFile;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.sensing.ReadingRow;

/** The level model against values of the law that another program computed (level/compute.py). */
class LevelModelGoldenTest {
  private static final double EXACT = 1e-8;

  /** Down to so many decibels below the axis a beam is a beam; below is the depth of a null. */
  private static final double NULL_DB = -45;

  private static Path golden(String name) {
    try {
      return Path.of(
          Objects.requireNonNull(LevelModelGoldenTest.class.getResource("/level/" + name)).toURI());
    } catch (URISyntaxException e) {
      throw new IllegalStateException(e);
    }
  }

  private static List<String[]> lines(String file, String wanted) throws IOException {
    return Files.readAllLines(golden(file)).stream()
        .skip(1)
        .map(line -> line.split(",", -1))
        .filter(fields -> fields[0].equals(wanted))
        .toList();
  }

  @ParameterizedTest
  @ValueSource(strings = {"table-piston", "uniform-curve", "strength", "several"})
  void sight_everyGoldenRow(String wanted) throws Exception {
    SensingSetup setup = SceneFile.read(golden(wanted + ".scene.json"));
    LevelModel model = new LevelModel(setup.sensor(), setup.scene());
    List<ReadingRow> rows = ReadingsFile.readPoses(golden(wanted + ".rows.csv"));
    List<String> names = setup.scene().obstacles().stream().map(Obstacle::name).toList();
    List<String[]> lines = lines("sights.csv", wanted);
    assertEquals(rows.size() * names.size(), lines.size());
    int between = 0;
    for (String[] line : lines) {
      ReadingRow row = rows.get(Integer.parseInt(line[1]) - 1);
      LevelSight sight = model.sight(names.indexOf(line[2]), row.pose());
      check(line, sight);
      between += sight.echoProbability() > 0.001 && sight.echoProbability() < 0.97 ? 1 : 0;
    }
    assertTrue(between >= 4, between + " rows at an edge");
  }

  private static void check(String[] line, LevelSight sight) {
    String where = line[0] + " row " + line[1] + " " + line[2];
    assertEquals(number(line[3]), sight.centreDistanceM(), EXACT, where);
    double turn = Math.abs(number(line[4]) - Math.toDegrees(sight.bearingRad())) % 360;
    assertEquals(0, Math.min(turn, 360 - turn), 1e-6, where + " bearing");
    assertEquals(number(line[5]), sight.nearestM(), EXACT, where + " nearest");
    assertEquals(number(line[6]), Math.toDegrees(sight.offAxisRad()), 1e-6, where + " off axis");
    double excess = number(line[7]);
    if (excess > NULL_DB) {
      assertEquals(excess, sight.excessDb(), 1e-3, where + " excess");
    } else {
      assertTrue(sight.excessDb() < NULL_DB, where + " excess " + sight.excessDb());
    }
    assertEquals(number(line[8]), sight.echoProbability(), 2e-4, where + " chance");
  }

  private static double number(String text) {
    return Double.parseDouble(text.replace("inf", "Infinity"));
  }

  @ParameterizedTest
  @ValueSource(strings = {"table-piston", "uniform-curve", "strength", "several"})
  void distribution_everyGoldenRow(String wanted) throws Exception {
    SensingSetup setup = SceneFile.read(golden(wanted + ".scene.json"));
    LevelModel model = new LevelModel(setup.sensor(), setup.scene());
    List<ReadingRow> rows = ReadingsFile.readPoses(golden(wanted + ".rows.csv"));
    List<String[]> lines = lines("readings.csv", wanted);
    assertTrue(lines.size() >= rows.size());
    for (String[] line : lines) {
      String where = wanted + " row " + line[1] + " up to " + line[3];
      ReadingDistribution reading =
          model.distribution(rows.get(Integer.parseInt(line[1]) - 1).pose());
      assertEquals(number(line[2]), reading.noEchoProbability(), 2e-4, where);
      assertEquals(number(line[4]), reading.echoUpTo(number(line[3])), 4e-4, where);
    }
  }
}
