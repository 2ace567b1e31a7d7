package simbad.sonar.format;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simbad.sonar.fixture.Untimed;
import simbad.sonar.frame.Placement;
import simbad.sonar.frame.Pose;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SetupDetails;
import simbad.sonar.scene.VerticalExtent;
import simbad.sonar.sensing.Circumstances;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.MovedObstacle;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.ReadingRow;

/** What only the second format knows, of rows and of scenes. */
class SecondFormatTest {
  private static final String ROWS =
      "run,sensor,x_m,z_m,heading_deg,range_m,placement,temperature_c,obstacle_x_m,obstacle_z_m,"
          + "obstacle_turn_deg,gap_ms,pause_ms,burst\n"
          + "a,s,0,1,90,0.9,p1,21.5,0.1,-0.2,30,60,5,1\n"
          + "a,s,0,1,90,,,,,,,,,2\n";

  @TempDir private Path directory = Path.of("target");

  private List<ReadingRow> read(String text) throws Exception {
    return ReadingsFile.read(Faults.file(directory, text), DataFormat.SECOND);
  }

  @Test
  void rows_areRead() throws Exception {
    List<ReadingRow> rows = read(ROWS);
    Circumstances one = rows.get(0).circumstances();
    assertFalse(rows.get(0).isTimed());
    assertEquals(Optional.of("p1"), one.placement());
    assertEquals(21.5, one.temperatureC().orElseThrow());
    assertEquals(0.1, one.obstacle().xM().orElseThrow());
    assertEquals(-0.2, one.obstacle().zM().orElseThrow());
    assertEquals(Math.toRadians(30), one.obstacle().turnRad().orElseThrow());
    assertEquals(0.06, one.gapS().orElseThrow(), 1e-12);
    assertEquals(0.005, one.pauseS().orElseThrow(), 1e-12);
    assertEquals(NoEcho.NO_ECHO, rows.get(1).reading());
    assertEquals(Untimed.ROW, rows.get(1).circumstances());
  }

  @Test
  void rows_comeBack_withColumnsThatNothingReads() throws Exception {
    List<ReadingRow> rows = read(ROWS);
    String text = ReadingsWriter.text(rows, Map.of("burst", List.of("1", "2")));
    assertEquals(rows, read(text));
    assertTrue(text.startsWith("run,sensor,x_m,z_m,heading_deg,range_m,placement,"), text);
    assertTrue(text.endsWith(",2\n"), text);
  }

  /** The first format ignores what it does not know, and wants every row's time. */
  @Test
  void firstFormat_isAsBefore() throws Exception {
    String timed = ROWS.replace("sensor,x_m", "sensor,t_s,x_m").replace("a,s,", "a,s,7,");
    Path file = Faults.file(directory, timed.replace("21.5", "warm").replaceFirst("7", "6"));
    assertEquals(Circumstances.NONE, ReadingsFile.read(file).get(0).circumstances());
    Faults.check(ReadingsFile::read, Faults.file(directory, ROWS), ":1: t_s: ", "is missing");
  }

  @ParameterizedTest
  @CsvSource({
    "21.5, -300, temperature_c, is not a temperature",
    "21.5, warm, temperature_c, is not a temperature",
    "-0.2, 1e9, obstacle_z_m, is not a finite number",
    "',60,', ',-1,', gap_ms, is not a time of at least 0 ms"
  })
  void cell_spoiled_isNamed(String piece, String instead, String column, String part)
      throws Exception {
    Faults.check(
        file -> ReadingsFile.read(file, DataFormat.SECOND),
        Faults.file(directory, ROWS.replace(piece, instead)),
        ":2: " + column + ": ",
        part);
  }

  private SensingSetup scene() throws Exception {
    SensingSetup plain = SceneFile.read(Faults.file(directory, Samples.scene()));
    Obstacle post = plain.scene().obstacles().get(0);
    return new SensingSetup(
        plain.sensor(),
        new Scene(
            List.of(
                new Obstacle(
                    post.name(),
                    new Placement(1, 2, 0),
                    post.outline(),
                    post.detection(),
                    new VerticalExtent(0.1, 0.5)))),
        plain.noEchoM(),
        new SetupDetails(
            0.002,
            Math.toRadians(3),
            Map.of("left", new Placement(0.05, -0.08, Math.toRadians(90))),
            Optional.of(true),
            List.of("The board is 1.2 m wide.")));
  }

  @Test
  void scene_comesBack() throws Exception {
    SensingSetup setup = scene();
    Path file = Faults.file(directory, SceneWriter.text(setup));
    assertEquals(DataFormat.SECOND, SceneFile.format(file));
    assertEquals(setup, SceneFile.read(file));
    assertEquals(DataFormat.FIRST, SceneFile.format(Files.writeString(file, Samples.scene())));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "\"top_m\" : 0.5 | \"top_m\" : 0.1 | 34: obstacles.0.top_m | is not a height above bottom_m",
        "\"pose_sigma_m\" : 0.002 | \"pose_sigma_m\" : -1 | 18: pose_sigma_m | is not a number of",
        "\"x_m\" : 0.05 | \"x_m\" : \"front\" | 22: sensors.left.x_m | is not a finite number",
        "\"temperature_compensated\" : true | \"temperature_compensated\" : 1 |"
            + " 16: sensor.temperature_compensated | is not true or false",
        "\"The board is 1.2 m wide.\" | 7 | 27: assumptions.0 | is not a text"
      })
  void field_spoiled_isNamed(String piece, String instead, String field, String part)
      throws Exception {
    String text = SceneWriter.text(scene());
    assertTrue(text.contains(piece), text);
    Faults.check(
        SceneFile::read,
        Faults.file(directory, text.replace(piece, instead)),
        ":" + field + ": ",
        part);
  }

  @Test
  void unknownCompensation_saysNothing() throws Exception {
    String text =
        SceneWriter.text(scene()).replace("compensated\" : true", "compensated\" : \"unknown\"");
    assertEquals(
        Optional.empty(),
        SceneFile.read(Faults.file(directory, text)).details().temperatureCompensated());
  }

  /** Less than a millisecond apart is not the same time. */
  @Test
  void times_keepMicroseconds_whereTheyHaveThem() throws Exception {
    Circumstances placed =
        new Circumstances(
            true,
            Optional.of("p"),
            OptionalDouble.empty(),
            MovedObstacle.UNMOVED,
            OptionalDouble.empty(),
            OptionalDouble.empty());
    List<ReadingRow> rows =
        List.of(
            new ReadingRow("a", "s", 0.0001, Pose.of(0, 0, 0), new Echo(1), placed),
            new ReadingRow("a", "s", 0.0004, Pose.of(0, 0, 0), new Echo(1), placed));
    assertEquals(rows, read(ReadingsWriter.text(rows, Map.of())));
  }
}
