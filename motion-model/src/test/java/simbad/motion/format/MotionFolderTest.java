package simbad.motion.format;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simbad.motion.Command;
import simbad.motion.MotionRun;
import simbad.motion.Robot;
import simbad.motion.TrackPose;
import simbad.sonar.format.DataFormatException;

class MotionFolderTest {
  @TempDir Path folder = Path.of("");

  @BeforeEach
  void write() throws IOException {
    MotionRun run =
        new MotionRun(
            "a",
            List.of(new Command(0, 0.1, -0.5), new Command(1, 0, 0)),
            List.of(new TrackPose(0, 1, 2, 0.5), new TrackPose(0.5, 1, -2, 0)));
    new MotionFolder(folder)
        .write(new MotionData("m", Robot.EXACT_UNICYCLE, List.of(run), List.of()));
  }

  @Test
  void writtenFolder_isReadAgain() throws DataFormatException {
    MotionData data = new MotionFolder(folder).read("m");
    MotionRun run = data.runs().get(0);
    assertEquals(new Command(0, 0.1, -0.5), run.commands().get(0));
    assertEquals(2, run.track().get(0).yM(), 1e-9);
    assertEquals(0.5, run.track().get(0).headingRad(), 1e-6);
  }

  /** A run's name is free text. */
  @Test
  void nameWithCommaAndQuotes_isReadAgain() throws IOException, DataFormatException {
    String name = "lap 1, \"morning\"";
    MotionRun run =
        new MotionRun(name, List.of(new Command(0, 0.1, 0)), List.of(new TrackPose(0.5, 1, -2, 0)));
    new MotionFolder(folder)
        .write(new MotionData("m", Robot.EXACT_UNICYCLE, List.of(run), List.of()));
    assertEquals(name, new MotionFolder(folder).read("m").runs().get(0).name());
  }

  @Test
  void wheels_becomeSpeedAndTurn() throws IOException, DataFormatException {
    String robot =
        "{\"format\": \"motion-gap/1\", \"kinematics\": \"differential\","
            + " \"wheel_radius_m\": 0.03, \"wheel_base_m\": 0.2}";
    Files.writeString(folder.resolve("robot.json"), robot);
    Files.writeString(folder.resolve("commands.csv"), "run,t_s,left_m_s,right_m_s\na,0,0.1,0.3\n");
    Command command = new MotionFolder(folder).read("m").runs().get(0).commands().get(0);
    assertEquals(0.2, command.speedMPerS(), 1e-12);
    assertEquals(1, command.turnRadPerS(), 1e-12);
  }

  @Test
  void wrongNumber_isNamedWithItsLine() throws IOException {
    checkFault("track.csv", "run,t_s,x_m,z_m,heading_deg\na,0,x,0,0\n", ":2: x_m: 'x' is not");
  }

  @Test
  void missingColumn_isNamed() throws IOException {
    checkFault("commands.csv", "run,t_s,v_m_s\na,0,1\n", ":1: w_rad_s: column is missing");
  }

  @Test
  void runWithoutCommands_isNamed() throws IOException {
    checkFault("track.csv", "run,t_s,x_m,z_m,heading_deg\nb,0,0,0,0\n", "run 'b' has no commands");
  }

  @Test
  void unknownKinematics_isNamed() throws IOException {
    String robot = "{\"format\": \"motion-gap/1\",\n \"kinematics\": \"legs\"}";
    checkFault("robot.json", robot, ":2: kinematics: \"legs\" is not");
  }

  private void checkFault(String file, String text, String expected) throws IOException {
    Files.writeString(folder.resolve(file), text);
    String message =
        String.valueOf(
            assertThrows(DataFormatException.class, () -> new MotionFolder(folder).read("m"))
                .getMessage());
    assertTrue(message.contains(file) && message.contains(expected), message);
  }
}
