package simbad.blindworld.world;

import java.util.Arrays;
import java.util.List;
import java.util.random.RandomGenerator;
import simbad.blindworld.check.Checks;

/** One ping as it is being heard: what changes may look at. Valid only during the call. */
public final class Ping {

  private final Recording recording;
  private final RandomGenerator random;
  private final boolean[] heard;
  private final boolean[] heardBefore;
  private int row;
  private int indexInTrack;
  private Pose pose = new Pose(0, 0, 0);
  private Motion motion = Motion.NONE;
  private double lastReadingM = Double.POSITIVE_INFINITY;
  private double secondM = Double.POSITIVE_INFINITY;

  /**
   * How the transducer moves, as believed.
   *
   * @param speedMPerS its speed
   * @param turnRadPerS its rate of turn, counter-clockwise
   */
  public record Motion(double speedMPerS, double turnRadPerS) {
    /** Refuses what is no such thing. */
    public Motion {
      Checks.finite("speed", speedMPerS);
      Checks.finite("turn rate", turnRadPerS);
    }

    static final Motion NONE = new Motion(0, 0);
  }

  Ping(Recording recording, RandomGenerator random, int bodies) {
    this.recording = recording;
    this.random = random;
    heard = new boolean[bodies];
    heardBefore = new boolean[bodies];
  }

  void begin(int newRow, int newIndexInTrack, Pose truePose, Motion newMotion) {
    row = newRow;
    indexInTrack = newIndexInTrack;
    pose = truePose;
    motion = newMotion;
    System.arraycopy(heard, 0, heardBefore, 0, heard.length);
    if (newIndexInTrack == 0) {
      Arrays.fill(heardBefore, false);
      lastReadingM = Double.POSITIVE_INFINITY;
    }
  }

  /** Notes which obstacles were heard; the second nearest arrival follows from it. */
  double nearest(List<Sight> sights, boolean[] nowHeard) {
    double first = Double.POSITIVE_INFINITY;
    secondM = Double.POSITIVE_INFINITY;
    for (int b = 0; b < nowHeard.length; b++) {
      heard[b] = nowHeard[b];
      if (nowHeard[b]) {
        double distance = sights.get(b).distanceM();
        secondM = Math.min(secondM, Math.max(first, distance));
        first = Math.min(first, distance);
      }
    }
    return first;
  }

  void end(double readingM) {
    lastReadingM = readingM;
  }

  /** Chance for changes, apart from the chance of the set-up. */
  public RandomGenerator random() {
    return random;
  }

  /** The row in the recording. */
  public int row() {
    return row;
  }

  /** How many pings of this run and transducer came before. */
  public int indexInTrack() {
    return indexInTrack;
  }

  /** The time within the run, in seconds. */
  public double tS() {
    return recording.tS(row);
  }

  /** The true pose. */
  public Pose pose() {
    return pose;
  }

  /** How the transducer moves. */
  public Motion motion() {
    return motion;
  }

  /** What the ping before of this track reported; infinite for a no-echo and for the first ping. */
  public double lastReadingM() {
    return lastReadingM;
  }

  /** True when the obstacle was heard on the ping before. */
  public boolean heardBefore(int body) {
    return heardBefore[body];
  }

  /** The distance of the second nearest obstacle that was heard; infinite when there is none. */
  public double secondM() {
    return secondM;
  }
}
