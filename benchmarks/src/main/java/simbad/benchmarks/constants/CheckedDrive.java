package simbad.benchmarks.constants;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Stream;
import simbad.gap.diagnosis.Verdict;
import simbad.gap.motion.MotionConstants;

/**
 * One answered motion case of a finished check, with its opened truth.
 *
 * @param name of the case
 * @param signs by which it is judged how sure the answer is, by name
 * @param verdict that was concluded
 * @param truth what would have been right: none, explained or unexplained
 * @param names for each effect that was concluded or weighed beside something without a name,
 *     whether it, or one that the log cannot tell from it, is at work
 * @param otherDrive logarithm of the factor by which what is left of another drive's gap differs,
 *     what stretches of the log differ by taken out; empty where next to nothing could be removed
 */
record CheckedDrive(
    String name,
    Map<String, Double> signs,
    Verdict verdict,
    Verdict truth,
    Map<String, Boolean> names,
    OptionalDouble otherDrive) {
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
    return AnsweredCase.read(check, "named").stream()
        .filter(one -> !one.signs().isEmpty())
        .map(one -> of(one, sealed.getOrDefault(one.name(), Double.NaN)))
        .toList();
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

  static CheckedDrive of(AnsweredCase one, double sealedShrink) {
    Verdict verdict = verdict(one.said().path("verdict").asText());
    return new CheckedDrive(
        one.name(),
        one.signs(),
        verdict,
        truth(one, verdict),
        names(one),
        otherDrive(one, sealedShrink));
  }

  private static Verdict truth(AnsweredCase one, Verdict verdict) {
    if (one.hasNameless()) {
      boolean calledByNames =
          verdict == Verdict.EXPLAINED && one.accepted().contains(one.explanation());
      return calledByNames ? Verdict.EXPLAINED : Verdict.UNEXPLAINED;
    }
    return one.effects().isEmpty() ? Verdict.NONE : Verdict.EXPLAINED;
  }

  private static Map<String, Boolean> names(AnsweredCase one) {
    Set<String> there = one.effects();
    one.accepted().forEach(there::addAll);
    Set<String> weighed = one.explanation();
    weighed.addAll(MotionConstants.weighed(one.signs()));
    Map<String, Boolean> names = new TreeMap<>();
    for (JsonNode effect : one.said().path("effects")) {
      String name = effect.path("name").asText();
      if (weighed.contains(name)) {
        Set<String> any = AnsweredCase.words(effect.path("indistinguishable_from"));
        any.add(name);
        names.put(name, !Collections.disjoint(any, there));
      }
    }
    return names;
  }

  private static Verdict verdict(String word) {
    return Stream.of(Verdict.values()).filter(v -> v.word().equals(word)).findFirst().orElseThrow();
  }

  private static OptionalDouble otherDrive(AnsweredCase one, double sealedShrink) {
    JsonNode gap = one.said().path("gap");
    double left = gap.path("after").asDouble();
    double here = 1 - gap.path("shrink_of_this_log_ci95").path(0).asDouble() - left;
    boolean isGap = one.truth().path("sealed_gap_oracle").asDouble(1) <= 1 - LEAST_REMOVABLE;
    if (!isGap || here <= 0 || !(sealedShrink < 1)) {
      return OptionalDouble.empty();
    }
    double apart = Math.log((1 - sealedShrink) / left);
    double own = here / left;
    return OptionalDouble.of(Math.sqrt(Math.max(0, apart * apart - own * own)));
  }
}
