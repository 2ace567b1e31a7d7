package simbad.gap.motion;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;
import simbad.gap.diagnosis.Interval;
import simbad.gap.diagnosis.Verdict;
import simbad.motion.CommandUse;
import simbad.motion.MotionChain;
import simbad.motion.MotionRun;
import simbad.motion.Robot;
import simbad.motion.effect.FittedMotion;
import simbad.motion.effect.MotionForms;
import simbad.motion.forecast.MotionForecast;
import simbad.motion.format.MotionData;

/** Diagnoses a motion folder. Uses no chance: equal data give an equal diagnosis. */
public final class MotionDiagnoser {
  /** Fewer blocks of ten seconds cannot be left out in fifths. */
  private static final int LEAST_BLOCKS = 6;

  /** An effect that is less probable, its ties counted, is not concluded. */
  private static final double SURE = 0.8;

  private static final int MOST_ROUNDS = 3;

  /** Names that a wheel out of round goes by. */
  private static final Set<String> WHEELS = Set.of("wheel-scale", "wheel-asymmetry", "speed-scale");

  private final MotionData data;
  private final List<MotionRun> runs;
  private final Evidence evidence;
  private final CommandUse use;

  /**
   * Prepares a diagnosis.
   *
   * @param data what was believed, commanded and seen
   */
  public MotionDiagnoser(MotionData data) {
    this.data = data;
    runs = data.runs().stream().map(MotionRun::withoutRepeats).toList();
    evidence = new Evidence(runs);
    use = CommandUse.of(runs, data.robot().wheelBaseM());
  }

  /** What is believed, and what a reference has shown beside it. */
  @SuppressWarnings("ArrayRecordComponent") // Three noises, never compared.
  private record Base(MotionForecast nominal, Noise[] noises, List<FittedMotion> shown) {
    static Base of(MotionData data) {
      Robot robot = data.robot();
      Noise place = Noise.believed(robot.trackSigmaM());
      Noise[] stated = {place, place, Noise.believed(robot.trackSigmaRad())};
      Base believed = new Base(MotionForecast.believed(robot), stated, List.of());
      if (data.reference().isEmpty()) {
        return believed;
      }
      List<MotionRun> runs = data.reference().stream().map(MotionRun::withoutRepeats).toList();
      Evidence trusted = new Evidence(runs);
      if (trusted.blockCount() < LEAST_BLOCKS) {
        return believed;
      }
      Scored best = new Odds(new Search(trusted, robot).run(robot.motion())).best();
      MotionChain chain = best.hypothesis().chain();
      return new Base(
          MotionGap.forecast(runs, chain), best.fit().noises(), best.hypothesis().fitted());
    }
  }

  /** What a log says, slips left out or not. */
  private record Told(Evidence evidence, Odds odds, MotionGap gap, NoiseFindings scatter) {}

  /** Returns the diagnosis. */
  public MotionDiagnosis diagnose() {
    Base base = Base.of(data);
    if (evidence.blockCount() < LEAST_BLOCKS) {
      return undecided(base);
    }
    Told told = told(base, evidence);
    Optional<MotionFinding> slip = told.scatter().slip();
    List<Evidence.Stretch> slips = new ArrayList<>();
    // What slipped would be taken for wheels that are too small; and without it more is seen.
    for (int round = 0; round < MOST_ROUNDS && told.scatter().slip().isPresent(); round++) {
      slips.addAll(told.scatter().slips());
      Evidence calm = evidence.without(slips);
      if (calm.blockCount() < LEAST_BLOCKS) {
        break;
      }
      told = told(base, calm);
    }
    return concluded(base, told, slip);
  }

  private Told told(Base base, Evidence of) {
    Odds odds = new Odds(new Search(of, data.robot()).run(base.nominal().chain()));
    MotionGap gap = gap(base, odds.best());
    if (gap.ratio() >= 1 && !odds.best().hypothesis().forms().isEmpty()) {
      // What makes forecasts worse explains nothing.
      odds = new Odds(List.of(odds.nominal()));
      gap = gap(base, odds.best());
    }
    return new Told(of, odds, gap, new NoiseFindings(of, base.noises(), odds.best().fit()));
  }

  private MotionGap gap(Base base, Scored set) {
    List<MotionChain> folds =
        IntStream.range(0, Evidence.FOLDS)
            .mapToObj(fold -> set.slopes().withoutFold(fold).chain())
            .toList();
    return MotionGap.of(runs, base.nominal(), folds);
  }

