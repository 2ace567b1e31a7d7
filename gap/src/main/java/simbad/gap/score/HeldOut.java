package simbad.gap.score;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import simbad.definition.Effect;
import simbad.gap.fit.CalibratedLog;
import simbad.gap.fit.Fit;
import simbad.gap.fit.Fitter;
import simbad.gap.fit.Fold;
import simbad.gap.fit.Hypothesis;
import simbad.gap.fit.Refit;
import simbad.sonar.check.Checks;

/**
 * Scores sets of effects on rows that they were not fitted on: values fitted on every other block
 * of time predict the blocks between, and the other way round. What was fitted is remembered. For
 * one thread.
 */
public final class HeldOut {
  private static final int EVALUATIONS = 15;

  private final List<Half> halves;

  /**
   * A hypothesis with its evidence.
   *
   * @param hypothesis with the values that fit the whole log best
   * @param inSample log likelihood of the whole log, natural
   * @param heldOut log likelihood of each half of the blocks under values fitted on the other half
   */
  public record Scored(Hypothesis hypothesis, double inSample, double heldOut) {
    /** Refuses what is no number. */
    public Scored {
      Checks.number("inSample", inSample);
      Checks.number("heldOut", heldOut);
    }
  }

  /**
   * Scores on a log.
   *
   * @param given the log
   * @param blocks of time that it is cut into
   */
  public HeldOut(CalibratedLog given, Blocks blocks) {
    halves = List.of(new Half(given, blocks, 0), new Half(given, blocks, 1));
  }

  /**
   * Guesses the score of a set that was not fitted again: each parameter is taken to have fitted
   * one nat of chance, and it loses as much as the worst of those that were fitted again.
   */
  public static Scored guess(Fit fit, List<Scored> scored) {
    double loss =
        scored.stream()
            .mapToDouble(one -> one.inSample() - one.hypothesis().size() - one.heldOut())
            .max()
            .orElse(0);
    double guess = fit.logLikelihood() - fit.hypothesis().size() - Math.max(0, loss);
    return new Scored(fit.hypothesis(), fit.logLikelihood(), guess);
  }

  /**
   * Takes from each set what it cannot have learnt: it predicts no better than a subset by more
   * than it fits better. Where edges are sharp a single row that flips would else decide.
   */
  public static List<Scored> capped(List<Scored> sets) {
    // In the order of the sets: that of hashes differs from process to process.
    Map<Set<Effect>, Scored> capped = new LinkedHashMap<>();
    sets.stream()
        .sorted(Comparator.comparingInt(set -> set.hypothesis().forms().size()))
        .forEach(set -> capped.put(new TreeSet<>(set.hypothesis().effects()), cap(set, capped)));
    return List.copyOf(capped.values());
  }

  private static Scored cap(Scored set, Map<Set<Effect>, Scored> capped) {
    double most = set.heldOut();
    for (Effect effect : set.hypothesis().effects()) {
      Scored subset = capped.get(new TreeSet<>(set.hypothesis().without(effect).effects()));
      // With more values it has one of its effects in another form, and is no smaller model.
      if (subset != null && subset.hypothesis().size() <= set.hypothesis().size()) {
        double fitsBetter = Math.max(0, set.inSample() - subset.inSample());
        most = Math.min(most, subset.heldOut() + fitsBetter);
      }
    }
    return new Scored(set.hypothesis(), set.inSample(), most);
  }

  /** Fits each set on either half of the blocks and scores it on the other, few values first. */
  public List<Scored> score(List<Fit> fits) {
    List<Fit> smallFirst =
        fits.stream().sorted(Comparator.comparingInt(fit -> fit.hypothesis().size())).toList();
    List<double[]> scores = halves.parallelStream().map(half -> half.scores(smallFirst)).toList();
    List<Scored> scored = new ArrayList<>();
    for (int i = 0; i < smallFirst.size(); i++) {
      Fit fit = smallFirst.get(i);
      scored.add(
          new Scored(fit.hypothesis(), fit.logLikelihood(), scores.get(0)[i] + scores.get(1)[i]));
    }
    return scored;
  }

  /** Fits on the blocks of one half, and scores on the others. */
  private static final class Half {
    private final CalibratedLog given;
    private final Fold own;
    private final Fold others;

    /** By the values of the whole log. */
    private final Map<Hypothesis, Fit> known = new HashMap<>();

    Half(CalibratedLog given, Blocks blocks, int half) {
      this.given = given;
      own = blocks.half(half);
      others = blocks.half(1 - half);
    }

    double[] scores(List<Fit> smallFirst) {
      Refit again = new Refit(given, own);
      Fitter other = new Fitter(given, others);
      Map<Set<Effect>, Hypothesis> fitted = new HashMap<>();
      double[] scores = new double[smallFirst.size()];
      for (int i = 0; i < scores.length; i++) {
        Hypothesis whole = smallFirst.get(i).hypothesis();
        Fit scored = known.get(whole);
        if (scored == null) {
          Hypothesis refit = refit(again, whole, fitted);
          scored = new Fit(refit, other.logLikelihood(refit));
          known.put(whole, scored);
        }
        fitted.put(new TreeSet<>(whole.effects()), scored.hypothesis());
        scores[i] = scored.logLikelihood();
      }
      return scores;
    }
  }

  private static Hypothesis refit(
      Refit again, Hypothesis whole, Map<Set<Effect>, Hypothesis> fitted) {
    if (whole.size() == 0) {
      return whole;
    }
    Fitter fitter = again.fitter();
    // From where its best subset was fitted on this half: else a set would seem to predict better
    // than its subset only because its values moved less.
    Hypothesis start = whole;
    double best = fitter.logLikelihood(whole);
    for (Effect effect : whole.effects()) {
      Hypothesis subset = fitted.get(new TreeSet<>(whole.without(effect).effects()));
      if (subset != null && subset.size() > 0) {
        Hypothesis joined = joined(whole, subset);
        double there = fitter.logLikelihood(joined);
        if (there > best) {
          best = there;
          start = joined;
        }
      }
    }
    return again.of(start, EVALUATIONS);
  }

  /** A set with the values of a subset where both have the same forms. */
  private static Hypothesis joined(Hypothesis whole, Hypothesis subset) {
    Hypothesis joined = Hypothesis.NONE;
    for (int i = 0; i < whole.forms().size(); i++) {
      int at = subset.forms().indexOf(whole.forms().get(i));
      joined = joined.and(whole.forms().get(i), at >= 0 ? subset.valuesOf(at) : whole.valuesOf(i));
    }
    return joined;
  }
}
