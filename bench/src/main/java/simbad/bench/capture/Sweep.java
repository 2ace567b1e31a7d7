package simbad.bench.capture;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;

/**
 * The unattended sweep: bearing after bearing, distance after distance, until all are done. What is
 * recorded already is not taken again. Not thread-safe.
 */
public final class Sweep {
  private final SweepPlan plan;
  private final Recorder recorder;
  private final PingSource pings;
  private final ObstacleStage stage;
  private final LadderSearch search;

  /**
   * Prepares a sweep.
   *
   * @param plan what is to be done
   * @param recorder keeps what was done
   * @param pings gives the readings
   * @param stage moves the obstacle
   */
  public Sweep(SweepPlan plan, Recorder recorder, PingSource pings, ObstacleStage stage) {
    this.plan = plan;
    this.recorder = recorder;
    this.pings = pings;
    this.stage = stage;
    search = new LadderSearch(plan);
  }

  /**
   * Goes on until all bearings are done.
   *
   * @param listener is told of each bearing
   * @throws IOException if there are no readings any more, or they cannot be recorded
   * @throws InterruptedException if the thread is interrupted
   */
  public void run(SweepListener listener) throws IOException, InterruptedException {
    SweepState state = recorder.state();
    for (OptionalInt next = state.nextBearing(plan); next.isPresent(); ) {
      int bearing = next.getAsInt();
      Optional<TriedDistance> probe = search.next(state.levels(bearing));
      if (probe.isPresent()) {
        take(bearing, probe.get());
      } else {
        recorder.record(new Entry.Done(bearing));
        List<Level> levels = state.levels(bearing);
        listener.done(bearing, ThresholdFit.of(levels, plan), state);
        next = state.nextBearing(plan);
      }
    }
  }

  private void take(int bearing, TriedDistance probe) throws IOException, InterruptedException {
    stage.place(plan.bearingDeg(bearing), probe.distanceM());
    // One for the air to become still, and in case that the move was seen by it.
    pings.ping();
    List<Level> levels = recorder.state().levels(bearing);
    int last = levels.size() - 1;
    int had =
        last >= 0 && levels.get(last).isAt(probe.distanceM(), probe.approach())
            ? levels.get(last).pings()
            : 0;
    for (int ping = had; ping < plan.pings(); ping++) {
      recorder.record(bearing, probe, pings.ping());
    }
    // Where to go next is decided by what no loss of power can take away.
    recorder.sync();
  }
}
