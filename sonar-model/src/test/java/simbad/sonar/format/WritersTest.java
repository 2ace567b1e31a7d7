package simbad.sonar.format;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simbad.sonar.frame.Pose;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.ReadingRow;

/** What is written is read again. */
class WritersTest {
  @TempDir private Path directory = Path.of("target");

  private static final List<ReadingRow> ROWS =
      List.of(
          new ReadingRow("a, \"b\"", "s", 0.0625, Pose.of(1.25, -0.5, Math.PI / 2), new Echo(0.33)),
          new ReadingRow("#1", "s", 1, Pose.of(0, 0, 0), NoEcho.NO_ECHO));

  @Test
  void scene_comesBack() throws Exception {
    SensingSetup setup = SceneFile.read(Faults.file(directory, Samples.scene()));
    SensingSetup again = SceneFile.read(Faults.file(directory, SceneWriter.text(setup)));
    assertEquals(setup.sensor(), again.sensor());
    assertEquals(setup.noEchoM(), again.noEchoM());
    assertEquals(setup.scene().obstacles().size(), again.scene().obstacles().size());
    for (int i = 0; i < setup.scene().obstacles().size(); i++) {
      Obstacle one = setup.scene().obstacles().get(i);
      Obstacle other = again.scene().obstacles().get(i);
      assertEquals(one, other);
    }
  }

  @Test
  void rows_comeBack_roundedToMilliseconds() throws Exception {
    List<ReadingRow> rows =
        ReadingsFile.read(Files.writeString(directory.resolve("r.csv"), ReadingsWriter.text(ROWS)));
    assertEquals(ROWS.get(0).run(), rows.get(0).run());
    assertEquals(0.062, rows.get(0).timeS());
    assertEquals(ROWS.get(0).pose(), rows.get(0).pose());
    assertEquals(new Echo(0.33), rows.get(0).reading());
    assertEquals(ROWS.get(1), rows.get(1));
  }

  @Test
  void poses_haveNoColumnForTheRange() throws Exception {
    String text = ReadingsWriter.posesText(ROWS);
    assertEquals("run,sensor,t_s,x_m,z_m,heading_deg", text.lines().findFirst().orElseThrow());
    Path file = Files.writeString(directory.resolve("poses.csv"), text);
    assertEquals(NoEcho.NO_ECHO, ReadingsFile.readPoses(file).get(0).reading());
  }
}
