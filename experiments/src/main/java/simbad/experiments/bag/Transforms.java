package simbad.experiments.bag;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;

/** The tree of frames of a recording: where each stood in its parent, static or moving. */
final class Transforms {
  /** So long before the first and behind the last pose of a frame it counts as standing there. */
  private static final long NEAR_NS = 100_000_000L;

  private static final int DEEPEST = 100;

  private final Map<String, String> parents = new HashMap<>();
  private final Map<String, Rigid> fixed = new HashMap<>();
  private final Map<String, TreeMap<Long, Rigid>> moving = new HashMap<>();

  /** Frames of which an odometry alone has told so far. */
  private final Set<String> byOdometry = new HashSet<>();

  /** Adds one that does not move. */
  void fix(String parent, String child, Rigid pose) {
    parents.put(child, parent);
    fixed.put(child, pose);
  }

  /** Adds where one was at a time. */
  void move(String parent, String child, long timeNs, Rigid pose) {
    move(parent, child, timeNs, pose, false);
  }

  private void move(String parent, String child, long timeNs, Rigid pose, boolean isOdometry) {
    if (!isOdometry && byOdometry.remove(child)) {
      moving.remove(child);
    }
    parents.put(child, parent);
    moving.computeIfAbsent(child, c -> new TreeMap<>()).put(timeNs, pose);
  }

  /** Adds where an odometry says that one was; what TF says of the same frame counts more. */
  void moveByOdometry(String parent, String child, long timeNs, Rigid pose) {
    if (!parents.containsKey(child) || byOdometry.contains(child)) {
      byOdometry.add(child);
      move(parent, child, timeNs, pose, true);
    }
  }

  /** Tells whether a frame is in the tree. */
  boolean knows(String frame) {
    return parents.containsKey(frame) || parents.containsValue(frame);
  }

  /** Returns the frames from one up to the root, itself first. */
  List<String> upwards(String frame) {
    List<String> way = new ArrayList<>(List.of(frame));
    Set<String> seen = new HashSet<>(way);
    String at = frame;
    while (parents.containsKey(at) && way.size() < DEEPEST) {
      at = parents.get(at);
      if (!seen.add(at)) {
        break;
      }
      way.add(at);
    }
    return way;
  }

  /** Returns the frames that move and carry none that moves: what drives through the world. */
  Set<String> drivers() {
    Set<String> drivers = new TreeSet<>(moving.keySet());
    moving
        .keySet()
        .forEach(frame -> drivers.removeAll(upwards(frame).subList(1, upwards(frame).size())));
    return drivers;
  }

  /** Returns when a frame's place was told, rising; none for one that does not move. */
  Set<Long> timesNs(String frame) {
    return moving.getOrDefault(frame, new TreeMap<>()).navigableKeySet();
  }

  /** Tells whether nothing but an odometry told where a frame was. */
  boolean isByOdometry(String frame) {
    return byOdometry.contains(frame);
  }

  /** Returns every frame with its parent, sorted: child, below parent, moving or not. */
  List<String> lines() {
    List<String> lines = new ArrayList<>();
    for (String child : new TreeSet<>(parents.keySet())) {
      TreeMap<Long, Rigid> poses = moving.get(child);
      String how = poses == null ? "fixed" : poses.size() + " poses";
      lines.add(child + " in " + parents.get(child) + " (" + how + ")");
    }
    return lines;
  }

  /**
   * Finds where a frame was.
   *
   * @param frame of which
   * @param in a frame above it
   * @param timeNs when
   * @return empty where it is not below that, or not known at that time
   */
  Optional<Rigid> find(String frame, String in, long timeNs) {
    Rigid pose = Rigid.NONE;
    String at = frame;
    // A ring of frames, as a broken recording may have, comes to an end, too.
    for (int depth = 0; at != null && depth < DEEPEST; depth++) {
      if (at.equals(in)) {
        return Optional.of(pose);
      }
      Optional<Rigid> step = step(at, timeNs);
      if (step.isEmpty()) {
        return Optional.empty();
      }
      pose = step.get().times(pose);
      at = parents.get(at);
    }
    return Optional.empty();
  }

  private Optional<Rigid> step(String child, long timeNs) {
    TreeMap<Long, Rigid> poses = moving.get(child);
    if (poses == null) {
      return Optional.ofNullable(fixed.get(child));
    }
    Map.Entry<Long, Rigid> before = poses.floorEntry(timeNs);
    Map.Entry<Long, Rigid> after = poses.ceilingEntry(timeNs);
    if (before == null || after == null) {
      Map.Entry<Long, Rigid> only = before == null ? after : before;
      return only != null && Math.abs(only.getKey() - timeNs) <= NEAR_NS
          ? Optional.of(only.getValue())
          : Optional.empty();
    }
    long span = after.getKey() - before.getKey();
    double share = span == 0 ? 0 : (double) (timeNs - before.getKey()) / span;
    return Optional.of(before.getValue().towards(after.getValue(), share));
  }
}
