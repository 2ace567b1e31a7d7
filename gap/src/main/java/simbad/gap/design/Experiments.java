package simbad.gap.design;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import simbad.definition.Effect;
import simbad.gap.diagnosis.NextExperiment;
import simbad.gap.fit.CalibratedLog;
import simbad.gap.fit.Hypothesis;
import simbad.sonar.model.ReadingDistribution;
import simbad.sonar.ping.PingLog;
import simbad.sonar.predict.ChangedModel;
import simbad.sonar.sensing.ReadingRow;

/**
 * Chooses what to measure next so that two hypotheses come apart: of a library of manoeuvres the
 * one or two that are expected to bring the greatest log odds, whichever of the two is true.
 *
 * <p>Readings are taken as independent given the hypothesis, which what hangs together from ping to
 * ping is not; the expectation is the greater for it where a hypothesis has memory.
 */
public final class Experiments {
  private static final double WORTH_NATS = 1;

  /** A second manoeuvre has to bring this share of the first's. */
  private static final double WORTH_SHARE = 0.1;

  /** Of all manoeuvres so many are looked at closely, by each of three merits. */
  private static final int SHORTLISTED = 8;

  private static final int GLANCE_PINGS = 5;
  private static final double GLANCE_STEP_M = 0.02;

  private static final String ONLY = "only:";

  private final CalibratedLog given;
  private final Hypothesis one;
  private final Hypothesis other;

  private Experiments(CalibratedLog given, Hypothesis one, Hypothesis other) {
    this.given = given;
    this.one = one;
    this.other = other;
  }

  /** A manoeuvre as one sensor drives it, with what it is expected to bring. */
  private record Trial(Manoeuvre manoeuvre, String sensor, Divergence.Nats nats) {}

  /**
   * Chooses.
   *
   * @param given the log that both explain
   * @param one a hypothesis with its values
   * @param other a hypothesis with its values
   * @return at most 150 poses; empty where no listed manoeuvre brings more than 1 nat
   */
  public static Optional<NextExperiment> separate(
      CalibratedLog given, Hypothesis one, Hypothesis other) {
    return new Experiments(given, one, other).best();
  }

  private Optional<NextExperiment> best() {
    List<Trial> trials = trials();
    Optional<Trial> first =
        trials.stream().max(Comparator.comparingDouble(trial -> trial.nats().least()));
    return first.flatMap(found -> told(found, beside(found, trials)));
  }

  private static Optional<Trial> beside(Trial first, List<Trial> trials) {
    return trials.stream()
        .filter(trial -> !trial.equals(first))
        .max(Comparator.comparingDouble(trial -> both(first, trial)))
        .filter(trial -> both(first, trial) > (1 + WORTH_SHARE) * first.nats().least());
  }

  private static double both(Trial first, Trial second) {
    return first.nats().plus(second.nats()).least();
  }

  private Optional<NextExperiment> told(Trial first, Optional<Trial> second) {
    double nats = second.map(trial -> both(first, trial)).orElse(first.nats().least());
    List<ReadingRow> poses = new ArrayList<>(first.manoeuvre().rows("next-1", first.sensor()));
    second.ifPresent(trial -> poses.addAll(trial.manoeuvre().rows("next-2", trial.sensor())));
    return nats > WORTH_NATS
        ? Optional.of(new NextExperiment(separated(), poses, nats))
        : Optional.empty();
  }

  /** The effects that only one of the two has; of two forms of the same effects, those. */
  private List<Effect> separated() {
    Set<Effect> apart = new HashSet<>(one.effects());
    Set<Effect> common = new HashSet<>(one.effects());
    common.retainAll(other.effects());
    apart.addAll(other.effects());
    if (apart.size() > common.size()) {
      apart.removeAll(common);
    }
    return apart.stream().sorted().toList();
  }

  /** Of a transducer that only one hypothesis speaks of; of any, where none is told apart. */
  private List<String> sensors() {
    List<String> named =
        Stream.concat(one.forms().stream(), other.forms().stream())
            .filter(form -> form.name().startsWith(ONLY))
            .map(form -> form.name().substring(ONLY.length()))
            .filter(given.log().sensors()::contains)
            .distinct()
            .toList();
    return named.isEmpty()
        ? given.log().sensors().stream().findFirst().map(List::of).orElse(List.of("sonar"))
        : named;
  }

  private List<Trial> trials() {
    List<Manoeuvre> manoeuvres = Manoeuvres.before(given.setup());
    return sensors().stream().flatMap(sensor -> trials(manoeuvres, sensor).stream()).toList();
  }

  /** All manoeuvres as the runs of one log. */
  private List<Trial> trials(List<Manoeuvre> manoeuvres, String sensor) {
    List<ReadingRow> rows = new ArrayList<>();
    for (int i = 0; i < manoeuvres.size(); i++) {
      rows.addAll(manoeuvres.get(i).rows(name(i), sensor));
    }
    PingLog log = new PingLog(rows);
    List<ReadingDistribution> ones = forecast(log, one);
    List<ReadingDistribution> others = forecast(log, other);
    Look glance =
        new Look(ones, others, new Divergence(given.setup(), GLANCE_STEP_M), GLANCE_PINGS);
    Look look = new Look(ones, others, new Divergence(given.setup()), 1);
    return shortlist(glance.all(manoeuvres.size())).stream()
        .map(i -> new Trial(manoeuvres.get(i), sensor, look.at(i)))
        .toList();
  }

  /** A log has its runs in their alphabet. */
  private static String name(int manoeuvre) {
    return String.format(Locale.ROOT, "m%06d", manoeuvre);
  }

  /** Those that look best by what they say for the one, for the other, and for both. */
  private static List<Integer> shortlist(List<Divergence.Nats> glances) {
    List<ToDoubleFunction<Divergence.Nats>> merits =
        List.of(Divergence.Nats::least, Divergence.Nats::forOne, Divergence.Nats::forOther);
    return merits.stream()
        .flatMap(
            merit ->
                IntStream.range(0, glances.size())
                    .boxed()
                    .sorted(Comparator.comparingDouble(i -> -merit.applyAsDouble(glances.get(i))))
                    .limit(SHORTLISTED))
        .distinct()
        .sorted()
        .toList();
  }

  /**
   * What manoeuvres are expected to bring.
   *
   * @param every how many pings one is looked at
   */
  private record Look(
      List<ReadingDistribution> ones,
      List<ReadingDistribution> others,
      Divergence divergence,
      int every) {
    List<Divergence.Nats> all(int manoeuvres) {
      return IntStream.range(0, manoeuvres).parallel().mapToObj(this::at).toList();
    }

    Divergence.Nats at(int manoeuvre) {
      Divergence.Nats sum = Divergence.Nats.NONE;
      int from = manoeuvre * Manoeuvres.PINGS;
      for (int ping = from; ping < from + Manoeuvres.PINGS; ping += every) {
        sum = sum.plus(divergence.between(ones.get(ping), others.get(ping)));
      }
      return sum;
    }
  }

  private List<ReadingDistribution> forecast(PingLog log, Hypothesis hypothesis) {
    ChangedModel model = given.model(hypothesis);
    return model.forecast(model.geometry(log));
  }
}
