package simbad.bench.capture;

import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.Set;
import simbad.bench.protocol.FirmwareMode;
import simbad.sonar.check.Checks;
import simbad.sonar.format.DataFormatException;

/**
 * How a capture was begun, as its journal's first line tells.
 *
 * @param plan of the sweep
 * @param temperatureC of the air, if it was known
 * @param origin everything else by name: obstacle, sensor, port, firmware, version, date
 */
public record CaptureSettings(
    SweepPlan plan, OptionalDouble temperatureC, Map<String, String> origin) {
  private static final String FORMAT = "format";
  private static final String FORMAT_NAME = "bench-journal/1";

  /** What the mode is called among the origin. */
  public static final String MODE = "mode";

  private static final String TEMPERATURE = "temperature_c";
  private static final Set<String> OWN =
      Set.of(FORMAT, TEMPERATURE, "bearings", "pings", "misses", "step_m", "near_m", "far_m");

  /** Checks the temperature and copies what stands there, in its order. */
  public CaptureSettings {
    Checks.finite("temperatureC", temperatureC);
    origin = new LinkedHashMap<>(origin);
  }

  /** Tells whether a journal gives a text of the origin back as it was. */
  public static boolean canHold(String text) {
    return text.equals(JournalLine.field(text));
  }

  /** Returns one thing of the origin, empty text when it is not told. */
  public String of(String name) {
    return origin.getOrDefault(name, "");
  }

  /** Returns the same with one thing of the origin told. */
  public CaptureSettings with(String name, String value) {
    Map<String, String> all = new LinkedHashMap<>(origin);
    all.put(name, value);
    return new CaptureSettings(plan, temperatureC, all);
  }

  /**
   * Returns the mode in which the board reports; of journals from before there was a choice, frame
   * mode.
   *
   * @throws IllegalArgumentException if there is no such mode
   */
  public FirmwareMode mode() {
    String word = of(MODE);
    if (word.isEmpty()) {
      return FirmwareMode.FRAME;
    }
    return FirmwareMode.find(word)
        .orElseThrow(() -> new IllegalArgumentException("mode = '" + word + "' is none"));
  }

  /** Returns what makes distances of this capture's times, as far as it was known at its begin. */
  public Ranging ranging() {
    return Ranging.of(temperatureC, mode());
  }

  /** Returns the first entry of a journal that was begun so. */
  public Entry.Begun entry() {
    Map<String, String> all = new LinkedHashMap<>();
    all.put(FORMAT, FORMAT_NAME);
    all.put("bearings", Integer.toString(plan.bearings()));
    all.put("pings", Integer.toString(plan.pings()));
    all.put("misses", Integer.toString(plan.misses()));
    all.put("step_m", Double.toString(plan.stepM()));
    all.put("near_m", Double.toString(plan.nearM()));
    all.put("far_m", Double.toString(plan.farM()));
    temperatureC.ifPresent(degreesC -> all.put(TEMPERATURE, Double.toString(degreesC)));
    all.putAll(origin);
    return new Entry.Begun(all);
  }

  /**
   * Reads the first entry of a journal.
   *
   * @throws DataFormatException if it is of another format, or a number is none
   */
  public static CaptureSettings of(JournalText text) throws DataFormatException {
    Map<String, String> all = text.begun().settings();
    Path file = text.file();
    if (!FORMAT_NAME.equals(all.get(FORMAT))) {
      throw DataFormatException.inField(file, 1, FORMAT, "expected " + FORMAT_NAME);
    }
    try {
      CaptureSettings settings =
          new CaptureSettings(plan(file, all), temperature(file, all), rest(all));
      settings.ranging();
      return settings;
    } catch (IllegalArgumentException e) {
      throw DataFormatException.inField(file, 1, "begun", String.valueOf(e.getMessage()));
    }
  }

  private static SweepPlan plan(Path file, Map<String, String> all) throws DataFormatException {
    return new SweepPlan(
        whole(file, all, "bearings"),
        whole(file, all, "pings"),
        whole(file, all, "misses"),
        number(file, all, "step_m"),
        number(file, all, "near_m"),
        number(file, all, "far_m"));
  }

  private static int whole(Path file, Map<String, String> all, String name)
      throws DataFormatException {
    double value = number(file, all, name);
    if (value != (int) value) {
      throw DataFormatException.inField(
          file, 1, name, "'" + all.get(name) + "' is not a whole number");
    }
    return (int) value;
  }

  private static double number(Path file, Map<String, String> all, String name)
      throws DataFormatException {
    String text = all.getOrDefault(name, "");
    try {
      return Double.parseDouble(text);
    } catch (NumberFormatException e) {
      throw DataFormatException.inField(file, 1, name, "'" + text + "' is not a number");
    }
  }

  private static OptionalDouble temperature(Path file, Map<String, String> all)
      throws DataFormatException {
    return all.containsKey(TEMPERATURE)
        ? OptionalDouble.of(number(file, all, TEMPERATURE))
        : OptionalDouble.empty();
  }

  private static Map<String, String> rest(Map<String, String> all) {
    Map<String, String> rest = new LinkedHashMap<>(all);
    rest.keySet().removeAll(OWN);
    return rest;
  }
}
