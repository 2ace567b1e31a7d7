package simbad.benchmarks.constants;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;

/**
 * One answered case of a finished check, with its opened truth.
 *
 * @param name of the case
 * @param isLevel whether the level law was taken
 * @param signs of something without a name, by name
 * @param strangersOdds how many times as likely as the named set what has no name is; 0 where it
 *     was not asked
 * @param tried sets that were weighed
 * @param accepted sets of names by which the truth may be called; the empty one for none
 * @param hasNameless whether something without a name is at work
 * @param isExplained whether the answer names effects as the whole of it
 * @param explanation the names of the answer
 */
record CheckedCase(
    String name,
    boolean isLevel,
    Map<String, Double> signs,
    double strangersOdds,
    List<Weighed> tried,
    Set<Set<String>> accepted,
    boolean hasNameless,
    boolean isExplained,
    Set<String> explanation) {
  private static final ObjectMapper MAPPER = new ObjectMapper();
  private static final String ODDS = "strangers_odds";

  /** A set of effects, and by how many nats it is behind the likeliest one. */
  record Weighed(Set<String> effects, double behindNats) {}

  /** Returns whether the names of the answer are among those that the truth allows. */
  boolean isNamedRightly() {
    return accepted.contains(explanation);
  }

  /**
   * Reads the answered cases of a check, in the order of their names.
   *
   * @param check folder that {@code simbad blind-check --out} left, finished
   * @throws IOException if a file cannot be read, or an answer is of a program without signs
   */
  static List<CheckedCase> read(Path check) throws IOException {
    List<CheckedCase> cases = new ArrayList<>();
    try (Stream<Path> answers = Files.list(check.resolve("answers"))) {
      for (Path answer : answers.sorted().toList()) {
        Path diagnosis = answer.resolve("diagnosis.json");
        String name = answer.getFileName().toString();
        Path truth = check.resolve("world/truth").resolve(name).resolve("truth.json");
        if (Files.exists(diagnosis)) {
          cases.add(of(name, tree(diagnosis), tree(truth), diagnosis));
        }
      }
    }
    return cases;
  }

  private static JsonNode tree(Path file) throws IOException {
    return MAPPER.readTree(Files.readString(file));
  }

  private static CheckedCase of(String name, JsonNode answer, JsonNode truth, Path file)
      throws IOException {
    if (!answer.path("signs").has("misfit")) {
      throw new IOException(file + ": signs: not there; a diagnosis of an older program");
    }
    Map<String, Double> signs = new LinkedHashMap<>();
    answer.get("signs").properties().forEach(e -> signs.put(e.getKey(), e.getValue().asDouble()));
    double odds = signs.getOrDefault(ODDS, 0.0);
    signs.remove(ODDS);
    List<Weighed> tried = new ArrayList<>();
    for (JsonNode set : answer.path("tried")) {
      if (set.path("behind_nats").isNumber()) {
        tried.add(new Weighed(words(set.path("effects")), set.get("behind_nats").asDouble()));
      }
    }
    return new CheckedCase(
        name,
        answer.path("model").asText().equals("level"),
        signs,
        odds,
        tried,
        accepted(truth),
        !truth.path("unknown").isEmpty() || !truth.path("outside_vocabulary").isEmpty(),
        answer.path("verdict").asText().equals("explained"),
        words(answer.path("explanation")));
  }

  private static Set<Set<String>> accepted(JsonNode truth) {
    Set<Set<String>> sets = new LinkedHashSet<>();
    truth.path("accept").forEach(set -> sets.add(words(set)));
    if (sets.isEmpty()) {
      Set<String> all = new TreeSet<>();
      truth.path("effects").fieldNames().forEachRemaining(all::add);
      sets.add(all);
    }
    return sets;
  }

  private static Set<String> words(JsonNode array) {
    Set<String> words = new TreeSet<>();
    array.forEach(word -> words.add(word.asText()));
    return words;
  }
}
