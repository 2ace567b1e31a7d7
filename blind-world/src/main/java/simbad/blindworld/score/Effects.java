package simbad.blindworld.score;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/** Scores by effect, the worst first. */
final class Effects {

  private Effects() {}

  /**
   * One line of the table.
   *
   * @param effect a name, or an unknown's own name
   * @param right single: named and explained; unknown: called unexplained
   */
  record Line(String effect, Proportion right) {}

  /** What was at work, in a word; what the diagnosis has no name for is in brackets. */
  static String label(Truth truth) {
    return String.join(
        "+",
        truth.effects().stream()
            .map(e -> truth.strange().contains(e) ? "(" + e + ")" : e)
            .sorted()
            .toList());
  }

  static List<Line> lines(List<Graded> cases) {
    Map<String, List<Graded>> byEffect = new TreeMap<>();
    for (Graded g : cases) {
      boolean alone = g.truth().effects().size() == 1;
      if (alone || g.truth().isStrange()) {
        byEffect.computeIfAbsent(key(g.truth()), k -> new ArrayList<>()).add(g);
      }
    }
    List<Line> lines = new ArrayList<>();
    byEffect.forEach((name, of) -> lines.add(new Line(name, Scores.share(of, Effects::right))));
    lines.sort(Comparator.comparingDouble(line -> line.right().share()));
    return lines;
  }

  private static String key(Truth truth) {
    return truth.strange().stream()
        .sorted()
        .findFirst()
        .map(name -> "(" + name + ")")
        .orElseGet(() -> label(truth));
  }

  private static boolean right(Graded graded) {
    return graded.right();
  }

  static List<Object> json(List<Graded> cases) {
    List<Object> json = new ArrayList<>();
    for (Line line : lines(cases)) {
      Map<String, Object> entry = new LinkedHashMap<>();
      entry.put("effect", line.effect());
      entry.putAll(line.right().json());
      json.add(entry);
    }
    return json;
  }
}
