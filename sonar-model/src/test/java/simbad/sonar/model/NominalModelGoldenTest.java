package simbad.sonar.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.ReadingsFile;
import simbad.sonar.format.SceneFile;
import simbad.sonar.frame.Angles;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.sensing.ReadingRow;

/** The nominal model against values of a program that shares no code with it. */
class NominalModelGoldenTest {
  private static final double METRES = 2e-4;
  private static final double DEGREES = 6e-2;
  private static final double PROBABILITY = 1e-3;

  private static Path golden(String name) {
    try {
      return Path.of(
          Objects.requireNonNull(NominalModelGoldenTest.class.getResource("/golden/" + name))
              .toURI());
    } catch (URISyntaxException e) {
      throw new IllegalStateException(e);
    }
  }

  private static List<String[]> lines(String wanted) throws IOException {
    return Files.readAllLines(golden("nominal-golden.csv")).stream()
        .skip(1)
        .map(line -> line.split(",", -1))
        .filter(fields -> fields[0].equals(wanted))
        .toList();
  }

  @ParameterizedTest
  @ValueSource(
      strings = {"p000", "p009", "p018", "p027", "step-edge", "table36-turned", "two", "uniform"})
  void sight_everyGoldenRow(String wanted) throws Exception {
    SensingSetup setup = SceneFile.read(golden(wanted + ".scene.json"));
    NominalModel model = new NominalModel(setup.sensor(), setup.scene());
    List<Integer> numbers = rowNumbers(wanted);
    List<ReadingRow> rows = ReadingsFile.readPoses(golden(wanted + ".rows.csv"));
    List<String[]> lines = lines(wanted);
    assertTrue(lines.size() >= 59, "golden lines of " + wanted + ": " + lines.size());
    for (String[] line : lines) {
      ReadingRow row = rows.get(numbers.indexOf(Integer.valueOf(line[1])));
      check(line, model.sight(indexOf(setup, line[2]), row.pose()));
    }
  }

  private static List<Integer> rowNumbers(String wanted) throws IOException {
    return Files.readAllLines(golden(wanted + ".rows.csv")).stream()
        .skip(1)
        .map(line -> Integer.valueOf(line.substring(0, line.indexOf(','))))
        .toList();
  }

  private static int indexOf(SensingSetup setup, String name) {
    return setup.scene().obstacles().stream().map(Obstacle::name).toList().indexOf(name);
  }

  private static void check(String[] line, Sight sight) {
    String where = line[0] + " row " + line[1] + " " + line[2];
    assertEquals(Double.parseDouble(line[3]), sight.centreDistanceM(), METRES, where);
    double bearingDeg = Math.toDegrees(sight.bearingRad());
    double off = Angles.signed(Math.toRadians(bearingDeg - Double.parseDouble(line[4])));
    assertEquals(0, Math.toDegrees(off), DEGREES, where + " bearing " + bearingDeg);
    assertEquals(Double.parseDouble(line[5]), sight.thresholdM(), METRES, where);
    assertEquals(line[6].equals("1"), sight.nearestM().isPresent(), where + " in cone");
    if (!line[7].isEmpty()) {
      assertEquals(
          Double.parseDouble(line[7]), sight.nearestM().orElseThrow(), METRES, where + " nearest");
    }
    assertEquals(
        Double.parseDouble(line[8]), sight.echoProbability(), PROBABILITY, where + " probability");
  }

  @Test
  void distribution_ofTwoObstacles_nearestIsReadFirst() throws DataFormatException {
    SensingSetup setup = SceneFile.read(golden("two.scene.json"));
    NominalModel model = new NominalModel(setup.sensor(), setup.scene());
    int both = 0;
    for (ReadingRow row : ReadingsFile.readPoses(golden("two.rows.csv"))) {
      Sight a = model.sight(0, row.pose());
      Sight b = model.sight(1, row.pose());
      double silent = (1 - a.echoProbability()) * (1 - b.echoProbability());
      assertEquals(silent, model.distribution(row.pose()).noEchoProbability(), 1e-12);
      both += a.echoProbability() > 0.01 && b.echoProbability() > 0.01 ? 1 : 0;
    }
    assertTrue(both > 0, "some row hears both obstacles");
  }
}
