package simbad.blindworld.score;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import simbad.blindworld.file.Csv;
import simbad.blindworld.file.FormatException;
import simbad.blindworld.file.JsonObject;
import simbad.blindworld.file.Seal;
import simbad.blindworld.world.Forecast;

/**
 * Reads answers: a folder for each case with diagnosis.json and, for its sealed rows,
 * predictions.csv.
 */
public final class Answers {

  private final Path folder;

  /** Answers below a folder. */
  public Answers(Path folder) {
    this.folder = folder;
  }

  /** One hash over all diagnoses and predictions, to be taken before truths are opened. */
  public String hash() throws IOException, FormatException {
    if (!Files.isDirectory(folder)) {
      throw new FormatException(folder + ": no such folder");
    }
    List<String> leaves = new ArrayList<>();
    try (var paths = Files.list(folder)) {
      for (Path one : paths.sorted().toList()) {
        for (String name : List.of("diagnosis.json", "predictions.csv")) {
          if (Files.isRegularFile(one.resolve(name))) {
            leaves.add(Seal.sha256(Files.readAllBytes(one.resolve(name))));
          }
        }
      }
    }
    return Seal.root(leaves);
  }

  /** The answers to these cases, by case; cases without a diagnosis.json are left out. */
  public Map<String, Answer> read(List<Truth> truths) throws IOException, FormatException {
    Map<String, Answer> answers = new HashMap<>();
    for (Truth truth : truths) {
      Path one = folder.resolve(truth.id());
      if (Files.isRegularFile(one.resolve("diagnosis.json"))) {
        answers.put(truth.id(), read(one, truth));
      }
    }
    return answers;
  }

  private static Answer read(Path one, Truth truth) throws IOException, FormatException {
    JsonObject json = JsonObject.read(one.resolve("diagnosis.json"));
    Path predictions = one.resolve("predictions.csv");
    Optional<MotionSealed> motion = truth.motion();
    Optional<Forecast> forecast =
        Files.isRegularFile(predictions) && motion.isEmpty()
            ? Optional.of(forecast(predictions, truth.countedM().size()))
            : Optional.empty();
    return new Answer(
        verdict(json),
        json.texts("explanation"),
        named(json),
        json.within("unknown_probability", 0, 1),
        verdictProbability(json),
        shrink(json),
        forecast,
        motion.isPresent() ? motion.get().gap(predictions) : Optional.empty());
  }

  private static Verdict verdict(JsonObject json) throws FormatException {
    String word = json.text("verdict");
    return Arrays.stream(Verdict.values())
        .filter(v -> v.word().equals(word))
        .findFirst()
        .orElseThrow(
            () ->
                new FormatException(
                    json.where()
                        + ", verdict: '"
                        + word
                        + "', expected none, explained, partly, unexplained or undecided"));
  }

  private static List<Answer.Named> named(JsonObject json) throws FormatException {
    List<Answer.Named> named = new ArrayList<>();
    for (JsonObject effect : json.objects("effects")) {
      List<String> ties =
          effect.has("indistinguishable_from") ? effect.texts("indistinguishable_from") : List.of();
      named.add(new Answer.Named(effect.text("name"), effect.within("probability", 0, 1), ties));
    }
    return named;
  }

  private static Optional<Map<Verdict, Double>> verdictProbability(JsonObject json)
      throws FormatException {
    if (!json.has("verdict_probability")) {
      return Optional.empty();
    }
    JsonObject stated = json.object("verdict_probability");
    Map<Verdict, Double> probabilities = new EnumMap<>(Verdict.class);
    for (Verdict verdict : Verdict.TRUTHS) {
      probabilities.put(verdict, stated.within(verdict.word(), 0, 1));
    }
    return Optional.of(probabilities);
  }

  private static Optional<Answer.Shrink> shrink(JsonObject json) throws FormatException {
    if (!json.has("gap") || !json.object("gap").has("shrink")) {
      return Optional.empty();
    }
    JsonObject gap = json.object("gap");
    double value = gap.number("shrink");
    boolean bounded = gap.has("shrink_ci95") && !gap.hasNull("shrink_ci95");
    List<Double> interval = bounded ? gap.numbers("shrink_ci95") : List.of(value, value);
    if (interval.size() != 2) {
      throw new FormatException(gap.where() + ", shrink_ci95: expected two numbers");
    }
    return Optional.of(new Answer.Shrink(value, interval.get(0), interval.get(1)));
  }

  /** The 19 quantiles of so many rows. */
  static Forecast forecast(Path file, int rows) throws IOException, FormatException {
    Csv csv = Csv.read(file);
    if (csv.size() != rows) {
      throw new FormatException(file + ": " + csv.size() + " rows, expected " + rows);
    }
    int[] columns = new int[Forecast.LEVELS];
    for (int q = 0; q < columns.length; q++) {
      columns[q] = csv.column("q%02d".formatted(5 * (q + 1)));
    }
    double[][] quantiles = new double[rows][columns.length];
    for (int row = 0; row < rows; row++) {
      for (int q = 0; q < columns.length; q++) {
        quantiles[row][q] = csv.number(row, columns[q]);
        if (q > 0 && quantiles[row][q] < quantiles[row][q - 1]) {
          throw new FormatException(
              "%s, line %d: quantiles that fall, expected rising ones".formatted(file, row + 2));
        }
      }
    }
    return new Forecast(quantiles);
  }
}
