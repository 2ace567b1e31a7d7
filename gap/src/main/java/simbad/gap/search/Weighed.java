package simbad.gap.search;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import simbad.definition.Effect;
import simbad.definition.Trait;
import simbad.gap.fit.CalibratedLog;
import simbad.gap.fit.Hypothesis;
import simbad.gap.fit.Placements;
import simbad.gap.score.GapGain;
import simbad.gap.score.GapGains;
import simbad.gap.score.GapMeter;
import simbad.gap.score.HeldOut.Scored;
import simbad.gap.score.PracticalSize;
import simbad.gap.score.Probabilities;
import simbad.gap.unexplained.Unknown;
import simbad.sonar.check.Checks;
import simbad.sonar.effect.Definitions;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SonarSpec;

/**
 * Sets of effects weighed against each other. A set that makes the gap of rows larger that it was
 * not fitted on explains nothing, however much likelier it makes them, nor does one that leaves the
 * gap as it was: the next one takes its place.
 *
 * @param probabilities of the sets that are left
 * @param taken the set that is concluded upon: the most probable one, or what of it is sure
 * @param gain of that set
 * @param enlarging sets that would have been taken, but for the gap that they enlarge
 */
public record Weighed(
    Probabilities probabilities, Scored taken, GapGain gain, List<Scored> enlarging) {
  /** A set that takes away so much of the gap does the work. */
  private static final double MOST = 0.5;

  /**
   * In 62 logs with nothing changed one had an effect that gained so much, and was undecided anyway
   * (docs/method/measurements.md).
   */
  private static final double PLAINLY = 2;

  /**
   * What placements are off by makes readings scatter. Whatever else befalls single readings does
   * not hang together by placements.
   */
  private static final Set<Effect> MISPLACES = Definitions.with(Trait.MISPLACES);

  private static final Set<Effect> SCATTERS = Definitions.with(Trait.BESIDE_THE_LAW);

  /** What takes up a little of anything, beside those that soak up where things were placed. */
  private static final Set<Effect> SOAK_UP = new TreeSet<>(PlainFamily.SOAK_UP_PLACEMENTS);

  /**
   * What moves or turns something: where it does most of the work alone, it does more than
   * placements are off by.
   */
  private static final Set<Effect> MOVES_THINGS = new TreeSet<>(PlainFamily.SOAK_UP_PLACEMENTS);

  /** A reading is right where its gap is at most so many times what the model expects of it. */
  private static final double RIGHT = 3;

  private static final double LEAST_RIGHT = 2.0 / 3;

  static {
    MOVES_THINGS.removeAll(Unknown.SOAK);
    SOAK_UP.addAll(Unknown.SOAK);
    SOAK_UP.addAll(Definitions.with(Trait.SOAKS_UP_A_REST));
  }

  /** Copies the list. */
  public Weighed {
    enlarging = List.copyOf(enlarging);
  }

  /**
   * Weighs sets, the nominal model among them.
   *
   * @param gains of the log
   * @param sets that were fitted
   * @param worthNats what a further effect must gain to be as probable as its absence
   * @param temperature by which nats are divided
   */
  public static Weighed of(
      GapGains gains, List<Scored> sets, double worthNats, double temperature) {
    return of(gains, sets, sets, worthNats, temperature);
  }

  /**
   * Weighs sets where something is at work for sure: "none" is no answer any more, so that an
   * effect has to outweigh other effects alone. What shows little in the gap counts as the others
   * do, but for what takes up a little of anything.
   *
   * @param gains of the log
   * @param sets that were fitted
   * @param worthNats what a further effect must gain to be as probable as its absence
   * @param temperature by which nats are divided
   * @return empty where no set is half as much likelier than none as an effect has to be
   */
  public static Optional<Weighed> ofSome(
      GapGains gains, List<Scored> sets, double worthNats, double temperature) {
    double least =
        worthNats / 2
            + sets.stream()
                .filter(set -> set.hypothesis().forms().isEmpty())
                .mapToDouble(Scored::heldOut)
                .max()
                .orElse(0);
    List<Scored> some =
        sets.stream()
            .filter(set -> !set.hypothesis().forms().isEmpty() && set.heldOut() > least)
            // What outdoes a set at an end of the search may itself say too little to be here.
            .filter(set -> !isOutdone(set, sets, worthNats))
            .toList();
    return some.isEmpty()
        ? Optional.empty()
        : Optional.of(of(gains, sets, some, worthNats, temperature))
            .filter(weighed -> weighed.gain.isWorthNaming());
  }

  private static Weighed of(
      GapGains gains,
      List<Scored> sets,
      List<Scored> candidates,
      double worthNats,
      double temperature) {
    Checks.number("worthNats", worthNats);
    Checks.positive("temperature", temperature);
    CalibratedLog given = gains.given();
    PracticalSize size = new PracticalSize(gains, sets);
    double most = (1 + Probabilities.UNSEEN) * worthNats;
    Set<Effect> unseen = soakedUpByPlacements(gains, sets);
    Map<Effect, Set<Effect>> twins = Gates.twins(given);
    Function<Hypothesis, Set<Effect>> invited = Gates.invited(given);
    List<Scored> left = new ArrayList<>(candidates);
    left.removeIf(set -> isOutdone(set, sets, worthNats));
    boolean canBeNone = left.stream().anyMatch(set -> set.hypothesis().forms().isEmpty());
    List<Scored> enlarging = new ArrayList<>();
    while (true) {
      Probabilities probabilities =
          new Probabilities(left, worthNats, temperature, unseen, invited, twins);
      Scored best = probabilities.best();
      Set<Effect> little = size.unseen(best, most);
      // What is to be expected may be there though it does not show in the gap.
      little.removeAll(invited.apply(best.hypothesis()));
      if (!canBeNone) {
        little.retainAll(SOAK_UP);
      }
      if (unseen.addAll(little)) {
        continue;
      }
      GapGain gain = gains.of(best.hypothesis());
      if (best.hypothesis().forms().isEmpty() || gain.isWorthNaming() || left.size() == 1) {
        return new Weighed(probabilities, best, gain, enlarging);
      }
      left.remove(best);
      if (gain.afterM() > gain.beforeM()) {
        enlarging.add(best);
      }
    }
  }

  /** What has to gain more than others where things were put in place. */
  private static Set<Effect> soakedUpByPlacements(GapGains gains, List<Scored> sets) {
    Set<Effect> asked = new TreeSet<>();
    if (new Placements(gains.given().log()).areRepeated()) {
      asked.addAll(PlainFamily.SOAK_UP_PLACEMENTS);
      if (isBeyondPlacements(gains, sets)) {
        asked.removeAll(MOVES_THINGS);
      }
    }
    return asked;
  }

  /**
   * Whether what predicts best without moving anything leaves more than placements are off by, so
   * that what moves something does not just take up where things were put. What the simulator
   * expects of scatter is the floor here: an effect may expect any scatter of its own.
   */
  private static boolean isBeyondPlacements(GapGains gains, List<Scored> sets) {
    double floorM = gains.of(Hypothesis.NONE).floorM();
    return sets.stream()
        .filter(Weighed::movesNothing)
        .max(Comparator.comparingDouble(Scored::heldOut))
        .filter(set -> gains.of(set.hypothesis()).afterM() - floorM > Placements.MOST_OFF_M)
        .isPresent();
  }

  private static boolean movesNothing(Scored set) {
    return set.hypothesis().effects().stream().noneMatch(PlainFamily.SOAK_UP_PLACEMENTS::contains);
  }

  /** At an end of the search, while a set that is not says nearly as much. */
  private static boolean isOutdone(Scored one, List<Scored> sets, double worthNats) {
    return one.hypothesis().isAtBound()
        && sets.stream()
            .filter(set -> !set.hypothesis().forms().isEmpty())
            .filter(set -> !set.hypothesis().isAtBound())
            .anyMatch(set -> set.heldOut() > one.heldOut() - worthNats);
  }

  /**
   * Returns the same with a gain that knows what is left before a set-up which has moved.
   *
   * @param given the log
   * @param open the same before a set-up that has moved as far as its reference leaves open
   */
  public Weighed beside(CalibratedLog given, CalibratedLog open) {
    if (open == given) {
      return this;
    }
    return new Weighed(
        probabilities,
        taken,
        gain.beside(new GapGains(open).of(taken.hypothesis()).after()),
        enlarging);
  }

  /**
   * An effect beside the set that is concluded upon, which does not show in the gap.
   *
   * @param effect one that takes up a little of anything
   * @param nats by how much likelier it makes readings that it was not fitted on
   */
  public record Unseen(Effect effect, double nats) {
    /** Refuses what is no number. */
    public Unseen {
      Checks.number("nats", nats);
    }
  }

  /**
   * Returns what makes the readings plainly likelier beside the set that is concluded upon, and yet
   * is not named, since the quantiles of a forecast, and so the gap, see nothing of what befalls
   * one reading in twenty. That is asked of what befalls readings wherever they are. Empty where
   * there is no such effect.
   *
   * @param given the log
   * @param sets that were fitted
   * @param worthNats what a further effect must gain to be as probable as its absence
   * @param clumping by how much readings hang together, counted in it
   */
  public Optional<Unseen> unseen(
      CalibratedLog given, List<Scored> sets, double worthNats, double clumping) {
    Set<Effect> own = Set.copyOf(taken.hypothesis().effects());
    // A placement that is far off befalls all of its readings.
    boolean isPlaced =
        new Placements(given.log()).areRepeated()
            && own.stream().noneMatch(MISPLACES::contains)
            && !areScatteredMost(given.setup());
    return Unknown.SOAK.stream()
        .filter(effect -> !own.contains(effect))
        .filter(effect -> !PlainFamily.SOAK_UP_PLACEMENTS.contains(effect))
        .flatMap(effect -> unseen(effect, own, sets))
        .filter(
            unseen -> {
              boolean single = isPlaced && !SCATTERS.contains(unseen.effect);
              return unseen.nats > PLAINLY * worthNats / (single ? clumping : 1);
            })
        .max(Comparator.comparingDouble(Unseen::nats));
  }

  /** By what the set-up says of places, more than by the sensor. */
  private static boolean areScatteredMost(SensingSetup setup) {
    SonarSpec sensor = setup.sensor();
    return setup.details().poseSigmaM() > Math.max(sensor.rangeNoiseM(), sensor.resolutionM());
  }

  private Stream<Unseen> unseen(Effect effect, Set<Effect> own, List<Scored> sets) {
    Set<Effect> more = new TreeSet<>(own);
    more.add(effect);
    return sets.stream()
        .filter(set -> Set.copyOf(set.hypothesis().effects()).equals(more))
        .map(set -> new Unseen(effect, set.heldOut() - taken.heldOut()));
  }

  /** Returns the ties of an effect of the set that is concluded upon: what could stand for it. */
  public List<Effect> tiesOf(Effect effect, double nats) {
    return probabilities.tiesOf(effect, taken, nats);
  }

  /**
   * Returns what is sure beside a rest that no effect explains, with its own gain; empty if nothing
   * is, or if it leaves the gap as it was.
   *
   * @param gains of the log
   * @param sets that were fitted
   * @param worthNats what a further effect must gain to be as probable as its absence
   */
  public Optional<Weighed> confirmed(GapGains gains, List<Scored> sets, double worthNats) {
    boolean isPlaced = new Placements(gains.given().log()).areRepeated();
    // Two others could stand for it, whatever the log reads.
    boolean tied = Gates.twins(gains.given()).values().stream().anyMatch(one -> one.size() > 1);
    Set<Effect> doubtful = new TreeSet<>(SOAK_UP);
    doubtful.addAll(tied ? Definitions.with(Trait.MOVES_RANGES) : Set.of());
    Function<Hypothesis, Set<Effect>> invited = Gates.invited(gains.given());
    boolean isDone = gain.shrinkage() >= MOST || tied;
    taken.hypothesis().effects().stream()
        .filter(MOVES_THINGS::contains)
        .filter(effect -> doesMostAlone(effect, gains, sets))
        .forEach(doubtful::remove);
    Optional<Weighed> sure =
        sure(gains, new Confirmed(sets, doubtful, invited, worthNats, isPlaced, isDone));
    if (isPlaced && sure.filter(some -> some.isOfFewEchoes(gains.given().log())).isPresent()) {
      doubtful.addAll(Confirmed.MOVING);
      return sure(gains, new Confirmed(sets, doubtful, invited, worthNats, true, isDone));
    }
    return sure;
  }

  private Optional<Weighed> sure(GapGains gains, Confirmed confirmed) {
    return confirmed
        .best()
        .map(sure -> new Weighed(probabilities, sure, gains.of(sure.hypothesis()), enlarging))
        .filter(sure -> sure.gain.isWorthNaming());
  }

  /**
   * Whether it moves all ranges, and yet a third of the echoes or more are no such ranges: then
   * these follow something else, of which it takes up a little.
   */
  private boolean isOfFewEchoes(PingLog log) {
    GapMeter.Gaps after = gain.after();
    int[] echoes = IntStream.range(0, log.size()).filter(log::echo).toArray();
    long right =
        IntStream.of(echoes)
            .filter(ping -> after.observedM()[ping] <= RIGHT * after.expectedM()[ping])
            .count();
    return taken.hypothesis().effects().stream().anyMatch(Confirmed.MOVING::contains)
        && right < LEAST_RIGHT * echoes.length;
  }

  private static boolean doesMostAlone(Effect effect, GapGains gains, List<Scored> sets) {
    return sets.stream()
        .map(Scored::hypothesis)
        .filter(set -> set.effects().equals(List.of(effect)))
        .anyMatch(alone -> gains.of(alone).shrinkage() >= MOST);
  }
}
