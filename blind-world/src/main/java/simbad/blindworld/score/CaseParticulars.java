package simbad.blindworld.score;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import simbad.blindworld.baseline.DataSet;
import simbad.blindworld.file.Csv;
import simbad.blindworld.file.FormatException;
import simbad.blindworld.file.JsonObject;

/** Reads what answers say in numbers beside names, and holds it against the opened truths. */
public final class CaseParticulars {

  private static final String SCENE = "scene.json";

  private final Path truths;
  private final Path answers;
  private final Optional<Path> nominal;
  private final List<Path> scenes;

  /**
   * Takes folders, each with one for each case in it.
   *
   * @param truths truth.json, sealed.csv and oracle.csv
   * @param answers diagnosis.json
   * @param nominal predictions.csv of what the scene lets expect; without it no place is scored
   * @param cases the data sets, whose scene.json says what is believed; foreign truths have their
   *     own
   */
  public CaseParticulars(Path truths, Path answers, Optional<Path> nominal, Optional<Path> cases) {
    this.truths = truths;
    this.answers = answers;
    this.nominal = nominal;
    scenes = cases.isPresent() ? List.of(cases.get(), truths) : List.of(truths);
  }

  /** Returns what there is of each case that has an answer. */
  public Map<String, Particulars> read(List<Truth> of) throws IOException, FormatException {
    Map<String, Particulars> all = new HashMap<>();
    for (Truth truth : of) {
      Path answer = answers.resolve(truth.id()).resolve("diagnosis.json");
      if (Files.isRegularFile(answer)) {
        all.put(truth.id(), read(truth, JsonObject.read(answer)));
      }
    }
    return all;
  }

  private Particulars read(Truth truth, JsonObject answer) throws IOException, FormatException {
    JsonObject json = JsonObject.read(truths.resolve(truth.id()).resolve("truth.json"));
    List<JsonObject> where = answer.has("where") ? answer.objects("where") : List.of();
    Optional<SealedPlaces> sealed =
        where.isEmpty() || !truth.hasGap() ? Optional.empty() : sealed(truth);
    return new Particulars(
        ParameterHits.of(json, answer),
        sealed.isPresent() ? sealed.get().hits(where) : List.of(),
        where.size());
  }

  private Optional<SealedPlaces> sealed(Truth truth) throws IOException, FormatException {
    Path own = truths.resolve(truth.id());
    Path real = own.resolve("oracle.csv");
    Optional<Path> believed =
        nominal.map(folder -> folder.resolve(truth.id()).resolve("predictions.csv"));
    Optional<Path> scene =
        scenes.stream()
            .map(folder -> folder.resolve(truth.id()).resolve(SCENE))
            .filter(Files::isRegularFile)
            .findFirst();
    boolean isThere = believed.isPresent() && Files.isRegularFile(believed.get());
    if (!isThere || scene.isEmpty() || !Files.isRegularFile(real) || truth.motion().isPresent()) {
      return Optional.empty();
    }
    int rows = truth.countedM().size();
    return Optional.of(
        new SealedPlaces(
            DataSet.scene(scene.get()),
            DataSet.rows(Csv.read(own.resolve("sealed.csv"))),
            Answers.forecast(believed.get(), rows),
            Answers.forecast(real, rows),
            truth.countedM()));
  }
}
