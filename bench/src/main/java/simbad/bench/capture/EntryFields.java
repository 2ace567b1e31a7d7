package simbad.bench.capture;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import simbad.bench.protocol.PingStatus;

/** The fields of entries, as texts. */
final class EntryFields {
  /** A counter of 16 bits. */
  private static final int GREATEST_SEQUENCE = 65_535;

  /** What a line of the board can tell: five digits. */
  private static final int GREATEST_ECHO_US = 99_999;

  /** That of a data set's rows. */
  private static final double GREATEST_S = 1e12;

  private EntryFields() {}

  static String seconds(double timeS) {
    return String.format(Locale.ROOT, "%.3f", timeS);
  }

  static List<String> of(Entry.Taken taken) {
    return List.of(
        seconds(taken.timeS()),
        Integer.toString(taken.bearing()),
        Double.toString(taken.probe().distanceM()),
        taken.probe().approach().word(),
        Integer.toString(taken.sequence()),
        taken.status().word(),
        taken.echoUs().isPresent() ? Integer.toString(taken.echoUs().getAsInt()) : "",
        taken.temperatureC().isPresent()
            ? Double.toString(taken.temperatureC().getAsDouble())
            : "");
  }

  /**
   * Makes the entry again.
   *
   * @param fields of a line whose checksum fits
   * @param bearings how many the capture has
   * @throws JournalFieldException naming the first field that no capture can have written
   */
  static Entry entry(String kind, List<String> fields, int bearings) throws JournalFieldException {
    JournalFields read = new JournalFields(fields);
    return switch (kind) {
      case "begun" -> new Entry.Begun(settings(fields));
      case "ping" -> taken(read, bearings);
      case "note" -> new Entry.Note(time(read), read.text(1, "note"));
      case "done" -> new Entry.Done(bearing(read, 0, bearings));
      case "undone" -> new Entry.Undone(bearing(read, 0, bearings));
      case "repeated" -> new Entry.Repeated(bearing(read, 0, bearings));
      default -> throw new JournalFieldException("kind", "'" + kind + "' is not a kind of entry");
    };
  }

  private static Map<String, String> settings(List<String> fields) throws JournalFieldException {
    Map<String, String> settings = new LinkedHashMap<>();
    for (String field : fields) {
      int equals = field.indexOf('=');
      if (equals < 1 || !field.equals(JournalLine.field(field))) {
        throw new JournalFieldException("begun", "'" + field + "' is not NAME=TEXT on one line");
      }
      settings.put(field.substring(0, equals), field.substring(equals + 1).strip());
    }
    return settings;
  }

  private static Entry taken(JournalFields read, int bearings) throws JournalFieldException {
    double timeS = time(read);
    int bearing = bearing(read, 1, bearings);
    TriedDistance probe =
        new TriedDistance(
            read.number(2, "distance_m", Double.MIN_VALUE, SweepPlan.FURTHEST_M),
            read.word(3, "approach", Approach::find));
    int sequence = read.whole(4, "sequence", 0, GREATEST_SEQUENCE);
    PingStatus status = read.word(5, "status", PingStatus::find);
    return new Entry.Taken(
        timeS,
        bearing,
        probe,
        sequence,
        status,
        read.isEmpty(6)
            ? OptionalInt.empty()
            : OptionalInt.of(read.whole(6, "echo_us", 0, GREATEST_ECHO_US)),
        read.isEmpty(7)
            ? OptionalDouble.empty()
            : OptionalDouble.of(
                read.number(7, "temperature_c", Ranging.COLDEST_C, Ranging.WARMEST_C)));
  }

  private static double time(JournalFields read) throws JournalFieldException {
    return read.number(0, "time_s", 0, GREATEST_S);
  }

  private static int bearing(JournalFields read, int index, int bearings)
      throws JournalFieldException {
    return read.whole(index, "bearing", 0, bearings - 1);
  }
}
