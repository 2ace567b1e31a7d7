package simbad.cli;

import java.nio.file.Path;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import simbad.experiments.bag.BagMotion;
import simbad.experiments.bag.Recording;

/** {@code simbad dataset motion bag}: a recording of ROS 2 as a motion folder. */
@Command(
    name = "bag",
    description = {
      "Make a motion folder from a recording of ROS 2.",
      "The commands come from geometry_msgs/msg/Twist or TwistStamped, the places from "
          + "the robot's frame in /tf or from odometry."
    },
    footer = {
      "",
      "Example: simbad dataset motion bag my-drive --out my-robot",
      "Example: simbad dataset motion bag my-drive --topic /cmd_vel --robot-frame base_link --out"
          + " my-robot"
    })
final class DatasetMotionBagCommand extends Subcommand {
  @Parameters(paramLabel = "BAG", description = "The recording: a folder or a file.")
  private Path bag = Path.of("");

  @Option(
      names = "--out",
      paramLabel = "DIR",
      required = true,
      description = "The motion folder, which does not exist yet.")
  private Path out = Path.of("");

  @Option(
      names = "--topic",
      paramLabel = "TOPIC",
      description = "Topic of the commands. Default: the only one.")
  private @Nullable String topic;

  @Option(
      names = "--robot-frame",
      paramLabel = "FRAME",
      description =
          "The robot's frame. Default: the only moving frame that carries no other "
              + "moving frame.")
  private @Nullable String robotFrame;

  @Option(
      names = "--fixed-frame",
      paramLabel = "FRAME",
      description = "Frame of the places. Default: the root above the robot.")
  private @Nullable String fixedFrame;

  @Override
  protected void run() throws Exception {
    BagMotion.Choice choice =
        new BagMotion.Choice(
            Optional.ofNullable(topic),
            Optional.ofNullable(robotFrame),
            Optional.ofNullable(fixedFrame));
    BagMotion motion = BagMotion.of(Recording.read(bag), choice, "bag");
    DatasetMotionCommand.publish(motion.data(), out);
    motion.notes().forEach(note -> out().println("read: " + note));
    out().println("written to " + out);
  }
}
