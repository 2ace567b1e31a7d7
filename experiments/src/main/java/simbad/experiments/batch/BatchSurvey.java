package simbad.experiments.batch;

import de.siegmar.fastcsv.reader.CsvParseException;
import de.siegmar.fastcsv.reader.CsvReader;
import de.siegmar.fastcsv.reader.NamedCsvRecord;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import simbad.experiments.run.EdgeKept;
import simbad.experiments.run.SensorKind;
import simbad.sonar.check.Checks;
import simbad.sonar.format.DataFormatException;

/**
 * What a batch's rows say at a glance: figures for each obstacle and sensor, and which runs went
 * wrong. Rows are read one by one, so that there may be millions.
 *
 * @param runs how many rows there are
 * @param wrongRuns how many went wrong
 * @param groups in the order of the rows in which they first stand
 * @param wrong the first of those that went wrong
 */
public record BatchSurvey(long runs, long wrongRuns, List<Group> groups, List<Wrong> wrong) {
  private static final int MOST_WRONG = 200;

  /**
   * The runs of one sensor round one obstacle.
   *
   * @param obstacle its name
   * @param sensor as results.csv names it
   * @param runs how many
   * @param failed of them ended with an error
   * @param unclosed of them did not get round
   * @param lost of them kept too little of the edge; none of the original sensor, which follows
   *     none
   * @param meanCm mean of mean_abs_cm over those that have one
   * @param maxCm greatest max_abs_cm
   */
  public record Group(
      String obstacle,
      String sensor,
      long runs,
      long failed,
      long unclosed,
      long lost,
      OptionalDouble meanCm,
      OptionalDouble maxCm) {
    /** Checks the errors. */
    public Group {
      Checks.number("meanCm", meanCm);
      Checks.number("maxCm", maxCm);
    }
  }

  /**
   * A run that went wrong.
   *
   * @param number of the run
   * @param obstacle that it circled
   * @param sensor that it had
   * @param settings of its controller, its speed and its seed
   * @param what went wrong
   */
  public record Wrong(
      String number, String obstacle, String sensor, String settings, String what) {}

  /** Copies the lists. */
  public BatchSurvey {
    groups = List.copyOf(groups);
    wrong = List.copyOf(wrong);
  }

  /**
   * Reads the rows of a batch.
   *
   * @param folder of the batch
   * @throws DataFormatException for a file that no batch wrote
   * @throws IOException if it cannot be read
   */
  public static BatchSurvey read(Path folder) throws IOException, DataFormatException {
    Path file = folder.resolve(ResultLog.RESULTS);
    Tally tally = new Tally();
    try (CsvReader<NamedCsvRecord> rows = CsvReader.builder().ofNamedCsvRecord(file)) {
      for (NamedCsvRecord row : rows) {
        tally.add(row);
      }
    } catch (CsvParseException | NumberFormatException e) {
      throw DataFormatException.inFile(file, "is not what a batch wrote: " + e.getMessage());
    }
    return tally.survey();
  }

  /** Grows row by row. */
  private static final class Tally {
    private final Map<List<String>, Sums> sums = new LinkedHashMap<>();
    private final List<Wrong> wrong = new ArrayList<>();
    private long runs;
    private long wrongRuns;

    void add(NamedCsvRecord row) {
      List<String> key = List.of(row.getField("obstacle"), row.getField("sensor"));
      String what = sums.computeIfAbsent(key, unused -> new Sums()).add(row);
      runs++;
      if (!what.isEmpty()) {
        wrongRuns++;
        if (wrong.size() < MOST_WRONG) {
          wrong.add(
              new Wrong(
                  row.getField(ResultColumns.NUMBER), key.get(0), key.get(1), settings(row), what));
        }
      }
    }

    private static String settings(NamedCsvRecord row) {
      StringBuilder words = new StringBuilder(row.getField("controller"));
      for (String name : row.getHeader()) {
        if (name.startsWith(ResultColumns.PARAMETER) && !row.getField(name).isEmpty()) {
          words.append(", ").append(name.substring(ResultColumns.PARAMETER.length()));
          words.append(' ').append(row.getField(name));
        }
      }
      return words + ", " + row.getField("speed_m_per_s") + " m/s, seed " + row.getField("seed");
    }

    BatchSurvey survey() {
      List<Group> groups = new ArrayList<>();
      sums.forEach((key, sum) -> groups.add(sum.group(key.get(0), key.get(1))));
      return new BatchSurvey(runs, wrongRuns, groups, wrong);
    }
  }

  /** Of one group. */
  private static final class Sums {
    private long runs;
    private long failed;
    private long unclosed;
    private long lost;
    private long errors;
    private double errorCm;
    private double maxCm;

    /** Returns what went wrong; empty if nothing did. */
    String add(NamedCsvRecord row) {
      runs++;
      if (row.getField(ResultColumns.STATUS).equals(ResultColumns.FAILED)) {
        failed++;
        return "failed: " + row.getField("error");
      }
      if (!row.getField("mean_abs_cm").isEmpty()) {
        errors++;
        errorCm += Double.parseDouble(row.getField("mean_abs_cm"));
        maxCm = Math.max(maxCm, Double.parseDouble(row.getField("max_abs_cm")));
      }
      if (!row.getField("closed").equals("true")) {
        unclosed++;
        return "did not complete the round";
      }
      String kept = row.getField("edge_kept");
      if (!follows(row) || kept.isEmpty() || Double.parseDouble(kept) >= EdgeKept.LEAST_SHARE) {
        return "";
      }
      lost++;
      return "edge kept: " + kept;
    }

    private static boolean follows(NamedCsvRecord row) {
      return !row.getField("sensor").equals(SensorKind.ORIGINAL.word());
    }

    Group group(String obstacle, String sensor) {
      boolean any = errors > 0;
      return new Group(
          obstacle,
          sensor,
          runs,
          failed,
          unclosed,
          lost,
          any ? OptionalDouble.of(errorCm / errors) : OptionalDouble.empty(),
          any ? OptionalDouble.of(maxCm) : OptionalDouble.empty());
    }
  }
}
