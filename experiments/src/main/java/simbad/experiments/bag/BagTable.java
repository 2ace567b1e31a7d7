package simbad.experiments.bag;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.FixedDecimals;

/**
 * A recording's ranges as a table: when, of which sensor, where it was and looked, what it read.
 * Frames are ROS's (REP-103), seen from above: x to the right, y up the page, headings
 * counter-clockwise from x.
 *
 * @param text rows in csv, with a header
 * @param settings options of a log's import that the recording answers, by their names
 * @param notes what was done with it, a line each
 */
public record BagTable(String text, Map<String, List<String>> settings, List<String> notes) {
  private static final double NS = 1e-9;
  private static final double MOST_RANGE_M = 1000;

  /** Copies the collections. */
  public BagTable {
    settings = Map.copyOf(settings);
    notes = List.copyOf(notes);
  }

  /**
   * Makes the table.
   *
   * @param recording that was read
   * @param topics whose ranges are taken; none for all
   * @param fixedFrame the frame in which places are told; by default the root of the tree
   * @throws DataFormatException naming the recording and what it lacks
   */
  public static BagTable of(Recording recording, Set<String> topics, Optional<String> fixedFrame)
      throws DataFormatException {
    return new Maker(recording, topics).table(fixedFrame);
  }

  private static final class Maker {
    private final Recording recording;
    private final List<RangeMessage> ranges;
    private final Map<RangeMessage.Meaning, Integer> meanings =
        new EnumMap<>(RangeMessage.Meaning.class);
    private int placeless;
    private double heights;
    private int rows;

    Maker(Recording recording, Set<String> topics) throws DataFormatException {
      this.recording = recording;
      Set<String> known =
          recording.ranges().stream()
              .map(RangeMessage::topic)
              .collect(Collectors.toCollection(TreeSet::new));
      if (known.isEmpty()) {
        throw fault("has no message of sensor_msgs/msg/Range");
      }
      for (String topic : topics) {
        if (!known.contains(topic)) {
          throw DataFormatException.inArgument(
              "--topic", "'" + topic + "' is not one of " + String.join(", ", known));
        }
      }
      ranges =
          recording.ranges().stream()
              .filter(range -> topics.isEmpty() || topics.contains(range.topic()))
              .sorted(Comparator.comparingLong(RangeMessage::stampNs))
              .toList();
    }

    private DataFormatException fault(String problem) {
      return DataFormatException.inFile(recording.file(), problem);
    }

    BagTable table(Optional<String> said) throws DataFormatException {
      String fixed = said.isPresent() ? requireFrame(said.get()) : root();
      StringBuilder text = new StringBuilder("sensor,t_s,ros_x_m,ros_y_m,ros_yaw_deg,range_m\n");
      long startNs = ranges.get(0).stampNs();
      Map<String, String> names = names();
      for (RangeMessage range : ranges) {
        meanings.merge(range.meaning(), 1, Integer::sum);
        if (range.meaning() != RangeMessage.Meaning.INVALID) {
          row(text, range, names, fixed, startNs);
        }
      }
      if (rows == 0) {
        throw fault(
            "has no range from a sensor with a known place: "
                + placeless
                + " without a pose in '"
                + fixed
                + "' at their time");
      }
      return new BagTable(text.toString(), settings(), notes(fixed));
    }

    private String requireFrame(String frame) throws DataFormatException {
      if (!recording.transforms().knows(frame)) {
        throw DataFormatException.inArgument(
            "--fixed-frame",
            "'" + frame + "' is not among the frames: " + recording.transforms().lines());
      }
      return frame;
    }

    /** The one root that all sensors hang below. */
    private String root() throws DataFormatException {
      Set<String> roots = new TreeSet<>();
      for (RangeMessage range : ranges) {
        String frame = Recording.frame(range.frame());
        if (!recording.transforms().knows(frame)) {
          throw fault(
              "does not say where the sensor's frame '"
                  + frame
                  + "' is: expected it in /tf_static, /tf or odometry");
        }
        List<String> way = recording.transforms().upwards(frame);
        roots.add(way.get(way.size() - 1));
      }
      if (roots.size() > 1) {
        throw fault("has sensors below " + roots + ", and nothing connects these");
      }
      return roots.iterator().next();
    }

