package simbad.benchmarks.constants;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import simbad.gap.diagnosis.Verdict;

/**
 * One answered motion case of a finished check, with its opened truth.
 *
 * @param name of the case
 * @param signs by which it is judged how sure the answer is, by name
 * @param verdict that was concluded
 * @param truth what would have been right: none, explained or unexplained
 * @param names for each concluded effect whether it, or one that the log cannot tell from it, is at
 *     work
 * @param otherDrive logarithm of the factor by which what is left of another drive's gap differs,
 *     what stretches of the log differ by taken out; empty where next to nothing could be removed
 */
record CheckedDrive(
    String name,
    Map<String, Double> signs,
    Verdict verdict,
    Verdict truth,
    List<Boolean> names,
    OptionalDouble otherDrive) {
  private static final ObjectMapper MAPPER = new ObjectMapper();

  /** As in the scorer: less of the nominal gap is no gap. */
  private static final double LEAST_REMOVABLE = 0.05;

  /**
   * Reads the answered cases of a check, in the order of their names.
   *
   * @param check folder that {@code simbad blind-check --out} left, finished
   * @throws IOException if a file cannot be read, or an answer is of a program without signs
   */
  static List<CheckedDrive> read(Path check) throws IOException {
    Map<String, Double> sealed = sealed(check.resolve("cases.csv"));
    List<CheckedDrive> cases = new ArrayList<>();
    try (Stream<Path> answers = Files.list(check.resolve("answers"))) {
      for (Path answer : answers.sorted().toList()) {
        String name = answer.getFileName().toString();
        Path diagnosis = answer.resolve("diagnosis.json");
        if (Files.exists(diagnosis)) {
          JsonNode said = tree(diagnosis);
          if (!said.has("signs")) {
            throw new IOException(diagnosis + ": signs: not there; of an older program");
          }
          JsonNode truth = tree(check.resolve("world/truth").resolve(name).resolve("truth.json"));
          if (!said.get("signs").isEmpty()) {
            cases.add(of(name, said, truth, sealed.getOrDefault(name, Double.NaN)));
          }
        }
      }
    }
    return cases;
  }

  private static JsonNode tree(Path file) throws IOException {
    return MAPPER.readTree(Files.readString(file));
  }

  /** By how much the gap of the sealed drive shrank, by case. */
  private static Map<String, Double> sealed(Path file) throws IOException {
    List<String> lines = Files.readAllLines(file);
    int column = List.of(lines.get(0).split(",")).indexOf("shrink_sealed");
    Map<String, Double> sealed = new HashMap<>();
    for (String line : lines.subList(1, lines.size())) {
      String[] fields = line.split(",", -1);
      if (!fields[column].isEmpty()) {
        sealed.put(fields[0], Double.valueOf(fields[column]));
      }
    }
    return sealed;
  }

  static CheckedDrive of(String name, JsonNode said, JsonNode truth, double sealedShrink) {
    Map<String, Double> signs = new LinkedHashMap<>();
    said.path("signs").properties().forEach(e -> signs.put(e.getKey(), e.getValue().asDouble()));
    List<Set<String>> accepted = new ArrayList<>();
    truth.path("accept").forEach(set -> accepted.add(words(set)));
    Set<String> there = new TreeSet<>();
    truth.path("effects").fieldNames().forEachRemaining(there::add);
    accepted.forEach(there::addAll);
    Set<String> explanation = words(said.path("explanation"));
    List<Boolean> names = new ArrayList<>();
    for (JsonNode effect : said.path("effects")) {
      if (explanation.contains(effect.path("name").asText())) {
        Set<String> any = words(effect.path("indistinguishable_from"));
        any.add(effect.path("name").asText());
        any.retainAll(there);
        names.add(!any.isEmpty());
      }
    }
    Verdict verdict = verdict(said.path("verdict").asText());
    boolean calledByNames = verdict == Verdict.EXPLAINED && accepted.contains(explanation);
    boolean isStrange =
        !truth.path("outside_vocabulary").isEmpty() || !truth.path("unknown").isEmpty();
    Verdict right = truth.path("effects").isEmpty() ? Verdict.NONE : Verdict.EXPLAINED;
    if (isStrange) {
      right = calledByNames ? Verdict.EXPLAINED : Verdict.UNEXPLAINED;
    }
    return new CheckedDrive(
        name, signs, verdict, right, names, otherDrive(said.path("gap"), truth, sealedShrink));
  }

  private static Verdict verdict(String word) {
    return Stream.of(Verdict.values()).filter(v -> v.word().equals(word)).findFirst().orElseThrow();
  }

  private static OptionalDouble otherDrive(JsonNode gap, JsonNode truth, double sealedShrink) {
    double left = gap.path("after").asDouble();
    double here = 1 - gap.path("shrink_of_this_log_ci95").path(0).asDouble() - left;
    boolean isGap = truth.path("sealed_gap_oracle").asDouble(1) <= 1 - LEAST_REMOVABLE;
    if (!isGap || here <= 0 || !(sealedShrink < 1)) {
      return OptionalDouble.empty();
    }
    double apart = Math.log((1 - sealedShrink) / left);
    double own = here / left;
    return OptionalDouble.of(Math.sqrt(Math.max(0, apart * apart - own * own)));
  }

  private static Set<String> words(JsonNode array) {
    Set<String> words = new TreeSet<>();
    array.forEach(word -> words.add(word.asText()));
    return words;
  }
}
