package simbad.experiments.bag;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import simbad.sonar.format.DataFormatException;

/** What a recording holds of ranges, poses and commanded speeds. */
public final class Recording {
  private static final String RANGE = "sensor_msgs/msg/Range";
  private static final String TF = "tf2_msgs/msg/TFMessage";
  private static final String ODOMETRY = "nav_msgs/msg/Odometry";
  private static final String TWIST = "geometry_msgs/msg/Twist";
  private static final String TWIST_STAMPED = "geometry_msgs/msg/TwistStamped";
  private static final int LEAST_TRANSFORM = 64;
  private static final String STATIC = "tf_static";

  private final Path file;
  private final Map<String, Topic> topics = new TreeMap<>();
  private final List<RangeMessage> ranges = new ArrayList<>();
  private final List<TwistMessage> twists = new ArrayList<>();
  private final Transforms transforms = new Transforms();

  /** A topic's type, and how many messages it has. */
  private static final class Topic {
    private final String type;
    private long count;

    Topic(String type) {
      this.type = type;
    }
  }

  private Recording(Path file) {
    this.file = file;
  }

  /**
   * Reads a recording.
   *
   * @param bag a folder of rosbag2, or a file in MCAP or SQLite
   * @throws DataFormatException naming the file and what is wrong with it
   */
  public static Recording read(Path bag) throws DataFormatException {
    Recording recording = new Recording(bag);
    BagFile.read(bag, recording::take);
    return recording;
  }

  private void take(BagMessage stored) throws IOException {
    BagMessage message = stored.unpacked();
    topics.computeIfAbsent(message.topic(), t -> new Topic(message.type())).count++;
    try {
      switch (message.type()) {
        case RANGE -> range(message);
        case TF -> transforms(message);
        case ODOMETRY -> odometry(message);
        case TWIST -> twist(message, new Cdr(message.data()), message.timeNs());
        case TWIST_STAMPED -> stampedTwist(message);
        default -> {
          // Not needed.
        }
      }
    } catch (IOException e) {
      throw new IOException(
          "topic " + message.topic() + ", message " + number(message) + ": " + e.getMessage(), e);
    }
  }

  private long number(BagMessage message) {
    Topic topic = topics.get(message.topic());
    return topic == null ? 0 : topic.count;
  }

  private void range(BagMessage message) throws IOException {
    Cdr cdr = new Cdr(message.data());
    long stampNs = stamp(cdr, message);
    String frame = cdr.text();
    cdr.unsignedByte();
    float field = cdr.single();
    float least = cdr.single();
    float most = cdr.single();
    ranges.add(new RangeMessage(message.topic(), frame, stampNs, field, least, most, cdr.single()));
  }

  private void stampedTwist(BagMessage message) throws IOException {
    Cdr cdr = new Cdr(message.data());
    long stampNs = stamp(cdr, message);
    cdr.text();
    twist(message, cdr, stampNs);
  }

  /** Linear x, y, z, then angular x, y, z: of a robot on the floor the first and the last count. */
  private void twist(BagMessage message, Cdr cdr, long stampNs) throws IOException {
    double[] numbers = new double[6];
    for (int i = 0; i < numbers.length; i++) {
      numbers[i] = cdr.real();
    }
    if (!Double.isFinite(numbers[0]) || !Double.isFinite(numbers[5])) {
      throw new IOException("has a speed that is not a number");
    }
    twists.add(new TwistMessage(message.topic(), stampNs, numbers[0], numbers[5]));
  }

  /** A driver that leaves the stamp empty means the time of recording. */
  private static long stamp(Cdr cdr, BagMessage message) throws IOException {
    long stampNs = cdr.stampNs();
    return stampNs == 0 ? message.timeNs() : stampNs;
  }

  private void transforms(BagMessage message) throws IOException {
    Cdr cdr = new Cdr(message.data());
    int count = cdr.count(LEAST_TRANSFORM);
    for (int i = 0; i < count; i++) {
      long stampNs = cdr.stampNs();
      String parent = frame(cdr.text());
      String child = frame(cdr.text());
      Rigid pose = cdr.rigid();
      if (message.topic().endsWith(STATIC)) {
        transforms.fix(parent, child, pose);
      } else {
        transforms.move(parent, child, stampNs == 0 ? message.timeNs() : stampNs, pose);
      }
    }
  }

  private void odometry(BagMessage message) throws IOException {
    Cdr cdr = new Cdr(message.data());
    long stampNs = stamp(cdr, message);
    String parent = frame(cdr.text());
    String child = frame(cdr.text());
    Rigid pose = cdr.rigid();
    transforms.moveByOdometry(
        parent.isEmpty() ? "odom" : parent, child.isEmpty() ? "base_link" : child, stampNs, pose);
  }

  /** Of old, frames began with a slash. */
  static String frame(String name) {
    return name.startsWith("/") ? name.substring(1) : name;
  }

  Path file() {
    return file;
  }

  List<RangeMessage> ranges() {
    return ranges;
  }

  List<TwistMessage> twists() {
    return twists;
  }

  Transforms transforms() {
    return transforms;
  }

  /** Returns what is there, a line each: topics with their types and numbers, and the frames. */
  public List<String> contents() {
    List<String> lines = new ArrayList<>();
    topics.forEach((name, topic) -> lines.add(name + ": " + topic.count + " of " + topic.type));
    transforms.lines().forEach(line -> lines.add("frame " + line));
    return lines;
  }
}
