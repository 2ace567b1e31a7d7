package simbad.blindworld.score;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import simbad.blindworld.score.Calibration.Claim;
import simbad.blindworld.score.Ranking.Scored;

/** All scores of a set of graded cases. */
final class Scores {

  private static final double FALSE_UNKNOWN = 0.05;

  /** An interval without width is off by infinitely many, which no file can say. */
  private static final double MOST_HALF_WIDTHS = 1e6;

  private final List<Graded> cases;
  private final Map<String, Particulars> particulars;

  Scores(List<Graded> cases) {
    this(cases, Map.of());
  }

  /**
   * Scores of cases.
   *
   * @param particulars what answers say in numbers, by case; nothing where that is not known
   */
  Scores(List<Graded> cases, Map<String, Particulars> particulars) {
    this.cases = List.copyOf(cases);
    this.particulars = Map.copyOf(particulars);
  }

  private List<Graded> kind(String kind) {
    return cases.stream().filter(g -> g.truth().kind().equals(kind)).toList();
  }

  static Proportion share(List<Graded> of, Predicate<Graded> hit) {
    return new Proportion((int) of.stream().filter(hit).count(), of.size());
  }

  /** The shares that the reach speaks of, by name. */
  Map<String, Proportion> shares() {
    List<Graded> singles = kind("single");
    List<Graded> seen = singles.stream().filter(Graded::detected).toList();
    List<Graded> pairs = kind("pair");
    Map<String, Proportion> shares = new LinkedHashMap<>();
    shares.put("answered", share(cases, g -> g.answer().isPresent()));
    shares.put("none called none", share(kind("none"), g -> g.says(Verdict.NONE)));
    shares.put(
        "singles named and explained", share(singles, g -> g.says(Verdict.EXPLAINED) && g.named()));
    shares.put("singles called explained", share(singles, g -> g.says(Verdict.EXPLAINED)));
    shares.put("singles detected", share(singles, Graded::detected));
    shares.put("singles named exactly, of detected", share(seen, Graded::namedExactly));
    shares.put("singles family right, of detected", share(seen, Graded::familyRight));
    shares.put(
        "singles truth in named set, of detected",
        share(
            seen,
            g -> g.answer().orElseThrow().namedWithTies().contains(g.truth().effects().get(0))));
    shares.put("pairs both found", share(pairs, Graded::named));
    shares.put(
        "pairs both found and explained",
        share(pairs, g -> g.says(Verdict.EXPLAINED) && g.named()));
    shares.put("pairs called explained", share(pairs, g -> g.says(Verdict.EXPLAINED)));
    shares.put("pairs at least one found", share(pairs, Graded::namedSome));
    shares.put("unknown called unexplained", unexplained(strange()));
    shares.put("outside called unexplained", unexplained(kind("outside")));
    shares.put("withheld called unexplained", unexplained(kind("withheld")));
    shares.put(
        "unknown flagged at 5 % false",
        Ranking.flaggedAt(scored(strange()), scored(known()), FALSE_UNKNOWN));
    shares.put("all verdicts right", share(cases, Graded::verdictRight));
    shares.put("all undecided", share(cases, g -> g.says(Verdict.UNDECIDED)));
    shares.put("all wrongly explained", share(cases, Graded::wronglyExplained));
    shares.put("all right", standing(Graded.Standing.RIGHT));
    shares.put("all cautious", standing(Graded.Standing.CAUTIOUS));
    shares.put("all wrong", standing(Graded.Standing.WRONG));
    putNumbers(shares);
    return shares;
  }

  /** How well what is said in numbers holds. */
  private void putNumbers(Map<String, Proportion> shares) {
    shares.put("shrinkage interval covers", shrinkCovered());
    shares.put("parameter intervals cover", parameters(Particulars.Parameter::isIn95));
    shares.put("parameter intervals of 90 % cover", parameters(Particulars.Parameter::isIn90));
    shares.put("places larger on sealed rows", places());
    shares.put("none without a place", withoutPlace());
  }

  private Stream<Particulars> particulars(List<Graded> of) {
    return of.stream().flatMap(g -> Stream.ofNullable(particulars.get(g.truth().id())));
  }

  private Proportion parameters(Predicate<Particulars.Parameter> hit) {
    List<Particulars.Parameter> all =
        particulars(cases).flatMap(one -> one.parameters().stream()).toList();
    return new Proportion((int) all.stream().filter(hit).count(), all.size());
  }

