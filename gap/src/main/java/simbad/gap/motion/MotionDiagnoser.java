package simbad.gap.motion;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;
import simbad.gap.diagnosis.Estimate;
import simbad.gap.diagnosis.Interval;
import simbad.gap.diagnosis.Verdict;
import simbad.gap.score.IntervalWidths;
import simbad.motion.CommandUse;
import simbad.motion.MotionChain;
import simbad.motion.MotionRun;
import simbad.motion.effect.FittedMotion;
import simbad.motion.effect.MotionForm;
import simbad.motion.effect.MotionForms;
import simbad.motion.format.MotionData;

/** Diagnoses a motion folder. Uses no chance: equal data give an equal diagnosis. */
public final class MotionDiagnoser {
  /** Fewer blocks of ten seconds cannot be left out in fifths. */
  static final int LEAST_BLOCKS = 6;

  /** An effect that takes away less than a hundredth of the gap explains nothing. */
  static final double WORTH = 0.99;

  /** What acts on each command in a way of its own. */
  private static final String STEPS = "command-quantization";

  /**
   * Of 47 practice worlds of SRB-1 that have steps (seeds 781 to 783) one knew them less exactly;
   * of 12 in which steps were said falsely, all did.
   */
  private static final double VAGUE = 0.05;

  private static final int MOST_ROUNDS = 3;

  private final MotionData data;
  private final List<MotionRun> runs;
  private final MotionSteps given;
  private final CommandUse use;
  private final MotionConstants constants = MotionConstants.own();

  /**
   * Prepares a diagnosis.
   *
   * @param data what was believed, commanded and seen
   */
  public MotionDiagnoser(MotionData data) {
    this.data = data;
    runs = data.runs().stream().map(MotionRun::withoutRepeats).toList();
    given = new MotionSteps(runs);
    use = CommandUse.of(runs, data.robot().wheelBaseM());
  }

  /** Returns the diagnosis. */
  public MotionDiagnosis diagnose() {
    BelievedMotion base = BelievedMotion.of(data);
    if (given.blockCount() < LEAST_BLOCKS) {
      return undecided(base);
    }
    Told told = told(base, given);
    for (int round = 0; round < MOST_ROUNDS; round++) {
      Optional<BelievedMotion> learnt = base.learning(told.odds().best(), told::gain);
      if (learnt.isEmpty()) {
        break;
      }
      base = learnt.get();
      told = told(base, given);
    }
    Optional<MotionFinding> slip = told.scatter().slip();
    List<MotionSteps.Stretch> slips = new ArrayList<>();
    // What slipped would be taken for wheels that are too small; and without it more is seen.
    for (int round = 0; round < MOST_ROUNDS && told.scatter().slip().isPresent(); round++) {
      slips.addAll(told.scatter().slips());
      MotionSteps calm = given.without(slips);
      if (calm.blockCount() < LEAST_BLOCKS) {
        break;
      }
      told = told(base, calm);
    }
    return concluded(base, told, slip);
  }

  /**
   * Returns what this log says of a value beside what was found, whether it was found or not.
   *
   * @param diagnosis of this log
   * @param form with one parameter on which motion depends smoothly
   */
  public Estimate estimate(MotionDiagnosis diagnosis, MotionForm form) {
    MotionHypothesis found = hypothesis(beside(form, diagnosis));
    boolean isNew = !found.forms().contains(form);
    MotionHypothesis with = isNew ? found.with(form, form.neutralValues()) : found;
    MotionFitter fitter = new MotionFitter(given, use);
    MotionFit fit = fitter.asItIs(with);
    fit = isNew ? fitter.fit(fit) : fit;
    double[] errors = new Slopes(given, fit).standardErrors();
    int at = 0;
    for (MotionForm one : with.forms().subList(0, with.forms().indexOf(form))) {
      at += one.parameters().size();
    }
    // A track in which nothing of it can show has a slope of 0, and says nothing.
    double deviation =
        errors[at] > 0 ? IntervalWidths.own().motion() * errors[at] : Double.POSITIVE_INFINITY;
    return new Estimate(fit.hypothesis().values()[at], deviation);
  }

