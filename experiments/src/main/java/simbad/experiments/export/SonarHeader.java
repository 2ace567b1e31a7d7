package simbad.experiments.export;

import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.function.IntFunction;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import simbad.obstacles.ObstacleType;
import simbad.sonar.format.ShippedText;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.shape.Outline;

/**
 * An obstacle before a sensor as one C99 header without allocation: the rule of detection shadows
 * in whole numbers and in floats.
 */
public final class SonarHeader {
  private static final String TEMPLATE = "sonar.h.txt";
  static final String BASE = "base.h.txt";
  private static final Pattern NAME = Pattern.compile("[a-z][a-z0-9_]{0,30}");
  private static final Pattern TOKEN = Pattern.compile("@(\\w+)@");
  private static final int PER_LINE = 12;

  private final ObstacleType type;
  private final SonarSpec sensor;
  private final String name;
  private final HeaderFigures figures;
  private final Optional<FoldedDiagnosis> diagnosis;

  /**
   * Prepares a header.
   *
   * @param type the obstacle; thresholds up to 8.191 m, a reach up to 1 m
   * @param sensor its cone below 90 degrees, its greatest range up to 8.191 m
   * @param name that all names in the header begin with: small letters, digits, underscores
   * @throws IllegalArgumentException for a figure that a header cannot hold, or no such name
   */
  public SonarHeader(ObstacleType type, SonarSpec sensor, String name) {
    this(type, sensor, name, Optional.empty());
  }

  /**
   * Prepares the header of a diagnosis.
   *
   * @param diagnosis before one obstacle
   * @param name that all names in the header begin with
   * @throws IllegalArgumentException for a figure that a header cannot hold, or no such name
   */
  public SonarHeader(FoldedDiagnosis diagnosis, String name) {
    this(diagnosis.type(), diagnosis.sensor(), name, Optional.of(diagnosis));
  }

  private SonarHeader(
      ObstacleType type, SonarSpec sensor, String name, Optional<FoldedDiagnosis> diagnosis) {
    requireName(name);
    this.type = type;
    this.sensor = sensor;
    this.name = name;
    this.diagnosis = diagnosis;
    figures = HeaderFigures.of(type, sensor);
  }

  /**
   * Returns the diagnosed sensor in whole numbers, bit for bit.
   *
   * @throws java.util.NoSuchElementException for a header without a diagnosis
   */
  public IntegerDiagnosis diagnosisInIntegers() {
    FoldedDiagnosis folded = diagnosis.orElseThrow();
    IntegerSonar sonar = inIntegers();
    int[] heldMm = HeaderFigures.thresholds(folded.held());
    return new IntegerDiagnosis(
        (heard, x, z, heading) ->
            heard ? sonar.readMm(heldMm, x, z, heading) : sonar.readMm(x, z, heading),
        DiagnosisFigures.of(folded));
  }

  /**
   * Refuses what names in C cannot begin with.
   *
   * @param name for a header
   * @throws IllegalArgumentException unless it is a small letter with small letters, digits or
   *     underscores after it, 31 at most
   */
  public static void requireName(String name) {
    if (!NAME.matcher(name).matches()) {
      throw new IllegalArgumentException(
          "name = '"
              + name
              + "' cannot begin names in C; expected a small letter, then small letters, "
              + "digits or underscores, 31 at most");
    }
  }

  /** Returns the same rule in whole numbers, bit for bit. */
  public IntegerSonar inIntegers() {
    return new IntegerSonar(figures);
  }

  /**
   * Returns the header.
   *
   * @param version of the program, for the comment
   */
  public String text(String version) {
    Map<String, String> values = words(type, sensor, name, version);
    whole(values);
    inFloats(values);
    values.put("effects", "");
    values.put("diagnosis", "");
    values.put("diagnosis_m", "");
    diagnosis.ifPresent(folded -> diagnosed(folded, values));
    values.put("base", filled(BASE, values));
    return filled(TEMPLATE, values);
  }

  /** What every header says of itself. */
  static Map<String, String> words(
      ObstacleType type, SonarSpec sensor, String name, String version) {
    Map<String, String> values = new LinkedHashMap<>();
    values.put("name", name);
    values.put("NAME", name.toUpperCase(Locale.ROOT));
    values.put("object", line(type.thresholds().header("object").orElse(type.name())));
    values.put("sensor", line(sensor.name()));
    values.put("origin", origin(type));
    values.put("version", line(version));
    return values;
  }

