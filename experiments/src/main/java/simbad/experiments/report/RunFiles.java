package simbad.experiments.report;

import com.fasterxml.jackson.core.util.DefaultIndenter;
import com.fasterxml.jackson.core.util.DefaultPrettyPrinter;
import com.fasterxml.jackson.databind.ObjectWriter;
import com.fasterxml.jackson.databind.json.JsonMapper;
import com.fasterxml.jackson.datatype.jdk8.Jdk8Module;
import java.io.IOException;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.stream.Stream;
import simbad.experiments.control.Tuning;
import simbad.experiments.dataset.MadeDataSet;
import simbad.experiments.run.RunResult;
import simbad.experiments.run.ShareGrid;
import simbad.gap.diagnosis.DataSetFolder;
import simbad.obstacles.ObstacleType;
import simbad.sonar.format.Sha256;
import simbad.sonar.format.TableFile;
import simbad.sonar.format.TextFile;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.shape.ThresholdTable;

/** Writes a run's results into a folder: one folder per obstacle, and the errors of all. */
public final class RunFiles {
  private static final ObjectWriter JSON = jsonWriter();

  /** What a data set of a run's readings begins with; its sensor's name follows. */
  private static final String READINGS = "readings-";

  private RunFiles() {}

  private static ObjectWriter jsonWriter() {
    DefaultIndenter unix = new DefaultIndenter("  ", "\n");
    return JsonMapper.builder()
        .addModule(new Jdk8Module())
        .build()
        .writer(new DefaultPrettyPrinter().withObjectIndenter(unix).withArrayIndenter(unix));
  }

  /**
   * Writes what was measured: per obstacle its table, traces, radial errors and map; the errors of
   * all.
   *
   * @param folder exists and is empty
   * @param origin what made the results
   * @param results obstacle by obstacle
   * @return the SHA-256 of each obstacle's table, by its name
   * @throws IOException if something cannot be written
   */
  public static Map<String, String> write(Path folder, RunOrigin origin, List<RunResult> results)
      throws IOException {
    Map<String, String> hashes = new LinkedHashMap<>();
    for (Map.Entry<String, List<RunResult>> entry : byObstacle(results).entrySet()) {
      Path own = Files.createDirectory(folder.resolve(entry.getKey()));
      ObstacleType type = entry.getValue().get(0).type();
      TableFile.write(own.resolve("table.csv"), type.thresholds());
      hashes.put(entry.getKey(), Sha256.hex(Files.readAllBytes(own.resolve("table.csv"))));
      writeTraces(own.resolve("trace.csv"), entry.getValue());
      writeRadial(own.resolve("radial.csv"), entry.getValue());
      writeMap(own.resolve("map.csv"), entry.getValue());
      writeReadings(own, origin, entry.getValue());
    }
    List<ErrorRecord> errors = results.stream().map(ErrorRecord::of).toList();
    writeErrorsJson(folder.resolve("errors.json"), origin, hashes, errors);
    writeErrorsCsv(folder.resolve("errors.csv"), errors);
    return hashes;
  }

  private static void writeReadings(Path own, RunOrigin origin, List<RunResult> results)
      throws IOException {
    for (RunResult result : results) {
      if (!result.trace().readings().isEmpty()) {
        Path set = Files.createDirectory(own.resolve(READINGS + result.sensor().word()));
        SonarSpec sonar = origin.settings().sonar();
        SensingSetup setup = new SensingSetup(sonar, result.world(), sonar.maxRangeM());
        new MadeDataSet(setup, result.trace().readings()).write(set);
      }
    }
  }

  /**
   * Finds the data sets of a run's readings.
   *
   * @param run a run's folder
   * @return below it, sorted; none where the run has not kept them
   * @throws IOException if it cannot be read
   */
  public static List<Path> dataSets(Path run) throws IOException {
    try (Stream<Path> paths = Files.find(run, 2, (path, is) -> isDataSet(path))) {
      return paths.sorted().toList();
    }
  }

  private static boolean isDataSet(Path path) {
    Path name = path.getFileName();
    return name != null
        && name.toString().startsWith(READINGS)
        && Files.exists(path.resolve(DataSetFolder.SCENE));
  }