  /** How far true values are from stated ones, in half widths of intervals; the nearest first. */
  List<Double> offs() {
    return particulars(cases)
        .flatMap(one -> one.parameters().stream())
        .map(parameter -> Math.min(MOST_HALF_WIDTHS, parameter.off()))
        .sorted()
        .toList();
  }

  private Proportion places() {
    List<Particulars.Place> all = particulars(cases).flatMap(p -> p.places().stream()).toList();
    return new Proportion(
        (int) all.stream().filter(Particulars.Place::isLarger).count(), all.size());
  }

  /** Of those that nothing is at work in. */
  private Proportion withoutPlace() {
    List<Particulars> nones = particulars(kind("none")).toList();
    return new Proportion((int) nones.stream().filter(p -> p.told() == 0).count(), nones.size());
  }

  /** By how many times more a row of the first place told has to lose than one of all rows. */
  List<Double> density() {
    return particulars(cases)
        .flatMap(one -> one.places().stream().limit(1))
        .map(place -> place.removable() / place.rows())
        .toList();
  }

  private Proportion standing(Graded.Standing standing) {
    return share(cases, g -> g.standing() == standing);
  }

  private static Proportion unexplained(List<Graded> of) {
    return share(of, Graded::leavesSomething);
  }

  private List<Graded> known() {
    return plain(cases).filter(g -> !g.truth().isStrange()).toList();
  }

  private List<Graded> strange() {
    return plain(cases).filter(g -> g.truth().isStrange()).toList();
  }

  private static Stream<Graded> plain(List<Graded> cases) {
    return cases.stream().filter(g -> !g.truth().isFaint());
  }

  /** The share of right answers of each kind of case, averaged; what is faint has no part in it. */
  double classMean() {
    return classMean(cases);
  }

  private static double classMean(List<Graded> cases) {
    return plain(cases)
        .collect(
            Collectors.groupingBy(
                g -> g.truth().kind(),
                Collectors.averagingDouble(g -> g.standing() == Graded.Standing.RIGHT ? 1.0 : 0.0)))
        .values()
        .stream()
        .mapToDouble(Double::doubleValue)
        .average()
        .orElse(0);
  }

  /** The mean probability on what is so, over all cases that are not faint. */
  double probabilityOfTruth() {
    return probabilityOfTruth(cases);
  }

  private static double probabilityOfTruth(List<Graded> cases) {
    return plain(cases).mapToDouble(Graded::probabilityOfTruth).average().orElse(0);
  }

  private static List<Scored> scored(List<Graded> of) {
    return of.stream()
        .map(
            g ->
                new Scored(
                    g.answer().map(Answer::unknownProbability).orElse(0.5),
                    g.verdictRight() && g.named()))
        .toList();
  }

  double auroc() {
    return Ranking.auroc(scored(strange()), scored(known()));
  }

  private Map<String, Object> unknown() {
    List<Scored> strange = scored(strange());
    List<Scored> known = scored(known());
    double auroc = Ranking.auroc(strange, known);
    double half = 1.96 * Ranking.standardError(auroc, strange.size(), known.size());
    Map<String, Object> json = new LinkedHashMap<>();
    json.put("unknown_cases", strange.size());
    json.put("known_cases", known.size());
    json.put("auroc", auroc);
    json.put("auroc_low95", Math.max(0, auroc - half));
    json.put("auroc_high95", Math.min(1, auroc + half));
    json.put("open_auc", Ranking.openAuc(strange, known));
    return json;
  }

  private List<Answer> answersOf(Graded graded) {
    return graded.answer().stream().toList();
  }

  List<Claim> verdictClaims() {
    List<Claim> claims = new ArrayList<>();
    for (Graded g : cases) {
      for (Answer a : answersOf(g)) {
        claims.add(new Claim(a.probabilityOf(a.verdict()), g.verdictRight()));
      }
    }
    return claims;
  }

  List<Claim> firstNamedClaims() {
    List<Claim> claims = new ArrayList<>();
    for (Graded g : cases) {
      for (Answer a : answersOf(g)) {
        if (!a.effects().isEmpty()) {
          Answer.Named first = a.effects().get(0);
          claims.add(new Claim(first.probability(), g.truth().mayBeCalled(first.name())));
        }
      }
    }
    return claims;
  }

  /**
   * The log score over the three verdicts, against always stating their shares; none where all
   * truths have one verdict, for that is stated without a loss.
   */
  OptionalDouble verdictBetterBy() {
    return verdictBase(cases) > 0
        ? OptionalDouble.of(verdictBetterBy(cases))
        : OptionalDouble.empty();
  }