  /** A template with its places filled. */
  static String filled(String template, Map<String, String> values) {
    Matcher tokens = TOKEN.matcher(ShippedText.read(SonarHeader.class, template));
    return tokens.replaceAll(
        token -> Matcher.quoteReplacement(Objects.requireNonNull(values.get(token.group(1)))));
  }

  private void diagnosed(FoldedDiagnosis folded, Map<String, String> values) {
    values.put("held_mm", lines(HeaderFigures.thresholds(folded.held())));
    double[] held = folded.held().valuesM();
    values.put("held_m", lines(held.length, i -> number(held[i])));
    values.put("held", filled("held.h.txt", values));
    values.put("held_in_floats", filled("held-m.h.txt", values));
    values.put(
        "hear",
        name + "_hear(memory->heard ? " + name + "_held_mm : " + name + "_threshold_mm, own)");
    values.put(
        "hear_m", name + "_hear_m(memory->heard ? " + name + "_held_m : " + name + "_threshold_m,");
    DiagnosisWords.put(folded, name, values);
  }

  private void whole(Map<String, String> values) {
    values.put("bearings", Integer.toString(type.thresholds().table().size()));
    values.put("step", Integer.toString(IntegerSonar.step(type.thresholds().table().size())));
    values.put("corners", Integer.toString(type.outline().size()));
    values.put("thresholds_mm", lines(figures.thresholdMm()));
    values.put("corners_half_mm", lines(figures.cornerHalfMm()));
    values.put("cone_sin", Integer.toString(figures.coneSin()));
    values.put("cone_cos", Integer.toString(figures.coneCos()));
    values.put("too_near", tooNear(figures.leastHalves()));
    values.put("most_halves", Integer.toString(figures.mostHalves()));
    values.put("least_mm", millimetres(sensor.minRangeM()));
    values.put("most_mm", millimetres(sensor.maxRangeM()));
  }

  private void inFloats(Map<String, String> values) {
    double[] threshold = type.thresholds().table().valuesM();
    Outline outline = type.outline();
    values.put("thresholds_m", lines(threshold.length, i -> number(threshold[i])));
    values.put(
        "corners_m",
        lines(2 * outline.size(), i -> number(i % 2 == 0 ? outline.xM(i / 2) : outline.zM(i / 2))));
    values.put("cone_sin_m", number(Math.sin(sensor.coneHalfAngleRad())));
    values.put("cone_cos_m", number(Math.cos(sensor.coneHalfAngleRad())));
    values.put("cone_half_angle_rad", number(sensor.coneHalfAngleRad()));
    values.put("least_m", number(sensor.minRangeM()));
    values.put("most_m", number(sensor.maxRangeM()));
  }

  /** What the table's file says of itself: a reconstructed one says so here as well. */
  private static String origin(ObstacleType type) {
    return type.thresholds().header().entrySet().stream()
        .map(entry -> " *   " + line(entry.getKey() + ": " + entry.getValue()))
        .collect(Collectors.joining("\n"));
  }

  /** Nothing may end the comment or begin a line. */
  static String line(String text) {
    return text.replaceAll("[^\\x20-\\x7e]+", " ").replace("*/", "* /").replace("/*", "/ *");
  }

  /** A compiler warns of an unsigned number that is asked whether it is less than 0. */
  static String tooNear(int leastHalves) {
    return leastHalves > 0 ? "halves < " + leastHalves + " || " : "";
  }

  static String millimetres(double metres) {
    return String.format(Locale.ROOT, "%.0f", 1000 * metres);
  }

  static String number(double value) {
    String digits = Float.toString((float) value);
    return (digits.contains(".") || digits.contains("E") ? digits : digits + ".0") + "f";
  }

  static String lines(int[] values) {
    return lines(values.length, i -> Integer.toString(values[i]));
  }

  static String lines(int size, IntFunction<String> value) {
    return IntStream.rangeClosed(0, (size - 1) / PER_LINE)
        .mapToObj(
            line ->
                IntStream.range(line * PER_LINE, Math.min(size, (line + 1) * PER_LINE))
                    .mapToObj(value)
                    .collect(Collectors.joining(", ", "  ", "")))
        .collect(Collectors.joining(",\n"));
  }
}