  /** Returns the results of each obstacle by its name, in the order in which they come. */
  public static Map<String, List<RunResult>> byObstacle(List<RunResult> results) {
    Map<String, List<RunResult>> byObstacle = new LinkedHashMap<>();
    results.forEach(
        result ->
            byObstacle
                .computeIfAbsent(result.type().name(), name -> new ArrayList<>())
                .add(result));
    return byObstacle;
  }

  private static void writeErrorsJson(
      Path file, RunOrigin origin, Map<String, String> hashes, List<ErrorRecord> errors)
      throws IOException {
    Map<String, Object> document = new LinkedHashMap<>();
    document.put("format", "sonar-run/1");
    document.put("version", origin.version());
    document.put("seed", origin.settings().seed());
    if (origin.settings().pace().turnRateRadPerS() < Tuning.TURN_RATE) {
      document.put("turn_rate_rad_s", origin.settings().pace().turnRateRadPerS());
    }
    if (origin.settings().pace().waitS() > 0) {
      document.put("wait_s", origin.settings().pace().waitS());
    }
    document.put("speed_m_per_s", origin.settings().speedMPerS());
    document.put("sensor", origin.settings().sonar().name());
    document.put("table_sha256", hashes);
    document.put("results", errors);
    TextFile.write(file, JSON.writeValueAsString(document) + "\n");
  }

  private static void writeErrorsCsv(Path file, List<ErrorRecord> errors) throws IOException {
    CsvFile.write(
        file,
        csv -> {
          List<Map<String, Object>> rows = errors.stream().map(RunFiles::fields).toList();
          csv.writeRecord(rows.isEmpty() ? List.of() : List.copyOf(rows.get(0).keySet()));
          for (Map<String, Object> row : rows) {
            csv.writeRecord(
                row.values().stream().map(value -> value == null ? "" : value.toString()).toList());
          }
        });
  }

  @SuppressWarnings("unchecked")
  private static Map<String, Object> fields(ErrorRecord row) {
    return JsonMapper.builder()
        .addModule(new Jdk8Module())
        .build()
        .convertValue(row, LinkedHashMap.class);
  }

  private static void writeTraces(Path file, List<RunResult> results) throws IOException {
    CsvFile.write(
        file,
        csv -> {
          TraceTable.writeHeader(csv);
          for (RunResult result : results) {
            TraceTable.writeRows(csv, result.sensor().word(), result.trace());
          }
        });
  }

  private static void writeRadial(Path file, List<RunResult> results) throws IOException {
    CsvFile.write(
        file,
        csv -> {
          csv.writeRecord("sensor", "bearing_deg", "threshold_m", "mean_abs_error_m");
          for (RunResult result : results) {
            ThresholdTable table = result.type().thresholds().table();
            for (int i = 0; i < table.size(); i++) {
              OptionalDouble error = result.errors().radialM().get(i);
              csv.writeRecord(
                  result.sensor().word(),
                  fixed(i * 360.0 / table.size(), 4),
                  Double.toString(table.valueM(i)),
                  error.isPresent() ? fixed(error.getAsDouble(), 6) : "");
            }
          }
        });
  }

  private static void writeMap(Path file, List<RunResult> results) throws IOException {
    CsvFile.write(
        file,
        csv -> {
          csv.writeRecord("sensor", "x_m", "z_m", "disagreement");
          for (RunResult result : results) {
            ShareGrid grid = result.map().disagreement();
            for (int i = 0; i < grid.shares().size(); i++) {
              csv.writeRecord(
                  result.sensor().word(),
                  fixed(grid.centreM(i % grid.cells()), 4),
                  fixed(grid.centreM(i / grid.cells()), 4),
                  fixed(grid.shares().get(i), 4));
            }
          }
        });
  }

  /**
   * Returns a number rounded half up; many times faster than a format, of which a trace would need
   * a million.
   */
  public static String fixed(double value, int decimals) {
    return new BigDecimal(Double.toString(value))
        .setScale(decimals, RoundingMode.HALF_UP)
        .toPlainString();
  }
}