  /** All that was found but what says the same in other words. */
  private static List<FittedMotion> beside(MotionForm form, MotionDiagnosis diagnosis) {
    return diagnosis.fitted().stream()
        .filter(
            one ->
                one.form().equals(form)
                    || !(one.form().doublesWith(form) || one.form().effect().equals(form.effect())))
        .toList();
  }

  private MotionHypothesis hypothesis(List<FittedMotion> fitted) {
    MotionHypothesis found = new MotionHypothesis(data.robot().motion(), List.of(), new double[0]);
    for (FittedMotion one : fitted) {
      found = found.with(one.form(), one.values());
    }
    return found;
  }

  /**
   * Returns a diagnosis whose model has a value that more than this log says.
   *
   * @param diagnosis of this log
   * @param form with one parameter
   * @param value of it
   */
  public MotionDiagnosis with(MotionDiagnosis diagnosis, MotionForm form, double value) {
    List<FittedMotion> fitted = new ArrayList<>(beside(form, diagnosis));
    fitted.removeIf(one -> one.form().equals(form));
    fitted.add(new FittedMotion(form, new double[] {value}));
    return diagnosis.with(fitted, MotionGap.forecast(runs, hypothesis(fitted).chain()));
  }

  private Told told(BelievedMotion base, MotionSteps of) {
    MotionSearch search = new MotionSearch(of, data.robot());
    MotionChain nominal = base.nominal().chain();
    Told told = told(base, of, search, search.run(nominal));
    ScoredMotion best = told.odds().best();
    if (!isVague(of, best)) {
      return told;
    }
    // All sets that are left may name the steps: then what is left of them would be nothing.
    MotionSearch about = search.without(STEPS);
    return told(base, of, about, about.about(nominal, best.hypothesis().without(STEPS)));
  }

  private Told told(
      BelievedMotion base, MotionSteps of, MotionSearch search, List<ScoredMotion> found) {
    Odds odds = new Odds(found);
    MotionGap gap = gap(base, odds.best());
    // Many that explain next to nothing may explain something together.
    double all = gap.fitted(odds.best().hypothesis().chain());
    for (Optional<String> less = idle(odds, gap, all);
        less.isPresent();
        less = idle(odds, gap, all)) {
      odds = odds.without(less.get());
      // The new best was never asked what it would be without each of its effects.
      odds = odds.and(search.rests(odds.best()));
      gap = gap(base, odds.best());
    }
    return new Told(of, data.runs(), odds, gap, new NoiseFindings(of, base, odds.best().fit()));
  }

  /** Steps that do not just do what they say are bent to something else. */
  private static boolean isVague(MotionSteps of, ScoredMotion best) {
    return best.hypothesis().names(STEPS) && Amplitude.standardError(of, best, STEPS) > VAGUE;
  }

  /** Finds the effect without which the explanation is nearly as good as with all. */
  private static Optional<String> idle(Odds odds, MotionGap gap, double all) {
    List<String> effects = List.copyOf(odds.best().hypothesis().effects());
    if (effects.isEmpty()) {
      return Optional.empty();
    }
    if (effects.size() == 1) {
      return gap.ratio() > WORTH ? Optional.of(effects.get(0)) : Optional.empty();
    }
    String least = "";
    double without = Double.POSITIVE_INFINITY;
    for (String effect : effects) {
      double other = gap.fitted(odds.lacking(effect).hypothesis().chain());
      least = other < without ? effect : least;
      without = Math.min(without, other);
    }
    return without * WORTH < all ? Optional.of(least) : Optional.empty();
  }

  private MotionGap gap(BelievedMotion base, ScoredMotion set) {
    List<MotionChain> folds =
        IntStream.range(0, MotionSteps.FOLDS)
            .parallel()
            .mapToObj(fold -> set.slopes().withoutFold(fold).chain())
            .toList();
    return MotionGap.of(runs, base.nominal(), folds);
  }

