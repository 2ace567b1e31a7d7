package simbad.bench.capture;

import java.io.IOException;
import java.time.Clock;
import java.util.List;
import java.util.Optional;
import simbad.bench.protocol.FrameLine;
import simbad.bench.protocol.PingStatus;
import simbad.sonar.frame.Pose;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.Reading;
import simbad.sonar.sensing.ReadingRow;

/**
 * Takes one reading at each of some poses, such as those of a diagnosis's next experiment, and
 * keeps each before the next.
 */
public final class PoseMeasurement {
  private static final double ROUNDING_M = 1e-4;
  private static final double ROUNDING_RAD = Math.toRadians(1e-3);
  private static final double MS_PER_S = 1000;

  private final List<ReadingRow> poses;
  private final PingSource source;
  private final Placing placing;
  private final Ranging ranging;

  /** Brings the sensor to a pose. */
  @FunctionalInterface
  public interface Placing {
    /**
     * Returns when it is there.
     *
     * @param row index of the first row at this pose
     * @throws IOException if it will not be there
     */
    void bring(int row, Pose pose) throws IOException;
  }

  /**
   * Prepares a measurement.
   *
   * @param poses rows whose readings are of no interest
   * @param source of readings
   * @param placing is asked wherever the pose is another than the row's before
   * @param ranging makes distances of times
   */
  public PoseMeasurement(
      List<ReadingRow> poses, PingSource source, Placing placing, Ranging ranging) {
    this.poses = List.copyOf(poses);
    this.source = source;
    this.placing = placing;
    this.ranging = ranging;
  }

  /**
   * Finds the first row of a log that is not a reading of these poses in their order.
   *
   * @return its index; empty if the log may go on with what is not in it yet
   */
  public static Optional<Integer> findForeign(List<ReadingRow> poses, List<ReadingRow> log) {
    for (int i = 0; i < log.size(); i++) {
      if (i >= poses.size() || !isAlike(poses.get(i).pose(), log.get(i).pose())) {
        return Optional.of(i);
      }
    }
    return Optional.empty();
  }

  private static boolean isAlike(Pose one, Pose other) {
    double turn = one.heading().radians() - other.heading().radians();
    return one.position().distanceM(other.position()) <= ROUNDING_M
        && Math.abs(Math.IEEEremainder(turn, 2 * Math.PI)) <= ROUNDING_RAD;
  }

  /**
   * Measures what a log does not have yet.
   *
   * <p>What answers from nearer than the sensor measures is kept as a no-echo: its time says
   * nothing. Where time is real, rows that come after a break are a run of their own, named after
   * the row it begins with.
   *
   * @param log of these poses, as far as it goes
   * @param clock gives the rows' times, seconds since the first of this call; empty for those of
   *     the poses
   * @throws IOException if there are no more readings, the sensor is not placed, or the disk fails
   * @throws InterruptedException if the thread is interrupted meanwhile
   */
  public void run(ReadingsLog log, Optional<Clock> clock) throws IOException, InterruptedException {
    int first = log.before().size();
    String again = first > 0 && clock.isPresent() ? " from row " + (first + 1) : "";
    long startMs = 0;
    for (int i = first; i < poses.size(); i++) {
      ReadingRow row = poses.get(i);
      if (i == first || !row.pose().equals(poses.get(i - 1).pose())) {
        placing.bring(i, row.pose());
      }
      FrameLine.Ping ping = source.ping();
      long nowMs = clock.map(Clock::millis).orElse(0L);
      startMs = i == first ? nowMs : startMs;
      double timeS = clock.isPresent() ? (nowMs - startMs) / MS_PER_S : row.timeS();
      log.add(new ReadingRow(row.run() + again, row.sensor(), timeS, row.pose(), reading(ping)));
    }
  }

  private Reading reading(FrameLine.Ping ping) {
    return ping.status() == PingStatus.ECHO && ping.echoUs().isPresent()
        ? new Echo(ranging.rangeM(ping.echoUs().getAsInt()))
        : NoEcho.NO_ECHO;
  }
}
