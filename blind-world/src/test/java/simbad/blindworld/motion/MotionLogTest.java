package simbad.blindworld.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simbad.blindworld.file.FormatException;
import simbad.blindworld.motion.Commands.Speeds;
import simbad.blindworld.world.Pose;

/** A robot and its log as files hold them. */
class MotionLogTest {

  private static final double NEAR = 1e-12;
  private static final String TRACK =
      """
      run,t_s,x_m,z_m,heading_deg
      a,0.1,1,2,90
      b,0,5,6,-45
      a,0.6,1.5,2.5,-180
      """;

  private static Path file(Path folder, String name, String text) throws IOException {
    return Files.writeString(folder.resolve(name), text);
  }

  private static Robot robot(Path folder, String json) throws IOException, FormatException {
    return MotionLog.robot(file(folder, "robot.json", json));
  }

  @Test
  void differential_hasWheels(@TempDir Path folder) throws IOException, FormatException {
    Robot robot =
        robot(
            folder,
            """
            {"kinematics": "differential", "wheel_radius_m": 0.03, "wheel_base_m": 0.15,
             "latency_s": 0.1, "speed_time_constant_s": 0.2, "max_speed_m_s": 0.5,
             "max_turn_rad_s": 2, "track_sigma_m": 0.004, "track_sigma_deg": 180,
             "clocks": "separate"}
            """);
    assertTrue(robot.differential());
    assertTrue(robot.separateClocks());
    assertEquals(0.03, robot.wheelRadiusM());
    assertEquals(0.15, robot.wheelBaseM());
    assertEquals(new Robot.Beliefs(0.1, 0.2, 0.5, 2), robot.beliefs());
    assertEquals(new Robot.Scatter(0.004, Math.PI), robot.tracker());
    Robot other = robot.withTracker(new Robot.Scatter(1, 2));
    assertEquals(new Robot.Scatter(1, 2), other.tracker());
    assertEquals(robot, other.withTracker(robot.tracker()));
  }

  @Test
  void unicycle_needsNothingElse(@TempDir Path folder) throws IOException, FormatException {
    Robot robot = robot(folder, "{\"kinematics\": \"unicycle\"}");
    assertFalse(robot.differential());
    assertFalse(robot.separateClocks());
    assertEquals(0, robot.wheelRadiusM());
    assertEquals(1, robot.wheelBaseM());
    assertEquals(Robot.Beliefs.NONE, robot.beliefs());
    assertEquals(Robot.Scatter.NONE, robot.tracker());
    assertFalse(
        robot(folder, "{\"kinematics\": \"unicycle\", \"clocks\": \"one\"}").separateClocks());
  }

  @Test
  void impossibleRobot_isRefusedWithItsFile(@TempDir Path folder) {
    FormatException fault =
        assertThrows(
            FormatException.class,
            () -> robot(folder, "{\"kinematics\": \"unicycle\", \"latency_s\": -1}"));
    String said = String.valueOf(fault.getMessage());
    assertTrue(said.contains("robot.json") && said.contains("latency"), said);
    assertThrows(
        FormatException.class,
        () ->
            robot(
                folder,
                """
                {"kinematics": "differential", "wheel_radius_m": 1, "wheel_base_m": 0}
                """));
  }

  @Test
  void track_hasRunsInTheOrderOfTheFile(@TempDir Path folder) throws IOException, FormatException {
    MotionLog log = MotionLog.track(file(folder, "track.csv", TRACK));
    assertEquals(2, log.outing().runs().size());
    Outing.Run a = log.outing().runs().get(0);
    assertEquals("a", a.name());
    assertEquals(2, a.frames());
    assertEquals(0.6, a.frameS(1));
    assertEquals(0.6, a.endS());
    assertEquals(0, a.commands().size());
    assertEquals(new Pose(1, 2, Math.PI / 2), a.start());
    assertEquals(1.5, log.track().xM(0, 1));
    assertEquals(2.5, log.track().zM(0, 1));
    // -180 degrees after 90 are 180.
    assertEquals(Math.PI, log.track().headingRad(0, 1), NEAR);
    assertEquals(-Math.PI / 4, log.track().headingRad(1, 0), NEAR);
  }

  @Test
  void commands_areRimsOrSpeeds(@TempDir Path folder) throws IOException, FormatException {
    Path track = file(folder, "track.csv", TRACK);
    Robot wheels = new Robot(0.03, 0.2, true, Robot.Beliefs.NONE, Robot.Scatter.NONE, false);
    Path rims =
        file(
            folder,
            "rims.csv",
            "run,t_s,left_m_s,right_m_s\na,0,0.2,0.4\nb,3,1,1\na,0.5,-0.1,0.1\n");
    MotionLog log = MotionLog.read(rims, track, wheels);
    Commands a = log.outing().runs().get(0).commands();
    assertEquals(2, a.size());
    assertEquals(0.5, a.timeS(1));
    assertEquals(0.3, a.at(0).vMPerS(), NEAR);
    assertEquals(1, a.at(0).wRadPerS(), NEAR);
    assertEquals(0, a.at(1).vMPerS(), NEAR);
    assertEquals(new Speeds(1, 0), log.outing().runs().get(1).commands().at(0));
    Robot unicycle = new Robot(0, 1, false, Robot.Beliefs.NONE, Robot.Scatter.NONE, false);
    Path speeds = file(folder, "speeds.csv", "run,t_s,v_m_s,w_rad_s\nb,1,0.2,0.4\n");
    MotionLog other = MotionLog.read(speeds, track, unicycle);
    assertEquals(0, other.outing().runs().get(0).commands().size());
    Commands b = other.outing().runs().get(1).commands();
    assertEquals(new Speeds(0.2, 0.4), b.at(0));
    assertEquals(1, b.timeS(0));
  }

  @Test
  void commandsThatFall_areRefusedWithTheirFile(@TempDir Path folder) throws IOException {
    Path track = file(folder, "track.csv", TRACK);
    Path back = file(folder, "back.csv", "run,t_s,v_m_s,w_rad_s\na,1,0,0\na,0.5,0,0\n");
    Robot unicycle = new Robot(0, 1, false, Robot.Beliefs.NONE, Robot.Scatter.NONE, false);
    FormatException fault =
        assertThrows(FormatException.class, () -> MotionLog.read(back, track, unicycle));
    assertTrue(String.valueOf(fault.getMessage()).contains("back.csv"), fault.toString());
  }
}
