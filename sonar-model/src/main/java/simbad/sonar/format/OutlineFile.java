package simbad.sonar.format;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import simbad.sonar.frame.Point;
import simbad.sonar.shape.Crossing;
import simbad.sonar.shape.Outline;
import simbad.sonar.shape.Overlap;

/**
 * Cross-sections as csv files: columns {@code x_m,z_m} or the same in mm or cm, a row per corner in
 * the order in which one goes round, {@code # key: value} lines above. A column {@code part} tells
 * the bodies of a section of several apart.
 *
 * <p>Either sense of going round is accepted and turned into one: counter-clockwise as seen from
 * above. A last row that repeats the first is left out.
 */
public final class OutlineFile {
  /** A cross-section further out than this is a slip of units. */
  public static final double GREATEST_M = 1;

  /** Every edge is compared with every other. */
  private static final int MOST_CORNERS = 5000;

  private static final String PART = "part";
  private static final Map<String, Double> UNITS = Map.of("m", 1.0, "cm", 0.01, "mm", 0.001);

  private OutlineFile() {}

  /**
   * Reads a cross-section.
   *
   * @param file csv
   * @throws DataFormatException naming file, line and field of the first fault: too few corners, a
   *     line that crosses itself, no area, a coordinate beyond {@value #GREATEST_M} m, parts that
   *     overlap
   */
  public static OutlineDocument read(Path file) throws DataFormatException {
    return parse(file, TextFile.read(file));
  }

  /**
   * Reads a cross-section from a text that was read already.
   *
   * @param name how messages name the text
   * @param text csv
   * @throws DataFormatException naming name, line and field of the first fault
   */
  public static OutlineDocument parse(Path name, String text) throws DataFormatException {
    CsvTable csv = CsvTable.parse(name, text);
    if (csv.size() > MOST_CORNERS) {
      throw DataFormatException.inFile(
          name, csv.size() + " rows, expected at most " + MOST_CORNERS + " corners");
    }
    String unit = unit(csv);
    Map<String, List<Point>> corners = new LinkedHashMap<>();
    Map<String, Integer> firstRow = new LinkedHashMap<>();
    for (int row = 0; row < csv.size(); row++) {
      String part = csv.hasColumn(PART) ? csv.text(row, PART) : "";
      firstRow.putIfAbsent(part, row);
      corners
          .computeIfAbsent(part, key -> new ArrayList<>())
          .add(new Point(coordinate(csv, row, "x_" + unit), coordinate(csv, row, "z_" + unit)));
    }
    if (corners.isEmpty()) {
      throw DataFormatException.inFile(name, "no rows, expected at least 3 corners");
    }
    List<Outline> parts = new ArrayList<>();
    for (Map.Entry<String, List<Point>> part : corners.entrySet()) {
      int first = firstRow.getOrDefault(part.getKey(), 0);
      Outline outline = outline(csv, first, part.getValue());
      if (parts.stream().anyMatch(other -> Overlap.of(outline, other))) {
        throw csv.fault(first, PART, "'" + part.getKey() + "' overlaps another part");
      }
      parts.add(outline);
    }
    return new OutlineDocument(parts, csv.header());
  }

  private static String unit(CsvTable csv) throws DataFormatException {
    for (String unit : List.of("m", "mm", "cm")) {
      if (csv.hasColumn("x_" + unit)) {
        csv.requireColumns("z_" + unit);
        return unit;
      }
    }
    csv.requireColumns("x_m", "z_m");
    return "m";
  }

  private static double coordinate(CsvTable csv, int row, String column)
      throws DataFormatException {
    double scale = UNITS.getOrDefault(column.substring(2), 1.0);
    return scale
        * csv.number(
            row,
            column,
            value -> Math.abs(scale * value) <= GREATEST_M,
            "a length within " + GREATEST_M + " m of the axis");
  }

  private static Outline outline(CsvTable csv, int firstRow, List<Point> corners)
      throws DataFormatException {
    List<Point> distinct = withoutRepeats(corners);
    if (distinct.size() < 3) {
      throw csv.fault(
          firstRow, "corners", distinct.size() + " different corners, expected at least 3");
    }
    Outline outline = Outline.of(distinct);
    Optional<Crossing> crossing = Crossing.find(outline);
    if (crossing.isPresent()) {
      throw csv.fault(
          firstRow,
          "corners",
          "the outline crosses or touches itself: its edges from corner "
              + (crossing.get().firstEdge() + 1)
              + " and from corner "
              + (crossing.get().secondEdge() + 1)
              + " meet");
    }
    double areaM2 = outline.signedAreaM2();
    if (areaM2 == 0) {
      throw csv.fault(firstRow, "corners", "all corners lie on one line, expected an area");
    }
    if (areaM2 < 0) {
      Collections.reverse(distinct);
    }
    return Outline.of(distinct);
  }

  private static List<Point> withoutRepeats(List<Point> corners) {
    List<Point> distinct = new ArrayList<>();
    for (Point corner : corners) {
      if (distinct.isEmpty() || !distinct.get(distinct.size() - 1).equals(corner)) {
        distinct.add(corner);
      }
    }
    if (distinct.size() > 1 && distinct.get(0).equals(distinct.get(distinct.size() - 1))) {
      distinct.remove(distinct.size() - 1);
    }
    return distinct;
  }
}
