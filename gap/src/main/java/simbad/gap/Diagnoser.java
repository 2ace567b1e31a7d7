package simbad.gap;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import simbad.definition.Effect;
import simbad.definition.Trait;
import simbad.gap.audit.AuditFinding;
import simbad.gap.calibrate.Calibration;
import simbad.gap.calibrate.Laws;
import simbad.gap.calibrate.Laws.Law;
import simbad.gap.calibrate.ModelError;
import simbad.gap.calibrate.SetupLeave;
import simbad.gap.design.Experiments;
import simbad.gap.design.Undetectables;
import simbad.gap.diagnosis.DataSet;
import simbad.gap.diagnosis.Diagnosis;
import simbad.gap.diagnosis.GapFigures;
import simbad.gap.diagnosis.Interval;
import simbad.gap.diagnosis.NextExperiment;
import simbad.gap.diagnosis.Place;
import simbad.gap.diagnosis.Verdict;
import simbad.gap.fit.CalibratedLog;
import simbad.gap.fit.Hypothesis;
import simbad.gap.locate.Places;
import simbad.gap.score.Blocks;
import simbad.gap.score.Budget;
import simbad.gap.score.GapGain;
import simbad.gap.score.GapGains;
import simbad.gap.score.GapMeter;
import simbad.gap.score.HeldOut.Scored;
import simbad.gap.score.Probabilities;
import simbad.gap.search.Search;
import simbad.gap.search.Strangers;
import simbad.gap.search.Weighed;
import simbad.gap.unexplained.Constants;
import simbad.gap.unexplained.LevelConstants;
import simbad.gap.unexplained.Signs;
import simbad.gap.unexplained.Unknown;
import simbad.sonar.effect.Definitions;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.SensorLaw;

/** Diagnoses data sets. Deterministic: the same data set and seed give the same diagnosis. */
public final class Diagnoser {
  /** What a further effect must gain for each row, so that more rows do not find what is tiny. */
  private static final double WORTH_NATS_PER_ROW = 0.0025;

  /** A set-up that is known to be off hides more: so many times that is asked of an effect. */
  private static final double OFF = 2;

  static final double TIE_NATS = 3;

  /** How often what the reference shows of an explanation goes into the set-up. */
  private static final int ROUNDS = 3;

  private static final Set<Verdict> OPEN =
      EnumSet.of(Verdict.PARTLY, Verdict.UNEXPLAINED, Verdict.UNDECIDED);

  private static final Set<Effect> MISPLACES = Definitions.with(Trait.MISPLACES);

  private final long seed;
  private final Set<Effect> withheld;

  /**
   * Creates a diagnoser.
   *
   * @param seed of what is resampled
   * @param withheld effects that it shall not know, for checks of what it calls unknown
   */
  public Diagnoser(long seed, Set<Effect> withheld) {
    this.seed = seed;
    this.withheld = Set.copyOf(withheld);
  }

  /**
   * Returns what is diagnosed of a data set that was audited: all of it but rows that are no
   * readings of what stands there.
   *
   * @param data the data set
   * @param audit what was found of it
   */
  public static DataSet believed(DataSet data, List<AuditFinding> audit) {
    return new LeftOut(data, audit).rest();
  }

  /** Diagnoses a data set as it is, without an audit. */
  public Diagnosis diagnose(DataSet data) {
    return diagnose(data, Hypothesis.NONE);
  }

  /**
   * Diagnoses a data set that was audited. Rows that are no readings of what stands there are left
   * out.
   *
   * @param data the data set
   * @param audit what was found of it, which stands in the diagnosis
   */
  public Diagnosis diagnose(DataSet data, List<AuditFinding> audit) {
    LeftOut left = new LeftOut(data, audit);
    Diagnosis first = diagnose(left.rest());
    // What turns or moves the cone has its border at other rows than the believed one.
    LeftOut more = left.under(first.fitted());
    Diagnosis whole = more == left ? first : diagnose(more.rest(), first.fitted());
    LeftOut off = OPEN.contains(whole.verdict()) ? more.misplaced() : more;
    Optional<Diagnosis> placed =
        Optional.of(off)
            .filter(found -> found != more)
            .map(found -> diagnose(found.rest()))
            .filter(found -> saysMore(found, whole));
    return placed
        .map(found -> off.whole(found).with(off.told(audit, more)))
        .orElseGet(() -> more.whole(whole).with(audit));
  }