  private MotionDiagnosis concluded(BelievedMotion base, Told told, Optional<MotionFinding> slip) {
    Odds odds = told.odds();
    MotionConclusion first = MotionConclusion.of(told, slip);
    boolean asBelieved = first.isAsBelieved();
    MotionDiagnosis.Gap figures = figures(told.gap(), odds.best(), asBelieved);
    Map<String, Double> signs = MotionSigns.of(first, figures, told.worths()).byName();
    ToDoubleFunction<MotionFinding> rightly = one -> constants.namedRightly(signs, one.effect());
    MotionConclusion conclusion =
        first.doubting(rightly, one -> odds.ofAny(one.effect(), one.ties()));
    List<MotionFinding> explanation = conclusion.explanation();
    return new MotionDiagnosis(
        conclusion.verdict(),
        conclusion.headline(figures.shrink()),
        explanation.stream()
            .map(one -> WheelRemedy.of(one.times(rightly.applyAsDouble(one)), data.robot()))
            .toList(),
        conclusion.others(new Findings(odds).others(explanation), rightly),
        constants.verdict(Verdict.UNEXPLAINED, signs),
        signs,
        figures,
        new MotionBudget(told.gap(), figures, odds.best(), base.noises()).of(explanation),
        MotionPlaces.of(runs, told.gap()),
        new MotionUndetectables(told.given(), odds).among(MotionSearch.forms(data.robot()), use),
        next(odds, explanation),
        asBelieved ? base.shown() : fitted(base, odds.best()),
        asBelieved ? base.nominal() : MotionGap.forecast(runs, odds.best().hypothesis().chain()));
  }

  private static List<FittedMotion> fitted(BelievedMotion base, ScoredMotion best) {
    List<FittedMotion> fitted = new ArrayList<>(base.shown());
    fitted.addAll(best.hypothesis().fitted());
    return fitted;
  }

  /** Without an effect that shrinks the gap the forecast stays what was believed. */
  private MotionDiagnosis.Gap figures(MotionGap gap, ScoredMotion best, boolean none) {
    double ratio = none ? 1 : gap.ratio();
    return new MotionDiagnosis.Gap(
        gap.windows(),
        gap.before(),
        none ? gap.before() : gap.after(),
        gap.coverage(),
        ratio,
        none ? new Interval(1, 1) : gap.ci95(),
        none ? new Interval(1, 1) : gap.onAnotherDrive95(constants.otherDrive()),
        Math.min(ratio, gap.floor(best.fit().noises())));
  }

  private Optional<MotionDiagnosis.NextDrive> next(Odds odds, List<MotionFinding> explanation) {
    for (MotionFinding one : explanation) {
      for (String tied : one.ties()) {
        Optional<MotionDiagnosis.NextDrive> drive =
            new NextDrives(use)
                .between(odds.best(), odds.bestWith(tied), List.of(one.effect(), tied));
        if (drive.isPresent()) {
          return drive;
        }
      }
    }
    return Optional.empty();
  }

  private MotionDiagnosis undecided(BelievedMotion base) {
    double[][] none = new double[3][3];
    return new MotionDiagnosis(
        Verdict.UNDECIDED,
        "the track covers only "
            + given.blockCount()
            + " of the "
            + LEAST_BLOCKS
            + " stretches of ten seconds that are needed",
        List.of(),
        MotionForms.vocabulary().stream()
            .map(name -> new MotionFinding(name, "", 0, List.of(), List.of(), ""))
            .toList(),
        0.5,
        Map.of(),
        new MotionDiagnosis.Gap(0, none, none, none, 1, new Interval(0, 1), new Interval(0, 1), 0),
        Arrays.asList(new MotionDiagnosis.Part("rest", 1, new Interval(0, 1))),
        List.of(),
        List.of(),
        Optional.empty(),
        base.shown(),
        base.nominal());
  }
}
