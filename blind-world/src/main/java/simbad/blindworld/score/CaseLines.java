package simbad.blindworld.score;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;

/** Each case by itself, and what kinds were taken for. */
final class CaseLines {

  private CaseLines() {}

  /** What was so and what was said of each case; what was not said is left out. */
  static List<Object> json(List<Graded> cases, String levelWithout, String levelWith) {
    List<Object> lines = new ArrayList<>();
    for (Graded g : cases) {
      Map<String, Object> line = new LinkedHashMap<>();
      line.put("case", g.truth().id());
      line.put("level", g.truth().reference() ? levelWith : levelWithout);
      line.put("kind", g.truth().kind());
      line.put("so", so(g.truth()));
      line.put("said", g.said());
      line.put("right", g.right());
      g.answer().ifPresent(answer -> said(line, answer));
      g.answer().flatMap(Answer::shrink).ifPresent(s -> line.put("shrink_claimed", s.value()));
      g.sealedShrink().ifPresent(shrink -> line.put("shrink_sealed", shrink));
      g.shareOfRemoval().ifPresent(share -> line.put("share_of_oracle_removal", share));
      lines.add(line);
    }
    return lines;
  }

  private static void said(Map<String, Object> line, Answer answer) {
    line.put("verdict", answer.verdict().word());
    line.put("verdict_probability", answer.probabilityOf(answer.verdict()));
    line.put("unknown_probability", answer.unknownProbability());
    if (!answer.effects().isEmpty()) {
      line.put("first_effect", answer.effects().get(0).name());
      line.put("first_probability", answer.effects().get(0).probability());
    }
  }

  /** What was at work, in a word. */
  static String so(Truth truth) {
    return truth.effects().isEmpty() ? "none" : Effects.label(truth);
  }

  /** How often each kind got each verdict, "explained" parted by whether the names are right. */
  static Map<String, Object> byKind(List<Graded> cases) {
    Map<String, Map<String, Object>> table = new TreeMap<>();
    for (Graded g : cases) {
      count(table, g.truth().kind(), taken(g));
    }
    return new LinkedHashMap<>(table);
  }

  private static String taken(Graded graded) {
    if (graded.answer().isEmpty()) {
      return "no answer";
    }
    if (!graded.says(Verdict.EXPLAINED)) {
      return graded.answer().get().verdict().word();
    }
    boolean right = !graded.wronglyExplained();
    return right ? "explained, named rightly" : "explained, named otherwise";
  }

  /** How often answers to each kind are right, cautious and wrong. */
  static Map<String, Object> standings(List<Graded> cases) {
    Map<String, Map<String, Object>> table = new TreeMap<>();
    for (Graded g : cases) {
      count(table, g.truth().kind(), g.standing().name().toLowerCase(Locale.ROOT));
    }
    return new LinkedHashMap<>(table);
  }

  /** What was said, by what was so. */
  static Map<String, Object> byEffects(List<Graded> cases) {
    Map<String, Map<String, Object>> table = new TreeMap<>();
    for (Graded g : cases) {
      count(table, so(g.truth()), g.said());
    }
    return new LinkedHashMap<>(table);
  }

  private static void count(Map<String, Map<String, Object>> table, String row, String column) {
    table
        .computeIfAbsent(row, key -> new TreeMap<>())
        .merge(column, 1, (a, b) -> (Integer) a + (Integer) b);
  }
}