  /** What is named are places that are not exact, and that explains all, or at least something. */
  private static boolean saysMore(Diagnosis placed, Diagnosis whole) {
    boolean says =
        placed.verdict() == Verdict.EXPLAINED
            || (placed.verdict() != Verdict.UNEXPLAINED && whole.verdict() == Verdict.UNEXPLAINED);
    return says && placed.explanation().stream().anyMatch(MISPLACES::contains);
  }

  /**
   * Diagnoses a data set of which something else has told already.
   *
   * @param data the data set
   * @param offered effects to start from as well, with values near those that fit
   */
  public Diagnosis diagnose(DataSet data, Hypothesis offered) {
    PingLog log = new PingLog(data.readings());
    List<Law> laws =
        data.reference().isEmpty()
            ? List.of(new Law(Calibration.none(data.setup(), log), 0))
            : Laws.of(data.setup(), new PingLog(data.reference()), log);
    List<Inquiry> asked =
        laws.parallelStream().map(law -> inquire(data, log, law.calibration(), offered)).toList();
    Inquiry inquiry = asked.get(0);
    if (laws.size() > 1) {
      double lead = inquiry.nats(laws.get(0)) - asked.get(1).nats(laws.get(1));
      inquiry = lead >= 0 ? inquiry : asked.get(1);
    }
    inquiry = whole(data, log, inquiry, offered);
    return diagnosis(inquiry, conclude(inquiry));
  }

  /** Searches until the set-up holds what belongs to it and nothing is left to try. */
  private Inquiry whole(DataSet data, PingLog log, Inquiry begun, Hypothesis offered) {
    Inquiry inquiry = begun;
    for (int round = 0; round < ROUNDS; round++) {
      Calibration more = inquiry.settled();
      if (more == inquiry.calibration) {
        if (inquiry.isFull()) {
          break;
        }
        inquiry = inquiry.further();
        more = inquiry.settled();
      }
      if (more != inquiry.calibration) {
        inquiry = inquire(data, log, more, offered);
      }
    }
    return inquiry.isFull() ? inquiry : inquiry.further();
  }

  /**
   * What was found of a log before a set-up as calibrated.
   *
   * @param isFull whether nothing is left over, or all was tried that may take it up
   */
  private record Inquiry(
      GapGains gains,
      Calibration calibration,
      double worthNats,
      Search search,
      List<Scored> sets,
      Weighed weighed,
      boolean isFull) {
    static Inquiry of(
        CalibratedLog given, Calibration calibration, double worthNats, Search search) {
      List<Scored> sets = search.run();
      GapGains gains = new GapGains(given);
      Weighed weighed = Weighed.of(gains, sets, worthNats, calibration.temperature());
      return new Inquiry(gains, calibration, worthNats, search, sets, weighed, !search.isOff());
    }

    CalibratedLog given() {
      return gains.given();
    }

    Hypothesis best() {
      return weighed.taken().hypothesis();
    }

    /** The same where something is at work for sure, though none fitted best. */
    Optional<Inquiry> some() {
      return best().forms().isEmpty()
          ? Weighed.ofSome(gains, sets, worthNats, calibration.temperature())
              .map(some -> new Inquiry(gains, calibration, worthNats, search, sets, some, isFull))
          : Optional.empty();
    }

    /** How well reference and log are foretold by a law with this explanation, less its cost. */
    double nats(Law law) {
      Hypothesis best = best();
      double cost =
          Probabilities.COST_NATS * best.forms().size()
              + Probabilities.NATS_PER_VALUE * best.size();
      return law.nats(given(), calibration, best) - cost;
    }

    /** The set-up with what of this belongs to it. */
    Calibration settled() {
      return calibration.with(given(), best());
    }

    Inquiry further() {
      List<Scored> more = search.further();
      return new Inquiry(
          gains,
          calibration,
          worthNats,
          search,
          more,
          Weighed.of(gains, more, worthNats, calibration.temperature()),
          true);
    }
  }

  private Inquiry inquire(DataSet data, PingLog log, Calibration calibration, Hypothesis offered) {
    CalibratedLog given = calibration.given(data.setup(), log);
    double least = Math.max(Probabilities.COST_NATS, WORTH_NATS_PER_ROW * log.size());
    double worth = least * calibration.clumping() * (data.reference().isEmpty() ? 1 : OFF);
    // In one block nothing is left to test on what is fitted: too few rows to name anything.
    Set<Effect> excluded =
        new Blocks(log).canBeHeldOut() ? withheld : Set.copyOf(Definitions.effects());
    Search search =
        new Search(given, excluded, worth, Optional.of(new SetupLeave(given, calibration)));
    search.offer(offered);
    return Inquiry.of(given, calibration, worth, search);
  }

