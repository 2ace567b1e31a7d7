package simbad.blindworld.baseline;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import simbad.blindworld.file.Csv;
import simbad.blindworld.file.FormatException;
import simbad.blindworld.file.Json;
import simbad.blindworld.file.Output;
import simbad.blindworld.world.Forecast;
import simbad.blindworld.world.Scene;

/** Answers data sets with the rule of the largest residual. */
public final class Baseline {

  private static final double SURE = 0.6;
  private static final String DIAGNOSIS = "diagnosis.json";
  private static final String PREDICTIONS = "predictions.csv";

  private Baseline() {}

  /**
   * Writes diagnosis.json and predictions.csv for each data set.
   *
   * @param cases a folder of data sets
   * @param rows a folder with, by data set, rows.csv or sealed.csv to predict; ranges are not read
   * @param out where the answers go
   * @return what is wrong with the data sets that cannot be read, which get no answer
   */
  public static List<String> run(Path cases, Path rows, Path out)
      throws IOException, FormatException {
    if (!Files.isDirectory(cases)) {
      throw new FormatException(cases + ": no such folder");
    }
    List<Path> sets;
    try (var paths = Files.list(cases)) {
      sets = paths.filter(p -> isSensing(p) || isMotion(p)).sorted().toList();
    }
    List<String> faults = new ArrayList<>();
    for (Path set : sets) {
      String id = set.getFileName().toString();
      try {
        answer(set, rows.resolve(id), Files.createDirectories(out.resolve(id)));
      } catch (FormatException e) {
        faults.add(e.getMessage());
      }
    }
    return faults;
  }

  private static boolean isSensing(Path set) {
    return Files.isRegularFile(set.resolve("scene.json"));
  }

  private static boolean isMotion(Path set) {
    return Files.isRegularFile(set.resolve("track.csv"));
  }

  private static void answerMotion(Path set, Path rows, Path out)
      throws IOException, FormatException {
    MotionRule rule = new MotionRule(set);
    Optional<String> name = rule.name(set);
    Output.write(out.resolve(DIAGNOSIS), Json.write(diagnosis(set, name, "slip")));
    if (isMotion(rows)) {
      Output.write(out.resolve(PREDICTIONS), rule.predictions(rows));
    }
  }

  private static void answer(Path set, Path rows, Path out) throws IOException, FormatException {
    if (!isSensing(set)) {
      answerMotion(set, rows, out);
      return;
    }
    Scene scene = DataSet.scene(set.resolve("scene.json"));
    Csv readings = Csv.read(set.resolve("readings.csv"));
    LargestResidual rule = new LargestResidual(scene);
    Optional<String> name = rule.name(DataSet.rows(readings), DataSet.ranges(readings));
    Output.write(out.resolve(DIAGNOSIS), Json.write(diagnosis(set, name, "dropout")));
    Path own = rows.resolve("rows.csv");
    Path wanted = Files.isRegularFile(own) ? own : rows.resolve("sealed.csv");
    if (Files.isRegularFile(wanted)) {
      Forecast forecast = rule.forecast(DataSet.rows(Csv.read(wanted)));
      Output.write(out.resolve(PREDICTIONS), forecast.csv());
    }
  }

  /** The other name is the one that is doubted where nothing is found. */
  private static Map<String, Object> diagnosis(Path set, Optional<String> name, String other) {
    Map<String, Object> effect = new LinkedHashMap<>();
    effect.put("name", name.orElse(other));
    effect.put("probability", name.isPresent() ? SURE : 1 - SURE);
    effect.put("indistinguishable_from", List.of());
    Map<String, Object> json = new LinkedHashMap<>();
    json.put("format", "sonar-diagnosis/1");
    json.put("dataset", set.getFileName().toString());
    json.put("verdict", name.isPresent() ? "explained" : "none");
    json.put("explanation", name.stream().toList());
    json.put("effects", List.of(effect));
    json.put("unknown_probability", name.isPresent() ? 0.2 : 0.1);
    return json;
  }
}
