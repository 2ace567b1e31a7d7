package simbad.bench.board;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import simbad.sonar.check.Checks;
import simbad.sonar.format.CsvTable;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.TextFile;

/**
 * A bench session to be played: what stands before the sensor from which time on, and what goes
 * wrong.
 *
 * @param rows in the order of their times, the first at 0; at least one
 */
public record BoardScript(List<Row> rows) {
  /** The obstacle of a bench with nothing on it. */
  public static final String NOTHING = "none";

  private static final double GREATEST_DISTANCE_M = 100;
  private static final double COLDEST_C = -50;
  private static final double HOTTEST_C = 80;

  /**
   * A part of the session; it lasts until the next one begins.
   *
   * @param timeS when it begins, simulated seconds since the start
   * @param bench what stands before the sensor
   * @param temperatureC of the air, degrees Celsius
   * @param event what befalls the board
   */
  public record Row(double timeS, BenchScene bench, double temperatureC, BoardEvent event) {
    /** Checks the time and the temperature. */
    public Row {
      Checks.notNegative("timeS", timeS);
      Checks.atLeast("temperatureC", temperatureC, -273);
    }
  }

  /** Finds the obstacle of a name. */
  @FunctionalInterface
  public interface Targets {
    /**
     * Finds an obstacle.
     *
     * @param name as in the script, never {@code none}
     * @throws DataFormatException if there is none of that name
     */
    BenchTarget find(String name) throws DataFormatException;
  }

  /** Checks that there are rows and that their times grow from 0. */
  public BoardScript {
    rows = List.copyOf(rows);
    if (rows.isEmpty() || rows.get(0).timeS() != 0) {
      throw new IllegalArgumentException("rows do not begin at timeS = 0");
    }
    for (int i = 1; i < rows.size(); i++) {
      if (!(rows.get(i).timeS() > rows.get(i - 1).timeS())) {
        throw new IllegalArgumentException("timeS = " + rows.get(i).timeS() + " does not grow");
      }
    }
  }

  /**
   * Reads a script.
   *
   * @param file csv with the columns time_s, obstacle, distance_m, offset_m, clockwise_deg,
   *     temperature_c, event
   * @param targets finds the obstacles
   * @throws DataFormatException naming file, line and field of the first fault
   */
  public static BoardScript read(Path file, Targets targets) throws DataFormatException {
    return parse(file, TextFile.read(file), targets);
  }

  static BoardScript parse(Path file, String text, Targets targets) throws DataFormatException {
    CsvTable csv = CsvTable.parse(file, text);
    csv.requireColumns(
        "time_s", "obstacle", "distance_m", "offset_m", "clockwise_deg", "temperature_c", "event");
    if (csv.size() == 0) {
      throw DataFormatException.inFile(file, "has no rows");
    }
    List<Row> rows = new ArrayList<>();
    for (int row = 0; row < csv.size(); row++) {
      rows.add(row(csv, row, targets, rows));
    }
    return new BoardScript(rows);
  }

  private static Row row(CsvTable csv, int row, Targets targets, List<Row> before)
      throws DataFormatException {
    double timeS = finite(csv, row, "time_s");
    if (before.isEmpty() ? timeS != 0 : !(timeS > before.get(before.size() - 1).timeS())) {
      throw csv.fault(
          row, "time_s", timeS + " is out of order; times grow, and the first of them is 0");
    }
    double temperatureC =
        csv.number(
            row,
            "temperature_c",
            celsius -> celsius >= COLDEST_C && celsius <= HOTTEST_C,
            "a temperature in [-50, 80] degrees Celsius");
    return new Row(timeS, bench(csv, row, targets), temperatureC, event(csv, row));
  }

  private static BenchScene bench(CsvTable csv, int row, Targets targets)
      throws DataFormatException {
    double distanceM =
        csv.number(
            row,
            "distance_m",
            metres -> metres >= 0 && metres <= GREATEST_DISTANCE_M,
            "a distance in [0, 100] m");
    double offsetM = finite(csv, row, "offset_m");
    double clockwiseRad = Math.toRadians(finite(csv, row, "clockwise_deg"));
    return new BenchScene(target(csv, row, targets), distanceM, offsetM, clockwiseRad);
  }

  private static Optional<BenchTarget> target(CsvTable csv, int row, Targets targets)
      throws DataFormatException {
    String name = csv.text(row, "obstacle");
    if (name.equals(NOTHING)) {
      return Optional.empty();
    }
    try {
      return Optional.of(targets.find(name));
    } catch (DataFormatException e) {
      throw csv.fault(row, "obstacle", String.valueOf(e.getMessage()));
    }
  }

  private static BoardEvent event(CsvTable csv, int row) throws DataFormatException {
    String word = csv.text(row, "event");
    return BoardEvent.find(word)
        .orElseThrow(
            () ->
                csv.fault(row, "event", "'" + word + "' is none of these: " + BoardEvent.words()));
  }

  private static double finite(CsvTable csv, int row, String column) throws DataFormatException {
    return csv.number(
        row, column, value -> Math.abs(value) < Double.POSITIVE_INFINITY, "a finite number");
  }
}
