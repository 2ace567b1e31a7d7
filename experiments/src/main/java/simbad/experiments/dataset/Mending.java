package simbad.experiments.dataset;

import de.siegmar.fastcsv.writer.CsvWriter;
import de.siegmar.fastcsv.writer.LineDelimiter;
import java.io.IOException;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import simbad.sonar.format.CsvTable;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.TextFile;

/**
 * What undoes a way of writing readings that is not the format's, row by row: other units, other
 * axes, numbers that stand for no echo.
 */
public final class Mending {
  private static final String RANGE = "range_m";
  private static final String X = "x_m";
  private static final String Z = "z_m";
  private static final String HEADING = "heading_deg";
  private static final String TIME = "t_s";

  private final List<Step> steps = new ArrayList<>();
  private boolean dropDuplicates;

  /** A log without times has no column of them. */
  private boolean mendsTimes;

  private interface Step {
    void mend(MendedRow row) throws DataFormatException;
  }

  /** Creates one that changes nothing. */
  public Mending() {}

  /** Returns whether it changes nothing. */
  public boolean isNothing() {
    return steps.isEmpty() && !dropDuplicates;
  }

  /**
   * Empties ranges that stand for no echo.
   *
   * @param values as they stand in the file, words such as nan among them
   */
  public void noEcho(Collection<String> values) {
    List<String> all = List.copyOf(values);
    steps.add(
        row -> {
          if (all.stream().anyMatch(value -> isSame(value, row.text(RANGE)))) {
            row.set(RANGE, "");
          }
        });
  }

  private static boolean isSame(String one, String other) {
    if (one.equalsIgnoreCase(other)) {
      return true;
    }
    try {
      return Double.parseDouble(one) == Double.parseDouble(other);
    } catch (NumberFormatException e) {
      return false;
    }
  }

  /** Empties ranges above one, in the file's unit. */
  public void noEchoAbove(double greatest) {
    steps.add(
        row -> {
          if (!row.text(RANGE).isEmpty() && row.number(RANGE) > greatest) {
            row.set(RANGE, "");
          }
        });
  }

  /** Multiplies ranges, then adds metres. */
  public void range(double scale, double offsetM) {
    steps.add(
        row -> {
          if (!row.text(RANGE).isEmpty()) {
            row.set(RANGE, scale * row.number(RANGE) + offsetM);
          }
        });
  }

  /** Exchanges x and z. */
  public void swapAxes() {
    steps.add(
        row -> {
          String x = row.text(X);
          row.set(X, row.text(Z));
          row.set(Z, x);
        });
  }

  /** Multiplies x and z; a negative factor turns an axis round. */
  public void positions(double timesX, double timesZ) {
    steps.add(
        row -> {
          row.set(X, timesX * row.number(X));
          row.set(Z, timesZ * row.number(Z));
        });
  }

  /** Multiplies headings, then adds degrees. */
  public void headings(double times, double offsetDeg) {
    steps.add(row -> row.set(HEADING, times * row.number(HEADING) + offsetDeg));
  }

  /** Multiplies times. */
  public void times(double factor) {
    mendsTimes = true;
    steps.add(row -> row.set(TIME, factor * row.number(TIME)));
  }

  /** Leaves one of rows that are alike in every field. */
  public void dropDuplicates() {
    dropDuplicates = true;
  }

  /**
   * Returns the mended text of a file with readings: all columns, in their order.
   *
   * @param file csv
   * @throws DataFormatException naming file, line and field of the first fault
   */
  public String mended(Path file) throws DataFormatException {
    CsvTable csv = CsvTable.parse(file, TextFile.read(file));
    csv.requireColumns(X, Z, HEADING, RANGE);
    if (mendsTimes) {
      csv.requireColumns(TIME);
    }
    Collection<List<String>> rows = dropDuplicates ? new LinkedHashSet<>() : new ArrayList<>();
    for (int i = 0; i < csv.size(); i++) {
      MendedRow row = new MendedRow(csv, i);
      for (Step step : steps) {
        step.mend(row);
      }
      rows.add(row.fields());
    }
    StringWriter text = new StringWriter();
    try (CsvWriter writer = CsvWriter.builder().lineDelimiter(LineDelimiter.LF).build(text)) {
      writer.writeRecord(csv.columns());
      rows.forEach(writer::writeRecord);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return text.toString();
  }
}
