package simbad.experiments.bag;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simbad.motion.Command;
import simbad.motion.MotionRun;
import simbad.motion.TrackPose;
import simbad.sonar.format.DataFormatException;

/** A drive whose every number is known: 0.5 m/s ahead, then a turn. */
class BagMotionTest {
  private static final long START_NS = 1_700_000_000_000_000_000L;
  private static final long STEP_NS = 100_000_000L;

  @TempDir private Path folder = Path.of("");
  private Path bag = Path.of("");

  @BeforeEach
  void record() throws IOException {
    bag = folder.resolve("drive.mcap");
    try (OutputStream out = Files.newOutputStream(bag);
        McapWriter writer = new McapWriter(out)) {
      int twist = writer.channel("/cmd_vel", writer.schema("geometry_msgs/msg/Twist", ""));
      int stamped =
          writer.channel("/cmd_stamped", writer.schema("geometry_msgs/msg/TwistStamped", ""));
      int tf = writer.channel("/tf", writer.schema("tf2_msgs/msg/TFMessage", ""));
      for (int i = 0; i < 10; i++) {
        long ns = START_NS + i * STEP_NS;
        writer.message(twist, i, ns, speeds(new CdrWriter(), 0.5, i < 5 ? 0 : -1).bytes());
        writer.message(
            stamped,
            i,
            ns,
            speeds(new CdrWriter().stamp(ns + 7).text("base_link"), 0.1, 0).bytes());
        writer.message(tf, i, ns, transform(ns, 0.05 * i));
      }
    }
  }

  private static CdrWriter speeds(CdrWriter to, double ahead, double turn) {
    return to.real(ahead).real(0).real(0).real(0).real(0).real(turn);
  }

  private static byte[] transform(long ns, double xM) {
    CdrWriter cdr = new CdrWriter().integer(1).stamp(ns).text("odom").text("base_link");
    return cdr.real(xM).real(0.2).real(0).real(0).real(0).real(0).real(1).bytes();
  }

  private BagMotion motion(String topic, String robot, String fixed) throws DataFormatException {
    return BagMotion.of(
        Recording.read(bag), new BagMotion.Choice(named(topic), named(robot), named(fixed)), "run");
  }

  private static Optional<String> named(String name) {
    return Optional.of(name).filter(n -> !n.isEmpty());
  }

  @Test
  void commandsAndPlaces_areTaken() throws Exception {
    MotionRun run = motion("/cmd_vel", "", "").data().runs().get(0);
    assertEquals(10, run.commands().size());
    assertEquals(new Command(0, 0.5, 0), run.commands().get(0));
    Command turning = run.commands().get(7);
    assertEquals(0.7, turning.timeS(), 1e-9);
    assertEquals(-1, turning.turnRadPerS());
    TrackPose pose = run.track().get(4);
    assertEquals(0.4, pose.timeS(), 1e-9);
    assertEquals(0.2, pose.xM(), 1e-12);
    assertEquals(0.2, pose.yM(), 1e-12);
    assertEquals(0, pose.headingRad(), 1e-12);
  }

  @Test
  void stampedCommands_haveTheirOwnTimes() throws Exception {
    BagMotion motion = motion("/cmd_stamped", "base_link", "odom");
    assertEquals(0.1, motion.data().runs().get(0).commands().get(0).speedMPerS());
    // The first place is 7 ns before the first command.
    assertEquals(9, motion.data().runs().get(0).track().size());
    assertTrue(motion.notes().get(1).startsWith("9 places of 'base_link' in 'odom'"));
  }

  @Test
  void whatIsNotThere_isNamed() {
    check("--topic: is not given, expected one", "", "", "");
    check("'/x' is not one of /cmd_stamped, /cmd_vel", "/x", "", "");
    check("'x' is not one of base_link", "/cmd_vel", "x", "");
    check("'map' is not above 'base_link'", "/cmd_vel", "", "map");
  }

  private void check(String said, String topic, String robot, String fixed) {
    DataFormatException thrown =
        assertThrows(DataFormatException.class, () -> motion(topic, robot, fixed));
    assertTrue(String.valueOf(thrown.getMessage()).contains(said), thrown.getMessage());
  }
}