  /** What is concluded, of which set, or of what of it is sure, with the places of its gap. */
  private record Told(
      Weighed weighed,
      boolean isSure,
      List<Place> where,
      double unknown,
      Map<String, Double> signs,
      Conclusion conclusion) {}

  /** Where nothing fits best and yet something is at work, an effect may be that all the same. */
  private static Told conclude(Inquiry inquiry) {
    Told told = told(inquiry);
    return told.unknown > 0.5
        ? inquiry
            .some()
            .map(Diagnoser::told)
            .filter(some -> some.unknown <= 0.5 && some.conclusion.verdict() != Verdict.UNEXPLAINED)
            .orElse(told)
        : told;
  }

  private static Told told(Inquiry inquiry) {
    CalibratedLog given = inquiry.given();
    Calibration calibration = inquiry.calibration;
    Blocks blocks = new Blocks(given.log());
    Hypothesis best = inquiry.best();
    CalibratedLog open = calibration.opened(given, best);
    Weighed whole = inquiry.weighed.beside(given, open);
    Signs signs = Unknown.signs(given, open, calibration, whole.gain(), best);
    Conclusion.Unnamed unnamed = unnamed(inquiry, signs);
    double unknown = unnamed.probability();
    double tieNats = TIE_NATS * calibration.clumping();
    Places places = places(given, whole, blocks);
    List<Place> doubtful = doubtful(places, whole, open);
    Conclusion all = Conclusion.of(whole, unnamed, doubtful, blocks, tieNats);
    Conclusion first =
        withUnseen(inquiry, whole, given.log().echoes() == 0 ? all.ofSilence() : all);
    double stated =
        first.verdict() == Verdict.UNEXPLAINED || first.verdict() == Verdict.PARTLY
            ? Constants.own().under(calibration.model()).besideARest(unknown)
            : unknown;
    return sure(inquiry, first, whole)
        .flatMap(
            part ->
                first
                    .partly(effects(part), whole, unnamed, tieNats)
                    .map(
                        told ->
                            new Told(
                                part,
                                true,
                                places(given, part, blocks).thatStandOut(),
                                stated,
                                unnamed.signs(),
                                told)))
        .orElseGet(
            () -> new Told(whole, false, places.thatStandOut(), stated, unnamed.signs(), first));
  }

  /** What makes the readings plainly likelier beside all of it is said. */
  private static Conclusion withUnseen(Inquiry inquiry, Weighed whole, Conclusion concluded) {
    return whole
        .unseen(inquiry.given(), inquiry.sets, inquiry.worthNats, inquiry.calibration.clumping())
        .map(concluded::beside)
        .orElse(concluded);
  }

  /** What is sure where all of it is not. */
  private static Optional<Weighed> sure(Inquiry inquiry, Conclusion concluded, Weighed whole) {
    boolean isOpen = concluded.verdict() == Verdict.UNEXPLAINED || isTied(concluded, whole);
    return inquiry.given().log().echoes() > 0 && isOpen
        ? whole
            .confirmed(inquiry.gains, inquiry.sets, inquiry.worthNats)
            .map(part -> beside(inquiry.calibration, inquiry.given(), part))
        : Optional.empty();
  }

  private static Set<Effect> effects(Weighed weighed) {
    return Set.copyOf(weighed.taken().hypothesis().effects());
  }

  /** What no effect does, as signs show it, and under the level law how likely it is itself. */
  private static Conclusion.Unnamed unnamed(Inquiry inquiry, Signs signs) {
    Calibration calibration = inquiry.calibration;
    CalibratedLog given = inquiry.given();
    Map<String, Double> all = new LinkedHashMap<>(signs.byName());
    String what = "";
    if (calibration.model() == SensorLaw.Model.LEVEL) {
      Strangers.Found found =
          new Strangers(given, new SetupLeave(given, calibration))
              .against(inquiry.best(), inquiry.worthNats, calibration.temperature());
      all.put(LevelConstants.STRANGERS_ODDS, found.odds());
      what = found.what();
    }
    double unknown = Constants.own().under(calibration.model()).unknown(all);
    if (what.isEmpty() && unknown > 0.5) {
      what = Unknown.standsIn(given, inquiry.best());
    }
    return new Conclusion.Unnamed(unknown, all, what);
  }