  private MotionDiagnosis concluded(Base base, Told told, Optional<MotionFinding> slip) {
    Odds odds = told.odds();
    MotionGap gap = told.gap();
    Findings findings = new Findings(odds);
    List<MotionFinding> named = new ArrayList<>(findings.named());
    Unknown all =
        new Unknown(
            new Strangers(told.evidence(), odds.best()).traces(odds.nominal().fit().residuals()),
            told.scatter().otherEvents());
    // A wheel whose size is named may well be out of round.
    boolean wheels = named.stream().anyMatch(one -> WHEELS.contains(one.effect()));
    Unknown unknown = wheels ? all.without(Strangers.Kind.RIPPLE) : all;
    boolean sure = named.stream().allMatch(one -> odds.ofAny(one.effect(), one.ties()) >= SURE);
    List<MotionFinding> noises = new ArrayList<>();
    slip.ifPresent(noises::add);
    // What has no name scatters as well.
    boolean scatters = !unknown.isLikely() && !all.shows(Strangers.Kind.RIPPLE);
    told.scatter().noise().filter(noise -> scatters).ifPresent(noises::add);
    named.addAll(noises);
    Verdict verdict = verdict(named, unknown, sure);
    boolean believes = verdict == Verdict.EXPLAINED || verdict == Verdict.PARTLY;
    List<MotionFinding> explanation = believes ? named : List.of();
    MotionDiagnosis.Gap figures = figures(gap, odds.best(), verdict);
    return new MotionDiagnosis(
        verdict,
        headline(verdict, named, unknown, figures),
        explanation,
        others(findings, noises, explanation),
        unknown.probability(),
        figures,
        new Budget(gap, figures, odds.best(), base.noises()).of(explanation),
        MotionPlaces.of(runs, gap),
        new Undetectables(told.evidence(), odds).among(Search.forms(data.robot()), use),
        next(odds, explanation),
        fitted(base, odds.best()),
        verdict == Verdict.NONE
            ? base.nominal()
            : MotionGap.forecast(runs, odds.best().hypothesis().chain()));
  }

  private static List<FittedMotion> fitted(Base base, Scored best) {
    List<FittedMotion> fitted = new ArrayList<>(base.shown());
    fitted.addAll(best.hypothesis().fitted());
    return fitted;
  }

  private static List<MotionFinding> others(
      Findings findings, List<MotionFinding> noises, List<MotionFinding> explanation) {
    List<MotionFinding> others = new ArrayList<>();
    for (MotionFinding one : findings.others(explanation)) {
      Optional<MotionFinding> noise =
          noises.stream().filter(other -> other.effect().equals(one.effect())).findFirst();
      others.add(noise.orElse(one));
    }
    others.sort((a, b) -> Double.compare(b.probability(), a.probability()));
    return others;
  }

  /** Without an effect the forecast stays what was believed. */
  private static MotionDiagnosis.Gap figures(MotionGap gap, Scored best, Verdict verdict) {
    boolean none = verdict == Verdict.NONE;
    double ratio = none ? 1 : gap.ratio();
    return new MotionDiagnosis.Gap(
        gap.windows(),
        gap.before(),
        none ? gap.before() : gap.after(),
        gap.coverage(),
        ratio,
        none ? new Interval(1, 1) : gap.ci95(),
        Math.min(ratio, gap.floor(best.fit().noises())));
  }

  private Verdict verdict(List<MotionFinding> named, Unknown unknown, boolean sure) {
    boolean atBound =
        named.stream()
            .flatMap(finding -> finding.parameters().stream())
            .anyMatch(MotionFinding.Parameter::atBound);
    if (named.isEmpty()) {
      return unknown.isLikely() ? Verdict.UNEXPLAINED : Verdict.NONE;
    }
    if (!sure) {
      return Verdict.UNDECIDED;
    }
    return unknown.isLikely() || atBound ? Verdict.PARTLY : Verdict.EXPLAINED;
  }

  private static String headline(
      Verdict verdict, List<MotionFinding> findings, Unknown unknown, MotionDiagnosis.Gap gap) {
    String names = String.join(" + ", findings.stream().map(MotionFinding::effect).toList());
    String shrink = String.format(Locale.ROOT, "the gap shrinks by %.0f %%", 100 * gap.shrink());
    return switch (verdict) {
      case NONE -> "no gap beyond chance";
      case UNEXPLAINED -> "something that no named effect accounts for: " + unknown.words();
      case UNDECIDED -> "this log does not tell which effects are at work; the likeliest: " + names;
      case PARTLY ->
          names
              + ", and something else ("
              + (unknown.isLikely() ? unknown.words() : "a value stands at its bound")
              + "); "
              + shrink;
      case EXPLAINED -> names + "; " + shrink;
    };
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

  private MotionDiagnosis undecided(Base base) {
    double[][] none = new double[3][3];
    return new MotionDiagnosis(
        Verdict.UNDECIDED,
        "the track covers only "
            + evidence.blockCount()
            + " stretches of ten seconds, "
            + LEAST_BLOCKS
            + " are needed",
        List.of(),
        MotionForms.vocabulary().stream()
            .map(name -> new MotionFinding(name, "", 0, List.of(), List.of(), ""))
            .toList(),
        0.5,
        new MotionDiagnosis.Gap(0, none, none, none, 1, new Interval(0, 1), 0),
        Arrays.asList(new MotionDiagnosis.Part("rest", 1, new Interval(0, 1))),
        List.of(),
        List.of(),
        Optional.empty(),
        base.shown(),
        base.nominal());
  }
}
