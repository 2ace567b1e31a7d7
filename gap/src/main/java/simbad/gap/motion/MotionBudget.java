package simbad.gap.motion;

import java.util.ArrayList;
import java.util.List;
import simbad.gap.diagnosis.Interval;
import simbad.motion.effect.MotionForms;

/**
 * How the gap before is made up, in units of it: each named effect, the rest, the floor. What all
 * effects take away together is shared out by what each alone would leave over.
 */
@SuppressWarnings("ArrayRecordComponent") // Numbers, never compared.
record MotionBudget(
    MotionGap gap, MotionDiagnosis.Gap figures, ScoredMotion best, Noise[] believed) {

  List<MotionDiagnosis.Part> of(List<MotionFinding> named) {
    List<String> means =
        named.stream()
            .map(MotionFinding::effect)
            .filter(effect -> best.hypothesis().names(effect))
            .toList();
    double with = gap.fitted(best.hypothesis().chain());
    double[] costs =
        means.stream()
            .mapToDouble(
                effect ->
                    Math.max(1e-9, gap.fitted(best.hypothesis().without(effect).chain()) - with))
            .toArray();
    double sum = 0;
    for (double cost : costs) {
      sum += cost;
    }
    List<MotionDiagnosis.Part> parts = new ArrayList<>();
    Interval shrink = figures.shrinkHere95();
    double taken = means.isEmpty() ? 0 : figures.shrink();
    for (int i = 0; i < costs.length; i++) {
      double share = costs[i] / sum;
      parts.add(
          new MotionDiagnosis.Part(
              means.get(i),
              share * taken,
              new Interval(share * shrink.low(), share * shrink.high())));
    }
    return rest(named, parts, 1 - taken);
  }

  /** Of what is left, scatter beyond the believed one belongs to its names. */
  private List<MotionDiagnosis.Part> rest(
      List<MotionFinding> named, List<MotionDiagnosis.Part> parts, double left) {
    double floor = Math.min(left, figures.floor());
    List<String> scatter =
        named.stream()
            .map(MotionFinding::effect)
            .filter(e -> e.equals(MotionForms.MOTION_NOISE) || e.equals(MotionForms.SLIP))
            .toList();
    double tracker = scatter.isEmpty() ? floor : Math.min(floor, gap.floor(believed));
    double half = (figures.ratioHere95().high() - figures.ratioHere95().low()) / 2;
    for (String effect : scatter) {
      parts.add(part(effect, (floor - tracker) / scatter.size(), half));
    }
    parts.add(part("rest", left - floor, half));
    parts.add(part("floor", tracker, half));
    return parts;
  }

  private static MotionDiagnosis.Part part(String what, double share, double half) {
    return new MotionDiagnosis.Part(
        what, share, new Interval(Math.max(0, share - half), share + half));
  }
}