  private static Weighed beside(Calibration calibration, CalibratedLog given, Weighed part) {
    CalibratedLog open = calibration.opened(given, part.taken().hypothesis());
    return part.beside(given, open);
  }

  /**
   * Places that would make "none" doubtful, all of the log being one as well: of those that the
   * set-up leaves open none does.
   */
  private static List<Place> doubtful(Places places, Weighed weighed, CalibratedLog open) {
    List<Place> said = places.anywhere();
    if (!weighed.taken().hypothesis().forms().isEmpty() || said.isEmpty()) {
      return said;
    }
    GapMeter.Gaps gaps = weighed.gain().open();
    return Places.find(open, gaps, gaps, new Blocks(open.log())).anywhere();
  }

  /** Undecided between names, not for want of readings. */
  private static boolean isTied(Conclusion conclusion, Weighed weighed) {
    return conclusion.verdict() == Verdict.UNDECIDED
        && !weighed.taken().hypothesis().forms().isEmpty();
  }

  private static Places places(CalibratedLog given, Weighed weighed, Blocks blocks) {
    return Places.find(given, weighed.gain().before(), weighed.gain().after(), blocks);
  }

  private Diagnosis diagnosis(Inquiry inquiry, Told told) {
    CalibratedLog given = inquiry.given();
    double clumping = inquiry.calibration.clumping();
    Blocks blocks = new Blocks(given.log());
    List<Scored> sets = inquiry.sets;
    Weighed weighed = told.weighed;
    Verdict verdict = told.conclusion.verdict();
    Hypothesis best = weighed.taken().hypothesis();
    // What stands beside a set that is whole is another thing, and speaks not against its names.
    double against = verdict == Verdict.PARTLY && !told.isSure ? 0 : told.unknown;
    SensorLaw.Model law = inquiry.calibration.model();
    return new Diagnosis(
        verdict,
        told.conclusion.reason(),
        best.effects(),
        new EffectFindings(given, sets, weighed, against, law, clumping, told.isSure).all(),
        told.unknown,
        1 - weighed.probabilities().ofNone(),
        told.conclusion.atBound(),
        figures(weighed.gain(), blocks),
        Budget.of(given, blocks, best, weighed.gain(), seed),
        told.where,
        Undetectables.of(given, best, Probabilities.COST_NATS * clumping),
        nextExperiment(given, sets, weighed, clumping),
        best,
        inquiry.calibration.setup(),
        attempts(sets, weighed.probabilities(), Constants.own().under(law).temperature()),
        told.signs,
        inquiry.calibration.modelError().map(ModelError::finding),
        List.of());
  }

  /** For the first tie: what would tell the two apart. */
  private static Optional<NextExperiment> nextExperiment(
      CalibratedLog given, List<Scored> sets, Weighed weighed, double clumping) {
    Hypothesis best = weighed.taken().hypothesis();
    for (Effect effect : best.effects()) {
      for (Effect other : weighed.tiesOf(effect, TIE_NATS * clumping)) {
        List<Effect> rival = new ArrayList<>(best.without(effect).effects());
        rival.add(other);
        Optional<Hypothesis> found =
            sets.stream()
                .map(Scored::hypothesis)
                .filter(set -> Set.copyOf(set.effects()).equals(Set.copyOf(rival)))
                .findFirst();
        if (found.isPresent()) {
          return Experiments.separate(given, best, found.get());
        }
      }
    }
    return Optional.empty();
  }

  /** One block alone says nothing of another log. */
  private GapFigures figures(GapGain gain, Blocks blocks) {
    Interval shrink =
        blocks.canBeHeldOut()
            ? gain.shrinkage95(blocks, seed)
            : new Interval(Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY);
    return new GapFigures(
        gain.before().observedM().length,
        100 * gain.beforeM(),
        100 * gain.afterM(),
        100 * gain.floorM(),
        gain.shrinkage(),
        shrink);
  }

  private static List<Diagnosis.Attempt> attempts(
      List<Scored> sets, Probabilities probabilities, double temperature) {
    double nominal =
        sets.stream()
            .filter(set -> set.hypothesis().forms().isEmpty())
            .mapToDouble(Scored::heldOut)
            .findFirst()
            .orElse(0);
    return sets.stream()
        .map(
            set ->
                new Diagnosis.Attempt(
                    set.hypothesis().effects(),
                    set.heldOut() - nominal,
                    temperature * probabilities.behind(set)))
        .toList();
  }
}
