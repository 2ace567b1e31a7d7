package simbad.benchmarks.constants;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * One answered case of a finished check, with its opened truth.
 *
 * @param name of the case
 * @param isLevel whether the level law was taken
 * @param signs of something without a name, by name
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
    List<Weighed> tried,
    Set<Set<String>> accepted,
    boolean hasNameless,
    boolean isExplained,
    Set<String> explanation) {
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
    return AnsweredCase.read(check, "misfit").stream().map(CheckedCase::of).toList();
  }

  private static CheckedCase of(AnsweredCase one) {
    List<Weighed> tried = new ArrayList<>();
    for (JsonNode set : one.said().path("tried")) {
      if (set.path("behind_nats").isNumber()) {
        tried.add(
            new Weighed(
                AnsweredCase.words(set.path("effects")), set.get("behind_nats").asDouble()));
      }
    }
    return new CheckedCase(
        one.name(),
        one.said().path("model").asText().equals("level"),
        one.signs(),
        tried,
        accepted(one),
        one.hasNameless(),
        one.said().path("verdict").asText().equals("explained"),
        one.explanation());
  }

  private static Set<Set<String>> accepted(AnsweredCase one) {
    Set<Set<String>> sets = one.accepted();
    if (sets.isEmpty()) {
      sets.add(one.effects());
    }
    return sets;
  }
}
