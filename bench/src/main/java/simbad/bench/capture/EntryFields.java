package simbad.bench.capture;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import org.jspecify.annotations.Nullable;
import simbad.bench.protocol.PingStatus;

/** The fields of entries, as texts. */
final class EntryFields {
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
   * @return null when there is no such kind
   * @throws IllegalArgumentException when a field is none
   * @throws IndexOutOfBoundsException when one is missing
   */
  static @Nullable Entry entry(String kind, List<String> fields) {
    return switch (kind) {
      case "begun" -> new Entry.Begun(settings(fields));
      case "ping" -> taken(fields);
      case "note" -> new Entry.Note(Double.parseDouble(fields.get(0)), fields.get(1));
      case "done" -> new Entry.Done(Integer.parseInt(fields.get(0)));
      case "undone" -> new Entry.Undone(Integer.parseInt(fields.get(0)));
      case "repeated" -> new Entry.Repeated(Integer.parseInt(fields.get(0)));
      default -> null;
    };
  }

  private static Map<String, String> settings(List<String> fields) {
    Map<String, String> settings = new LinkedHashMap<>();
    for (String field : fields) {
      int equals = field.indexOf('=');
      settings.put(field.substring(0, equals), field.substring(equals + 1));
    }
    return settings;
  }

  private static Entry taken(List<String> fields) {
    Approach approach = Approach.find(fields.get(3)).orElseThrow(IllegalArgumentException::new);
    return new Entry.Taken(
        Double.parseDouble(fields.get(0)),
        Integer.parseInt(fields.get(1)),
        new Probe(Double.parseDouble(fields.get(2)), approach),
        Integer.parseInt(fields.get(4)),
        PingStatus.find(fields.get(5)).orElseThrow(IllegalArgumentException::new),
        fields.get(6).isEmpty()
            ? OptionalInt.empty()
            : OptionalInt.of(Integer.parseInt(fields.get(6))),
        fields.get(7).isEmpty()
            ? OptionalDouble.empty()
            : OptionalDouble.of(Double.parseDouble(fields.get(7))));
  }
}
