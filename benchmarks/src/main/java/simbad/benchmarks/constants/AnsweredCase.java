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
 * An answer of a finished check beside its opened truth.
 *
 * @param name of the case
 * @param said the tree of diagnosis.json
 * @param truth the tree of truth.json
 */
record AnsweredCase(String name, JsonNode said, JsonNode truth) {
  private static final ObjectMapper MAPPER = new ObjectMapper();
  private static final String SIGNS = "signs";

  /**
   * Reads the answered cases of a check, in the order of their names.
   *
   * @param check folder that {@code simbad blind-check --out} left, finished
   * @param sign that an answer has which has any
   * @throws IOException if a file cannot be read, or an answer is of a program without signs
   */
  static List<AnsweredCase> read(Path check, String sign) throws IOException {
    List<AnsweredCase> cases = new ArrayList<>();
    try (Stream<Path> answers = Files.list(check.resolve("answers"))) {
      for (Path answer : answers.sorted().toList()) {
        Path diagnosis = answer.resolve("diagnosis.json");
        if (Files.exists(diagnosis)) {
          JsonNode said = tree(diagnosis);
          JsonNode signs = said.path(SIGNS);
          if (!signs.isObject() || !(signs.isEmpty() || signs.has(sign))) {
            throw new IOException(
                diagnosis
                    + ": signs: not there; a diagnosis of an older program, or of other logs");
          }
          String name = answer.getFileName().toString();
          Path truth = check.resolve("world/truth").resolve(name).resolve("truth.json");
          cases.add(new AnsweredCase(name, said, tree(truth)));
        }
      }
    }
    return cases;
  }

  private static JsonNode tree(Path file) throws IOException {
    return MAPPER.readTree(Files.readString(file));
  }

  /** Returns what the answer's probabilities are made of, by name; may be changed. */
  Map<String, Double> signs() {
    Map<String, Double> signs = new LinkedHashMap<>();
    said.path(SIGNS).properties().forEach(e -> signs.put(e.getKey(), e.getValue().asDouble()));
    return signs;
  }

  /** Returns the names of the answer. */
  Set<String> explanation() {
    return words(said.path("explanation"));
  }

  /** Returns the names of the effects that are at work. */
  Set<String> effects() {
    Set<String> effects = new TreeSet<>();
    truth.path("effects").fieldNames().forEachRemaining(effects::add);
    return effects;
  }

  /** Returns the sets of names that the truth may be called by otherwise. */
  Set<Set<String>> accepted() {
    Set<Set<String>> sets = new LinkedHashSet<>();
    truth.path("accept").forEach(set -> sets.add(words(set)));
    return sets;
  }

  /** Returns whether something without a name is at work. */
  boolean hasNameless() {
    return !truth.path("unknown").isEmpty() || !truth.path("outside_vocabulary").isEmpty();
  }

  static Set<String> words(JsonNode array) {
    Set<String> words = new TreeSet<>();
    array.forEach(word -> words.add(word.asText()));
    return words;
  }
}
