package simbad.sonar.format;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Function;
import simbad.sonar.sensing.Circumstances;
import simbad.sonar.sensing.MovedObstacle;
import simbad.sonar.sensing.ReadingRow;

/** The columns of readings that only the second format knows. An empty cell says nothing. */
final class CircumstanceColumns {
  private static final String PLACEMENT = "placement";
  private static final String TEMPERATURE = "temperature_c";
  private static final String OBSTACLE_X = "obstacle_x_m";
  private static final String OBSTACLE_Z = "obstacle_z_m";
  private static final String OBSTACLE_TURN = "obstacle_turn_deg";
  private static final String GAP = "gap_ms";
  private static final String PAUSE = "pause_ms";

  private static final double COLDEST_C = -273.15;
  private static final double GREATEST_C = 1000;
  private static final double GREATEST_MS = 1e12;
  private static final double MS = 1000;

  private CircumstanceColumns() {}

  static Circumstances read(CsvTable csv, int row) throws DataFormatException {
    return new Circumstances(
        csv.hasColumn(ReadingsFile.TIME),
        placement(csv, row),
        temperature(csv, row),
        new MovedObstacle(
            within(ReadingsFile.GREATEST_M, csv, row, OBSTACLE_X),
            within(ReadingsFile.GREATEST_M, csv, row, OBSTACLE_Z),
            scaled(within(ReadingsFile.GREATEST_DEG, csv, row, OBSTACLE_TURN), Math.toRadians(1))),
        scaled(duration(csv, row, GAP), 1 / MS),
        scaled(duration(csv, row, PAUSE), 1 / MS));
  }

  private static boolean isEmpty(CsvTable csv, int row, String column) {
    return !csv.hasColumn(column) || csv.text(row, column).isEmpty();
  }

  private static Optional<String> placement(CsvTable csv, int row) throws DataFormatException {
    return isEmpty(csv, row, PLACEMENT) ? Optional.empty() : Optional.of(csv.label(row, PLACEMENT));
  }

  private static OptionalDouble temperature(CsvTable csv, int row) throws DataFormatException {
    return isEmpty(csv, row, TEMPERATURE)
        ? OptionalDouble.empty()
        : OptionalDouble.of(
            csv.number(
                row,
                TEMPERATURE,
                value -> value >= COLDEST_C && value <= GREATEST_C,
                "a temperature in [-273.15, 1000] degrees Celsius"));
  }

  private static OptionalDouble within(double greatest, CsvTable csv, int row, String column)
      throws DataFormatException {
    return isEmpty(csv, row, column)
        ? OptionalDouble.empty()
        : OptionalDouble.of(ReadingsFile.within(greatest, csv, row, column));
  }

  private static OptionalDouble duration(CsvTable csv, int row, String column)
      throws DataFormatException {
    return isEmpty(csv, row, column)
        ? OptionalDouble.empty()
        : OptionalDouble.of(
            csv.number(
                row,
                column,
                value -> value >= 0 && value <= GREATEST_MS,
                "a time of at least 0 ms, at most " + GREATEST_MS));
  }

  private static OptionalDouble scaled(OptionalDouble value, double by) {
    return value.isPresent() ? OptionalDouble.of(value.getAsDouble() * by) : value;
  }

  /**
   * A column to write.
   *
   * @param name in the header
   * @param text of a row; empty for an empty cell
   */
  record Column(String name, Function<ReadingRow, String> text) {}

  /** The columns in which at least one of the rows says something. */
  static List<Column> of(List<ReadingRow> rows) {
    List<Column> used = new ArrayList<>();
    for (Column column : all()) {
      if (rows.stream().anyMatch(row -> !column.text().apply(row).isEmpty())) {
        used.add(column);
      }
    }
    return used;
  }

  private static List<Column> all() {
    return List.of(
        new Column(PLACEMENT, row -> row.circumstances().placement().orElse("")),
        number(TEMPERATURE, 2, Circumstances::temperatureC),
        number(OBSTACLE_X, ReadingsWriter.DECIMALS_M, now -> now.obstacle().xM()),
        number(OBSTACLE_Z, ReadingsWriter.DECIMALS_M, now -> now.obstacle().zM()),
        number(
            OBSTACLE_TURN,
            ReadingsWriter.DECIMALS_DEG,
            now -> scaled(now.obstacle().turnRad(), Math.toDegrees(1))),
        number(GAP, ReadingsWriter.DECIMALS_S, now -> scaled(now.gapS(), MS)),
        number(PAUSE, ReadingsWriter.DECIMALS_S, now -> scaled(now.pauseS(), MS)));
  }

  private static Column number(
      String name, int decimals, Function<Circumstances, OptionalDouble> of) {
    return new Column(
        name,
        row -> {
          OptionalDouble value = of.apply(row.circumstances());
          return value.isEmpty() ? "" : ReadingsWriter.fixed(value.getAsDouble(), decimals);
        });
  }
}
