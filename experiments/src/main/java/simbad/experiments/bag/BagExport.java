package simbad.experiments.bag;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.nio.channels.Channels;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import simbad.sonar.format.TextFile;
import simbad.sonar.format.WholeFile;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.ReadingRow;

/**
 * Readings as a recording of ROS 2: a folder of rosbag2 with one file in MCAP. Each sensor has a
 * topic and a frame of its name; where it was stands in /tf, below the frame map.
 */
public final class BagExport {
  /** A stamp of 0 would mean that there is none. */
  private static final long START_NS = 1_000_000_000L;

  private static final double NS = 1e9;
  private static final double BETWEEN_RUNS_S = 10;
  private static final String RANGE = "sensor_msgs/msg/Range";
  private static final String TF = "tf2_msgs/msg/TFMessage";

  private static final String STAMP =
      """
      ================================================================================
      MSG: std_msgs/Header
      builtin_interfaces/Time stamp
      string frame_id
      ================================================================================
      MSG: builtin_interfaces/Time
      int32 sec
      uint32 nanosec
      """;

  private static final String RANGE_DEFINITION =
      """
      uint8 ULTRASOUND=0
      uint8 INFRARED=1
      std_msgs/Header header
      uint8 radiation_type
      float32 field_of_view
      float32 min_range
      float32 max_range
      float32 range
      """
          + STAMP;

  private static final String TF_DEFINITION =
      """
      geometry_msgs/TransformStamped[] transforms
      ================================================================================
      MSG: geometry_msgs/TransformStamped
      std_msgs/Header header
      string child_frame_id
      geometry_msgs/Transform transform
      ================================================================================
      MSG: geometry_msgs/Transform
      geometry_msgs/Vector3 translation
      geometry_msgs/Quaternion rotation
      ================================================================================
      MSG: geometry_msgs/Vector3
      float64 x
      float64 y
      float64 z
      ================================================================================
      MSG: geometry_msgs/Quaternion
      float64 x
      float64 y
      float64 z
      float64 w
      """
          + STAMP;

  private final SonarSpec sensor;
  private final List<Timed> rows;
  private final Map<String, Integer> counts = new LinkedHashMap<>();

  private record Timed(long timeNs, ReadingRow row) {}

  private BagExport(SensingSetup setup, List<ReadingRow> readings) {
    sensor = setup.sensor();
    rows = timed(readings, sensor.updatePeriodS());
  }

  /**
   * Writes a recording.
   *
   * @param folder that is there and empty
   * @param name of the file, without its ending
   * @param setup whose sensor's figures stand in every message
   * @param readings in any order; runs follow each other, ten seconds apart
   * @throws IOException if a file cannot be written
   */
  public static void write(Path folder, String name, SensingSetup setup, List<ReadingRow> readings)
      throws IOException {
    BagExport export = new BagExport(setup, readings);
    String file = name + ".mcap";
    WholeFile.write(
        folder.resolve(file),
        channel -> {
          try (McapWriter writer =
              new McapWriter(new BufferedOutputStream(Channels.newOutputStream(channel)))) {
            export.messages(writer);
          }
        });
    TextFile.write(folder.resolve("metadata.yaml"), export.metadata(file));
  }

  /** Rows without times follow each other at the sensor's period. */
  private static List<Timed> timed(List<ReadingRow> readings, double periodS) {
    Map<String, List<ReadingRow>> runs = new LinkedHashMap<>();
    readings.forEach(row -> runs.computeIfAbsent(row.run(), r -> new ArrayList<>()).add(row));
    List<Timed> timed = new ArrayList<>();
    double startS = 0;
    for (List<ReadingRow> run : runs.values()) {
      double firstS = run.stream().mapToDouble(ReadingRow::timeS).min().orElse(0);
      double lastS = startS;
      for (int i = 0; i < run.size(); i++) {
        ReadingRow row = run.get(i);
        double atS = startS + (row.isTimed() ? row.timeS() - firstS : i * periodS);
        lastS = Math.max(lastS, atS);
        timed.add(new Timed(START_NS + Math.round(atS * NS), row));
      }
      startS = lastS + BETWEEN_RUNS_S;
    }
    timed.sort(Comparator.comparingLong(Timed::timeNs));
    return timed;
  }

