package simbad.blindworld.score;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** How answers stand by how plainly the effects of a case show. */
final class Power {

  /** Lower bounds of z, in standard errors; the last one has no end. */
  private static final double[] FROM = {Double.NEGATIVE_INFINITY, 2, 5, 10, 20, 40};

  private Power() {}

  /** Cases with effects whose plainness is known, from faint to plain; none where it is of none. */
  static List<Object> json(List<Graded> cases) {
    List<Graded> known =
        cases.stream()
            .filter(g -> !g.truth().effects().isEmpty() && g.truth().z().isPresent())
            .toList();
    List<Object> lines = new ArrayList<>();
    for (int i = 0; i < FROM.length && !known.isEmpty(); i++) {
      double from = FROM[i];
      double to = i + 1 < FROM.length ? FROM[i + 1] : Double.POSITIVE_INFINITY;
      List<Graded> bin =
          known.stream()
              .filter(g -> from <= g.truth().z().get() && g.truth().z().get() < to)
              .toList();
      lines.add(line(Math.max(0, from), to, bin));
    }
    return lines;
  }

  private static Map<String, Object> line(double from, double to, List<Graded> bin) {
    Map<String, Object> line = new LinkedHashMap<>();
    line.put("z_from", from);
    if (to < Double.POSITIVE_INFINITY) {
      line.put("z_to", to);
    }
    line.put("right", Scores.share(bin, g -> g.standing() == Graded.Standing.RIGHT).json());
    line.put("detected", Scores.share(bin, Graded::detected).json());
    line.put("wrongly_explained", Scores.share(bin, Graded::wronglyExplained).json());
    return line;
  }
}
