package simbad.blindworld.score;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * From which size on an effect is found, alone: explained, by its name.
 *
 * <p>The chance rises with the logarithm of the size as a logistic curve does. Its middle (the size
 * found in 50 of 100) and its steepness have a prior, log-normal around 1 and around 2.5, and what
 * the cases leave of both is summed on a grid. Medians and 95 % intervals are of that. Sizes are in
 * units of a practical one.
 */
final class SizeCurves {
  /** Of fewer cases with one effect nothing is said. */
  private static final int LEAST = 6;

  private static final double FURTHEST = StrictMath.log(100);
  private static final double MIDDLE_SPREAD = StrictMath.log(5);
  private static final double STEEPNESS = 2.5;
  private static final double STEEPNESS_SPREAD = 0.7;
  private static final int MIDDLES = 185;
  private static final int STEEPNESSES = 41;

  /** Natural logarithm of the odds of 90 of 100. */
  private static final double NINETY = StrictMath.log(9);

  private SizeCurves() {}

  /** A curve and how probable it is. */
  private record Curve(double middle, double steepness, double weight) {
    double logSize(double logOdds) {
      return middle + logOdds / steepness;
    }
  }

  /** Curves of effects that were put in alone and have a name, by name. */
  static List<Object> json(List<Graded> cases) {
    Map<String, List<Graded>> byEffect = new TreeMap<>();
    cases.stream()
        .filter(g -> !g.truth().isStrange() && g.truth().size().isPresent())
        .forEach(
            g ->
                byEffect
                    .computeIfAbsent(g.truth().effects().get(0), name -> new ArrayList<>())
                    .add(g));
    List<Object> lines = new ArrayList<>();
    byEffect.forEach(
        (effect, of) -> {
          if (of.size() >= LEAST) {
            lines.add(line(effect, of));
          }
        });
    return lines;
  }

  private static Map<String, Object> line(String effect, List<Graded> of) {
    List<Curve> curves = curves(of);
    double half = quantile(curves, 0, 0.5);
    Map<String, Object> line = new LinkedHashMap<>();
    line.put("effect", effect);
    line.put("least", of.stream().mapToDouble(SizeCurves::size).min().orElse(0));
    line.put("greatest", of.stream().mapToDouble(SizeCurves::size).max().orElse(0));
    line.put("right", Scores.share(of, SizeCurves::isFound).json());
    line.put("size_50", half);
    line.put("size_50_ci95", interval(curves, 0));
    line.put("size_90", quantile(curves, NINETY, 0.5));
    line.put("size_90_ci95", interval(curves, NINETY));
    line.put("wrongly_explained_below", wrong(of.stream().filter(g -> size(g) < half).toList()));
    line.put("wrongly_explained_above", wrong(of.stream().filter(g -> size(g) >= half).toList()));
    return line;
  }

  private static Map<String, Object> wrong(List<Graded> of) {
    return Scores.share(of, Graded::wronglyExplained).json();
  }

  private static double size(Graded graded) {
    return graded.truth().size().orElseThrow();
  }

  private static boolean isFound(Graded graded) {
    return graded.standing() == Graded.Standing.RIGHT;
  }

  private static List<Curve> curves(List<Graded> of) {
    double[] logSize = of.stream().mapToDouble(g -> StrictMath.log(size(g))).toArray();
    boolean[] found = new boolean[logSize.length];
    for (int i = 0; i < found.length; i++) {
      found[i] = isFound(of.get(i));
    }
    List<Curve> curves = new ArrayList<>();
    for (int i = 0; i < MIDDLES; i++) {
      double middle = FURTHEST * (2.0 * i / (MIDDLES - 1) - 1);
      for (int j = 0; j < STEEPNESSES; j++) {
        double away = 3 * (2.0 * j / (STEEPNESSES - 1) - 1);
        double steepness = STEEPNESS * StrictMath.exp(STEEPNESS_SPREAD * away);
        double far = middle / MIDDLE_SPREAD;
        double log = -(far * far + away * away) / 2;
        for (int k = 0; k < found.length; k++) {
          double odds = steepness * (logSize[k] - middle);
          log -= StrictMath.log1p(StrictMath.exp(found[k] ? -odds : odds));
        }
        curves.add(new Curve(middle, steepness, StrictMath.exp(log)));
      }
    }
    return curves;
  }

  private static List<Double> interval(List<Curve> curves, double logOdds) {
    return List.of(quantile(curves, logOdds, 0.025), quantile(curves, logOdds, 0.975));
  }

  /** The size at which a curve has these odds, so that it is less with a probability. */
  private static double quantile(List<Curve> curves, double logOdds, double probability) {
    List<Curve> sorted = new ArrayList<>(curves);
    sorted.sort((a, b) -> Double.compare(a.logSize(logOdds), b.logSize(logOdds)));
    double all = curves.stream().mapToDouble(Curve::weight).sum();
    double sum = 0;
    for (Curve curve : sorted) {
      sum += curve.weight;
      if (sum >= probability * all) {
        return StrictMath.exp(curve.logSize(logOdds));
      }
    }
    throw new IllegalStateException("weights that are no numbers");
  }
}