  private void messages(McapWriter writer) throws IOException {
    int range = writer.schema(RANGE, RANGE_DEFINITION);
    int tf = writer.channel("/tf", writer.schema(TF, TF_DEFINITION));
    counts.put("/tf", 0);
    Map<String, Integer> channels = new TreeMap<>();
    for (Timed one : rows) {
      String frame = frame(one.row());
      String topic = "/" + frame;
      if (!channels.containsKey(topic)) {
        channels.put(topic, writer.channel(topic, range));
        counts.put(topic, 0);
      }
      int channel = channels.getOrDefault(topic, 0);
      writer.message(tf, count("/tf"), one.timeNs(), transform(one, frame));
      writer.message(channel, count(topic), one.timeNs(), range(one, frame));
    }
  }

  private int count(String topic) {
    return counts.merge(topic, 1, Integer::sum);
  }

  private static String frame(ReadingRow row) {
    String name = row.sensor().replaceAll("[^A-Za-z0-9_]", "_");
    return name.isEmpty() || !Character.isLetter(name.charAt(0)) ? "sonar_" + name : name;
  }

  private byte[] range(Timed one, String frame) {
    boolean isEcho = one.row().reading() instanceof Echo;
    double rangeM = isEcho ? ((Echo) one.row().reading()).rangeM() : Double.POSITIVE_INFINITY;
    return new CdrWriter()
        .stamp(one.timeNs())
        .text(frame)
        .unsignedByte(0)
        .single((float) (2 * sensor.coneHalfAngleRad()))
        .single((float) sensor.minRangeM())
        .single((float) sensor.maxRangeM())
        .single((float) rangeM)
        .bytes();
  }

  /** Seen from above z points down the page, where ROS's y points up. */
  private byte[] transform(Timed one, String frame) {
    double half = one.row().pose().heading().radians() / 2;
    return new CdrWriter()
        .integer(1)
        .stamp(one.timeNs())
        .text("map")
        .text(frame)
        .real(one.row().pose().position().xM())
        .real(-one.row().pose().position().zM())
        .real(sensor.mountHeightM())
        .real(0)
        .real(0)
        .real(Math.sin(half))
        .real(Math.cos(half))
        .bytes();
  }

  private String metadata(String file) {
    StringBuilder text = new StringBuilder(head("'" + file.replace("'", "''") + "'"));
    counts.forEach((topic, count) -> text.append(topic(topic, count)));
    return text.toString();
  }

  private String head(String file) {
    long first = rows.isEmpty() ? START_NS : rows.get(0).timeNs();
    long last = rows.isEmpty() ? START_NS : rows.get(rows.size() - 1).timeNs();
    int all = counts.values().stream().mapToInt(Integer::intValue).sum();
    return String.format(
        Locale.ROOT,
        """
      rosbag2_bagfile_information:
        version: 8
        storage_identifier: mcap
        compression_format: ''
        compression_mode: ''
        duration:
          nanoseconds: %1$d
        starting_time:
          nanoseconds_since_epoch: %2$d
        message_count: %3$d
        relative_file_paths:
        - %4$s
        files:
        - path: %4$s
          starting_time:
            nanoseconds_since_epoch: %2$d
          duration:
            nanoseconds: %1$d
          message_count: %3$d
        custom_data: null
        ros_distro: rosbags
        topics_with_message_count:
      """,
        last - first,
        first,
        all,
        file);
  }

  private static String topic(String topic, int count) {
    return String.format(
        Locale.ROOT,
        """
        - message_count: %d
          topic_metadata:
            name: %s
            type: %s
            serialization_format: cdr
            offered_qos_profiles: ''
            type_description_hash: ''
      """,
        count,
        topic,
        topic.equals("/tf") ? TF : RANGE);
  }
}
