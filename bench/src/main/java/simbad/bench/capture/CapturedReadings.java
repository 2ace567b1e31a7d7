package simbad.bench.capture;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import simbad.bench.protocol.PingStatus;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.frame.Pose;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.Reading;
import simbad.sonar.sensing.ReadingRow;

/**
 * The readings of a journal as a gap data set has them: the obstacle at the origin, unturned, and
 * the sensor round it, looking at its axis.
 *
 * <p>What does not count in the sweep is not in it either; nor is an echo from too near, whose time
 * says nothing.
 */
public final class CapturedReadings {
  private static final double QUARTER_RAD = Math.PI / 2;

  private CapturedReadings() {}

  /**
   * Makes the rows.
   *
   * @param text journal
   * @return in the order in which they were read; one run per bearing
   * @throws DataFormatException if the journal's settings are damaged
   */
  public static List<ReadingRow> of(JournalText text) throws DataFormatException {
    CaptureSettings settings = CaptureSettings.of(text);
    Map<Integer, List<Entry.Taken>> counting = new LinkedHashMap<>();
    for (Entry entry : text.entries()) {
      if (entry instanceof Entry.Taken taken) {
        counting.computeIfAbsent(taken.bearing(), unused -> new ArrayList<>()).add(taken);
      } else if (entry instanceof Entry.Undone undone) {
        forgetLast(counting.getOrDefault(undone.bearing(), List.of()));
      } else if (entry instanceof Entry.Repeated repeated) {
        counting.remove(repeated.bearing());
      }
    }
    List<ReadingRow> rows = new ArrayList<>();
    for (List<Entry.Taken> bearing : counting.values()) {
      for (Entry.Taken taken : bearing) {
        if (taken.status() != PingStatus.TOO_NEAR) {
          rows.add(row(taken, settings));
        }
      }
    }
    return rows;
  }

  private static void forgetLast(List<Entry.Taken> bearing) {
    if (!bearing.isEmpty()) {
      Probe last = bearing.get(bearing.size() - 1).probe();
      while (!bearing.isEmpty() && bearing.get(bearing.size() - 1).probe().equals(last)) {
        bearing.remove(bearing.size() - 1);
      }
    }
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
            taken.temperatureC().isPresent() ? taken.temperatureC() : settings.temperatureC());
    return new Echo(ranging.rangeM(taken.echoUs().getAsInt()));
  }
}
