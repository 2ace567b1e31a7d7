package simbad.bench.capture;

import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.function.Consumer;
import simbad.bench.protocol.PingStatus;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.frame.Pose;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.Reading;
import simbad.sonar.sensing.ReadingRow;

/**
 * The readings of a journal as a gap data set has them: the obstacle at the origin, unturned, and
 * the sensor round it, looking at its axis. In the same little memory however many they are.
 *
 * <p>What does not count in the sweep is not in it either; nor is an echo from too near, whose time
 * says nothing.
 */
public final class CapturedReadings {
  private static final double QUARTER_RAD = Math.PI / 2;

  private final JournalText text;
  private final CaptureSettings settings;
  private final VoidPings counting;

  private CapturedReadings(JournalText text, CaptureSettings settings, VoidPings counting) {
    this.text = text;
    this.settings = settings;
    this.counting = counting;
  }

  /**
   * Reads a journal once, for what counts of it.
   *
   * @param journal file that nobody writes to meanwhile
   * @throws DataFormatException if it is damaged
   */
  public static CapturedReadings of(Path journal) throws DataFormatException {
    VoidPings counting = new VoidPings();
    JournalText text = JournalText.read(journal, counting::take);
    return new CapturedReadings(text, CaptureSettings.of(text), counting);
  }

  /** Returns what is known of the journal. */
  public JournalText text() {
    return text;
  }

  /** Returns how the capture was begun. */
  public CaptureSettings settings() {
    return settings;
  }

  /** Returns the state of the sweep after the journal's last entry. */
  public SweepState state() {
    return counting.state();
  }

  /**
   * Reads the journal once more and makes the rows.
   *
   * @param each is given every row, in the order in which they were read; one run per bearing
   * @throws DataFormatException if the journal has changed
   */
  public void forEach(Consumer<ReadingRow> each) throws DataFormatException {
    Map<Integer, Integer> counts = new HashMap<>();
    JournalText.read(
        text.file(),
        entry -> {
          if (entry instanceof Entry.Taken taken) {
            int number = counts.merge(taken.bearing(), 1, Integer::sum) - 1;
            if (counting.counts(taken.bearing(), number) && taken.status() != PingStatus.TOO_NEAR) {
              each.accept(row(taken, settings));
            }
          }
        });
  }

  private static ReadingRow row(Entry.Taken taken, CaptureSettings settings) {
    double bearingRad = Math.toRadians(settings.plan().bearingDeg(taken.bearing()));
    double distanceM = taken.probe().distanceM();
    Pose pose =
        Pose.of(
            distanceM * Math.sin(bearingRad),
            distanceM * Math.cos(bearingRad),
            bearingRad + QUARTER_RAD);
    return new ReadingRow(
        "bearing " + settings.plan().bearingDeg(taken.bearing()),
        "SRF04",
        taken.timeS(),
        pose,
        reading(taken, settings));
  }

  private static Reading reading(Entry.Taken taken, CaptureSettings settings) {
    if (taken.status() != PingStatus.ECHO || taken.echoUs().isEmpty()) {
      return NoEcho.NO_ECHO;
    }
    Ranging ranging =
        Ranging.of(
            taken.temperatureC().isPresent() ? taken.temperatureC() : settings.temperatureC(),
            settings.mode());
    return new Echo(ranging.rangeM(taken.echoUs().getAsInt()));
  }
}
