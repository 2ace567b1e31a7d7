package simbad.experiments.bag;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import simbad.motion.Command;
import simbad.motion.MotionRun;
import simbad.motion.Robot;
import simbad.motion.TrackPose;
import simbad.motion.format.MotionData;
import simbad.sonar.format.DataFormatException;

/**
 * A recording's motion: what was commanded (Twist, often on /cmd_vel), and where the robot's frame
 * then was. Frames are ROS's seen from above, which are those of a motion folder: x to the right, y
 * up the page.
 *
 * @param data of one run
 * @param notes what was understood, a line each
 */
public record BagMotion(MotionData data, List<String> notes) {
  private static final double NS = 1e-9;

  /** Assumed: a tracker of a laboratory, or odometry over a short way. */
  private static final double SIGMA_M = 0.005;

  private static final double SIGMA_RAD = Math.toRadians(0.5);

  /** Copies the notes. */
  public BagMotion {
    notes = List.copyOf(notes);
  }

  /** What is said of a recording; what is not is taken from it where it has one only. */
  public record Choice(
      Optional<String> topic, Optional<String> robotFrame, Optional<String> fixedFrame) {}

  /**
   * Takes the motion out of a recording.
   *
   * @param recording that was read
   * @param choice which topic and frames
   * @param run name of the run
   * @throws DataFormatException naming the recording and what it lacks
   */
  public static BagMotion of(Recording recording, Choice choice, String run)
      throws DataFormatException {
    List<TwistMessage> twists = twists(recording, choice.topic());
    Transforms transforms = recording.transforms();
    String robot =
        one(
            recording,
            "--robot-frame",
            "frame that moves",
            transforms.drivers(),
            choice.robotFrame());
    List<String> upwards = transforms.upwards(robot);
    String fixed = choice.fixedFrame().orElse(upwards.get(upwards.size() - 1));
    if (!upwards.contains(fixed)) {
      throw DataFormatException.inArgument(
          "--fixed-frame", "'" + fixed + "' is not above '" + robot + "': " + upwards);
    }
    long startNs = twists.get(0).stampNs();
    List<TrackPose> track = track(transforms, robot, fixed, startNs);
    if (track.isEmpty()) {
      throw DataFormatException.inFile(
          recording.file(), "has no place of '" + robot + "' in '" + fixed + "'");
    }
    Robot exact = Robot.EXACT_UNICYCLE;
    MotionData data =
        new MotionData(
            run,
            new Robot(false, 0, false, SIGMA_M, SIGMA_RAD, exact.motion()),
            List.of(new MotionRun(run, commands(twists, startNs), track)),
            List.of());
    return new BagMotion(data, notes(twists, transforms, robot, fixed, track));
  }

  private static List<TwistMessage> twists(Recording recording, Optional<String> said)
      throws DataFormatException {
    Set<String> topics =
        recording.twists().stream()
            .map(TwistMessage::topic)
            .collect(Collectors.toCollection(TreeSet::new));
    String topic = one(recording, "--topic", "topic of geometry_msgs/msg/Twist", topics, said);
    return recording.twists().stream()
        .filter(twist -> twist.topic().equals(topic))
        .sorted(Comparator.comparingLong(TwistMessage::stampNs))
        .toList();
  }

  private static String one(
      Recording recording, String option, String what, Set<String> found, Optional<String> said)
      throws DataFormatException {
    if (found.isEmpty()) {
      throw DataFormatException.inFile(recording.file(), "has no " + what);
    }
    String names = String.join(", ", found);
    if (said.isPresent() && !found.contains(said.get())) {
      throw DataFormatException.inArgument(option, "'" + said.get() + "' is not one of " + names);
    }
    if (said.isEmpty() && found.size() > 1) {
      throw DataFormatException.inArgument(
          option, "is not given, expected one " + what + " of " + names);
    }
    return said.orElseGet(() -> found.iterator().next());
  }

  /** Of several at one time the last holds. */
  private static List<Command> commands(List<TwistMessage> twists, long startNs) {
    TreeMap<Long, Command> commands = new TreeMap<>();
    for (TwistMessage twist : twists) {
      commands.put(
          twist.stampNs(),
          new Command((twist.stampNs() - startNs) * NS, twist.speedMPerS(), twist.turnRadPerS()));
    }
    return List.copyOf(commands.values());
  }

  private static List<TrackPose> track(
      Transforms transforms, String robot, String fixed, long startNs) {
    List<TrackPose> track = new ArrayList<>();
    for (long timeNs : transforms.timesNs(robot)) {
      Optional<Rigid> pose = transforms.find(robot, fixed, timeNs);
      if (timeNs >= startNs && pose.isPresent()) {
        Rigid at = pose.get();
        track.add(new TrackPose((timeNs - startNs) * NS, at.xM(), at.yM(), at.yawRad()));
      }
    }
    return track;
  }

  private static List<String> notes(
      List<TwistMessage> twists,
      Transforms transforms,
      String robot,
      String fixed,
      List<TrackPose> track) {
    List<String> notes = new ArrayList<>();
    notes.add(twists.size() + " commands of " + twists.get(0).topic());
    notes.add(
        track.size() + " places of '" + robot + "' in '" + fixed + "', x right, y up the page");
    if (transforms.isByOdometry(robot)) {
      notes.add("they come from odometry: where the robot believes it was, not where it was");
    }
    notes.add(
        String.format(
            Locale.ROOT,
            "assumed: places are known to %.3f m and %.1f deg (robot.json)",
            SIGMA_M,
            Math.toDegrees(SIGMA_RAD)));
    return notes;
  }
}