    /** By the frame where topics have one each of their own, else by the topic. */
    private Map<String, String> names() {
      Map<String, String> names = new TreeMap<>();
      for (RangeMessage range : ranges) {
        names.put(
            key(range), Recording.frame(range.topic()) + ":" + Recording.frame(range.frame()));
      }
      for (boolean byTopic : new boolean[] {false, true}) {
        Map<String, String> shorter = new TreeMap<>();
        ranges.forEach(
            range ->
                shorter.put(key(range), Recording.frame(byTopic ? range.topic() : range.frame())));
        if (Set.copyOf(shorter.values()).size() == shorter.size()) {
          return shorter;
        }
      }
      return names;
    }

    private static String key(RangeMessage range) {
      return range.topic() + "\n" + range.frame();
    }

    private void row(
        StringBuilder text,
        RangeMessage range,
        Map<String, String> names,
        String fixed,
        long startNs) {
      Optional<Rigid> pose =
          recording.transforms().find(Recording.frame(range.frame()), fixed, range.stampNs());
      if (pose.isEmpty()) {
        placeless++;
        return;
      }
      rows++;
      heights += pose.get().zM();
      String name = names.getOrDefault(key(range), "").replaceAll("[,\"\\s]", "_");
      text.append(name).append(',');
      FixedDecimals.append(text, (range.stampNs() - startNs) * NS, 9);
      for (double place :
          new double[] {pose.get().xM(), pose.get().yM(), Math.toDegrees(pose.get().yawRad())}) {
        FixedDecimals.append(text.append(','), place, 6);
      }
      text.append(',');
      if (range.meaning() == RangeMessage.Meaning.ECHO) {
        text.append(Float.toString(range.rangeM()));
      }
      text.append('\n');
    }

    private Map<String, List<String>> settings() {
      Map<String, List<String>> settings = new TreeMap<>();
      settings.put("range", List.of("range_m"));
      settings.put("range-unit", List.of("m"));
      settings.put("time", List.of("t_s"));
      settings.put("time-unit", List.of("s"));
      settings.put("sensor", List.of("sensor"));
      settings.put("x", List.of("ros_x_m"));
      settings.put("y", List.of("ros_y_m"));
      settings.put("pose-unit", List.of("m"));
      settings.put("heading", List.of("ros_yaw_deg"));
      settings.put("angle-unit", List.of("deg"));
      RangeMessage first = ranges.get(0);
      if (first.mostM() > first.leastM() && first.mostM() <= MOST_RANGE_M && first.leastM() >= 0) {
        settings.put("max-range", List.of(first.mostM() + "m"));
        settings.put("min-range", List.of(first.leastM() + "m"));
      }
      double halfDeg = Math.toDegrees(first.fieldRad()) / 2;
      if (halfDeg > 0 && halfDeg < 90) {
        settings.put("cone", List.of(String.format(Locale.ROOT, "%.4fdeg", halfDeg)));
      }
      double heightM = heights / rows;
      if (heightM > 0 && heightM < MOST_RANGE_M) {
        settings.put("height", List.of(String.format(Locale.ROOT, "%.4fm", heightM)));
      }
      return settings;
    }

    private List<String> notes(String fixed) {
      List<String> notes = new ArrayList<>();
      notes.add(
          "places are given in the frame '" + fixed + "', seen from above: x right, y up the page");
      note(notes, RangeMessage.Meaning.NOTHING, "without an echo (+infinity, or beyond max_range)");
      note(
          notes,
          RangeMessage.Meaning.TOO_NEAR,
          "nearer than min_range (or -infinity), kept as readings without an echo");
      note(notes, RangeMessage.Meaning.INVALID, "left out: not a number (REP-117)");
      if (placeless > 0) {
        notes.add(placeless + " left out: no pose of the sensor within 0.1 s of their time");
      }
      if (ranges.stream().map(r -> List.of(r.leastM(), r.mostM(), r.fieldRad())).distinct().count()
          > 1) {
        notes.add("the messages have different limits; the scene has those of the first message");
      }
      return notes;
    }

    private void note(List<String> notes, RangeMessage.Meaning meaning, String words) {
      int count = meanings.getOrDefault(meaning, 0);
      if (count > 0) {
        notes.add(count + " ranges " + words);
      }
    }
  }
}
