package simbad.blindworld.score;

import java.util.List;

/** How well a number tells two groups apart. */
final class Ranking {

  private Ranking() {}

  /** One case's number, and whether the closed part of its answer is right. */
  record Scored(double score, boolean right) {}

  /** The chance that a strange case has the higher number than a known one, ties counted half. */
  static double auroc(List<Scored> strange, List<Scored> known) {
    return over(strange, known, false);
  }

  /** As {@link #auroc}, counting only known cases that are answered rightly (OpenAUC). */
  static double openAuc(List<Scored> strange, List<Scored> known) {
    return over(strange, known, true);
  }

  private static double over(List<Scored> strange, List<Scored> known, boolean rightOnly) {
    double sum = 0;
    for (Scored s : strange) {
      for (Scored k : known) {
        double wins = s.score() > k.score() ? 1 : s.score() == k.score() ? 0.5 : 0;
        sum += rightOnly && !k.right() ? 0 : wins;
      }
    }
    return strange.isEmpty() || known.isEmpty() ? 0.5 : sum / strange.size() / known.size();
  }

  /** An AUROC's standard error (Hanley and McNeil 1982, Radiology 143, 29). */
  static double standardError(double auroc, int strange, int known) {
    if (strange == 0 || known == 0) {
      return 0.5;
    }
    double q1 = auroc / (2 - auroc);
    double q2 = 2 * auroc * auroc / (1 + auroc);
    double variance =
        auroc * (1 - auroc)
            + (strange - 1) * (q1 - auroc * auroc)
            + (known - 1) * (q2 - auroc * auroc);
    return Math.sqrt(Math.max(0, variance) / strange / known);
  }

  /** The share of strange cases above the number that only a share of the known exceed. */
  static Proportion flaggedAt(List<Scored> strange, List<Scored> known, double falseShare) {
    List<Double> scores = known.stream().map(Scored::score).sorted().toList();
    int index = (int) Math.ceil(scores.size() * (1 - falseShare)) - 1;
    double limit = scores.isEmpty() ? 1 : scores.get(Math.max(0, index));
    int flagged = (int) strange.stream().filter(s -> s.score() > limit).count();
    return new Proportion(flagged, strange.size());
  }
}
