package simbad.gap.place;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import simbad.gap.diagnosis.NextExperiment;
import simbad.gap.fit.Evidence;
import simbad.gap.fit.Hypothesis;
import simbad.sonar.effect.DiagnosedModel;
import simbad.sonar.effect.Effect;
import simbad.sonar.effect.PingLog;
import simbad.sonar.model.ReadingDistribution;
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

  private static final String ONLY = "only:";

  private final Evidence evidence;
  private final Hypothesis one;
  private final Hypothesis other;

  private Experiments(Evidence evidence, Hypothesis one, Hypothesis other) {
    this.evidence = evidence;
    this.one = one;
    this.other = other;
  }

  /** A manoeuvre as one sensor drives it, with what it is expected to bring. */
  private record Trial(Manoeuvre manoeuvre, String sensor, Divergence.Nats nats) {}

  /**
   * Chooses.
   *
   * @param evidence the log that both explain
   * @param one a hypothesis with its values
   * @param other a hypothesis with its values
   * @return at most 150 poses; empty where no listed manoeuvre brings more than 1 nat
   */
  public static Optional<NextExperiment> separate(
      Evidence evidence, Hypothesis one, Hypothesis other) {
    return new Experiments(evidence, one, other).best();
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
            .filter(evidence.log().sensors()::contains)
            .distinct()
            .toList();
    return named.isEmpty()
        ? evidence.log().sensors().stream().findFirst().map(List::of).orElse(List.of("sonar"))
        : named;
  }

  private List<Trial> trials() {
    List<Manoeuvre> manoeuvres = Manoeuvres.before(evidence.setup());
    return sensors().stream().flatMap(sensor -> trials(manoeuvres, sensor).stream()).toList();
  }

  /** All manoeuvres as the runs of one log. */
  private List<Trial> trials(List<Manoeuvre> manoeuvres, String sensor) {
    List<ReadingRow> rows = new ArrayList<>();
    for (int i = 0; i < manoeuvres.size(); i++) {
      rows.addAll(manoeuvres.get(i).rows("m" + i, sensor));
    }
    PingLog log = new PingLog(rows);
    List<ReadingDistribution> ones = forecast(log, one);
    List<ReadingDistribution> others = forecast(log, other);
    Divergence divergence = new Divergence(evidence.setup());
    Divergence.Nats[] nats =
        IntStream.range(0, log.size())
            .parallel()
            .mapToObj(ping -> divergence.between(ones.get(ping), others.get(ping)))
            .toArray(Divergence.Nats[]::new);
    List<Trial> trials = new ArrayList<>();
    for (int i = 0; i < manoeuvres.size(); i++) {
      Divergence.Nats sum = Divergence.Nats.NONE;
      for (int ping = i * Manoeuvres.PINGS; ping < (i + 1) * Manoeuvres.PINGS; ping++) {
        sum = sum.plus(nats[ping]);
      }
      trials.add(new Trial(manoeuvres.get(i), sensor, sum));
    }
    return trials;
  }

  private List<ReadingDistribution> forecast(PingLog log, Hypothesis hypothesis) {
    DiagnosedModel model = evidence.model(hypothesis);
    return model.forecast(model.geometry(log));
  }
}