  private static double verdictBase(List<Graded> cases) {
    double base = 0;
    for (Verdict verdict : Verdict.TRUTHS) {
      double share = share(cases, g -> g.truth().verdict() == verdict).share();
      base += share > 0 ? share * Calibration.loss(share) : 0;
    }
    return base;
  }

  private static double verdictBetterBy(List<Graded> cases) {
    double said = cases.stream().mapToDouble(Scores::verdictLoss).average().orElse(0);
    return Calibration.better(said, verdictBase(cases));
  }

  private static double verdictLoss(Graded graded) {
    return Calibration.loss(
        graded.answer().map(a -> a.probabilityOf(graded.truth().verdict())).orElse(0.0));
  }

  private List<Graded> explained() {
    return cases.stream()
        .filter(g -> g.truth().hasGap() && g.says(Verdict.EXPLAINED))
        .filter(g -> g.sealedShrink().isPresent())
        .filter(g -> g.answer().flatMap(Answer::shrink).isPresent())
        .toList();
  }

  private static Answer.Shrink claimed(Graded graded) {
    return graded.answer().flatMap(Answer::shrink).orElseThrow();
  }

  private Proportion shrinkCovered() {
    return share(
        explained(),
        g -> {
          double sealed = g.sealedShrink().orElseThrow();
          return sealed >= claimed(g).low() && sealed <= claimed(g).high();
        });
  }

  /** How far claimed and sealed shrinkage differ, in points. */
  List<Double> shrinkErrors() {
    return explained().stream()
        .map(g -> 100 * Math.abs(claimed(g).value() - g.sealedShrink().orElseThrow()))
        .toList();
  }

  /** Shares of the true world's removal, over known cases with a gap of half a centimetre. */
  List<Double> removals() {
    return known().stream().flatMap(g -> g.shareOfRemoval().stream()).toList();
  }

  private List<Double> trueProbabilities() {
    return kind("single").stream()
        .filter(Graded::detected)
        .map(g -> g.answer().orElseThrow().probabilityOf(g.truth().effects().get(0)))
        .toList();
  }

  private List<Double> setSizes() {
    return kind("single").stream()
        .filter(Graded::detected)
        .map(g -> (double) g.answer().orElseThrow().namedWithTies().size())
        .toList();
  }

  private static double mean(List<Double> values) {
    return values.stream().mapToDouble(Double::doubleValue).average().orElse(0);
  }

  private void putVerdictBetterBy(Map<String, Object> json, double share) {
    json.put("verdict_log_score_better_by", share);
    json.put("verdict_log_score_better_by_ci95", Spread.interval95(cases, Scores::verdictBetterBy));
  }

  Map<String, Object> json() {
    Map<String, Object> json = new LinkedHashMap<>();
    json.put("cases", cases.size());
    Map<String, Object> shares = new LinkedHashMap<>();
    shares().forEach((name, share) -> shares.put(name, share.json()));
    json.put("shares", shares);
    json.put("class_mean", classMean());
    json.put("class_mean_ci95", Spread.interval95(cases, Scores::classMean));
    json.put("probability_of_truth", probabilityOfTruth());
    json.put("probability_of_truth_ci95", Spread.interval95(cases, Scores::probabilityOfTruth));
    List<Object> power = Power.json(cases);
    if (!power.isEmpty()) {
      json.put("power", power);
    }
    List<Object> sizes = SizeCurves.json(cases);
    if (!sizes.isEmpty()) {
      json.put("sizes", sizes);
    }
    json.put("unknown", unknown());
    json.put("verdict_calibration", Calibration.json(verdictClaims()));
    verdictBetterBy().ifPresent(share -> putVerdictBetterBy(json, share));
    json.put("first_named_calibration", Calibration.json(firstNamedClaims()));
    json.put("mean_probability_of_truth_detected_singles", mean(trueProbabilities()));
    json.put("mean_set_size_detected_singles", mean(setSizes()));
    json.put("shrink_claimed_minus_sealed_points", Spread.json(shrinkErrors()));
    json.put("share_of_oracle_removal", Spread.json(removals()));
    json.put("first_place_removable_over_rows", Spread.json(density()));
    json.put("parameter_half_widths", offs());
    json.put("effects_worst_first", Effects.json(cases));
    json.put("kinds", CaseLines.byKind(cases));
    json.put("standings", CaseLines.standings(cases));
    json.put("confusion", CaseLines.byEffects(cases));
    return json;
  }
}
