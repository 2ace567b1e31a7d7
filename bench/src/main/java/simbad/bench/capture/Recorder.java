package simbad.bench.capture;

import java.io.Closeable;
import java.io.IOException;
import java.time.Clock;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.OptionalDouble;
import java.util.function.BiConsumer;
import simbad.bench.protocol.FirmwareMode;
import simbad.bench.protocol.FrameLine;
import simbad.sonar.check.Checks;

/**
 * Writes what happens to the journal and keeps the state that follows from it. A reading is written
 * at once; it counts, and is told, when it is on the disk. Not thread-safe.
 */
public final class Recorder implements Closeable {
  private static final double MS_PER_S = 1000;

  private final Journal journal;
  private final SweepState state;
  private final Clock clock;
  private OptionalDouble temperatureC;
  private long lastMs;

  /** Written and not known to be on the disk: the journal's last lines. */
  private final Deque<Entry> underWay = new ArrayDeque<>();

  private BiConsumer<Entry, SweepState> listener = (entry, after) -> {};

  /**
   * Begins to record.
   *
   * @param journal takes the entries
   * @param state what the journal holds already
   * @param clock for the times of the readings
   * @param temperatureC of the air, degrees Celsius, if known
   */
  public Recorder(Journal journal, SweepState state, Clock clock, OptionalDouble temperatureC) {
    this.journal = journal;
    this.state = state;
    this.clock = clock;
    this.temperatureC = Checks.finite("temperatureC", temperatureC);
  }

  /** Returns how far the sweep has come; changes with each entry that is on the disk. */
  public SweepState state() {
    return state;
  }

  /** Returns the clock of the readings. */
  Clock clock() {
    return clock;
  }

  /** Says how warm the air is from now on. */
  public void setTemperature(double degreesC) {
    OptionalDouble warm = OptionalDouble.of(degreesC);
    Ranging.of(warm, FirmwareMode.FRAME);
    temperatureC = warm;
  }

  /** Lets somebody know of each entry, once it is on the disk, and of the state after it. */
  public void tell(BiConsumer<Entry, SweepState> whom) {
    listener = whom;
  }

  /** Records that something happened. */
  public void note(String text) throws IOException {
    record(new Entry.Note(now(), text));
  }

  /** Records any entry that holds no reading; it is on the disk when this returns. */
  public void record(Entry entry) throws IOException {
    write(entry);
    sync();
  }

  /**
   * Waits until all that was recorded is on the disk and counts.
   *
   * @throws IOException if the disk failed
   */
  public void sync() throws IOException {
    journal.sync();
    acknowledge();
  }

  private void write(Entry entry) throws IOException {
    journal.append(List.of(entry));
    underWay.add(entry);
    acknowledge();
  }

  private void acknowledge() {
    long waiting = journal.underWay();
    while (underWay.size() > waiting) {
      Entry entry = underWay.remove();
      state.take(entry);
      listener.accept(entry, state);
    }
  }

  /**
   * Records a reading: it is in the journal when this returns, and counts when it is on the disk,
   * at the latest after {@link #sync}.
   *
   * @param bearing index in the plan
   * @param probe where the obstacle stands
   * @param ping what was read
   */
  public Entry.Taken record(int bearing, TriedDistance probe, FrameLine.Ping ping)
      throws IOException {
    Entry.Taken taken =
        new Entry.Taken(
            now(), bearing, probe, ping.sequence(), ping.status(), ping.echoUs(), temperatureC);
    write(taken);
    return taken;
  }

  /** Later than the time before, whatever the clock says: no two readings have the same. */
  private double now() {
    lastMs = Math.max(lastMs + 1, clock.millis());
    return lastMs / MS_PER_S;
  }

  @Override
  public void close() throws IOException {
    journal.close();
  }
}
