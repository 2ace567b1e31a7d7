package simbad.gap.design;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import simbad.definition.Effect;
import simbad.gap.diagnosis.Undetectable;
import simbad.gap.fit.CalibratedLog;
import simbad.gap.fit.Fitter;
import simbad.gap.fit.Fold;
import simbad.gap.fit.Hypothesis;
import simbad.sonar.effect.Definitions;

/**
 * Tells which effects a log could not have shown: those that could be at work at a size that
 * matters in practice, beside what is explained, and leave the readings as probable as they are.
 */
public final class Undetectables {
  private final CalibratedLog given;
  private final Hypothesis explained;
  private final double nats;

  private Undetectables(CalibratedLog given, Hypothesis explained, double nats) {
    this.given = given;
    this.explained = explained;
    this.nats = nats;
  }

  /**
   * Looks at every effect that is not explained.
   *
   * @param given the log
   * @param explained what is at work
   * @param nats by which the log likelihood of the readings falls where an effect shows
   * @return in the order of the vocabulary; a least size is a departure from neutral, of a
   *     parameter that is infinite there its value
   */
  public static List<Undetectable> of(CalibratedLog given, Hypothesis explained, double nats) {
    Undetectables asked = new Undetectables(given, explained, nats);
    return Definitions.effects().stream()
        .filter(effect -> !explained.has(effect))
        .toList()
        .parallelStream()
        .map(asked::look)
        .flatMap(Optional::stream)
        .toList();
  }

  private Optional<Undetectable> look(Effect effect) {
    List<Showing> probes =
        Definitions.of(effect).probes(given.setup(), given.log()).stream()
            .map(Showing::new)
            .toList();
    Fitter fitter = new Fitter(given, Fold.ALL);
    double asItIs = fitter.logLikelihood(explained);
    Showing.Fall fall =
        added ->
            asItIs - fitter.logLikelihood(explained.and(added.forms().get(0), added.valuesOf(0)));
    if (probes.isEmpty() || probes.stream().anyMatch(probe -> probe.showsInPractice(fall, nats))) {
      return Optional.empty();
    }
    return Optional.of(
        probes.stream()
            .map(probe -> told(effect, probe, probe.leastSize(fall, nats)))
            .reduce(Undetectables::plainer)
            .orElseThrow());
  }

  private static Undetectable told(Effect effect, Showing probe, OptionalDouble leastSize) {
    return new Undetectable(effect, probe.parameter().name(), leastSize);
  }

  /** Of two parameters of one form, in one unit, the one that shows at the lesser size. */
  private static Undetectable plainer(Undetectable one, Undetectable other) {
    double size = one.leastSize().orElse(Double.POSITIVE_INFINITY);
    return other.leastSize().orElse(Double.POSITIVE_INFINITY) < size ? other : one;
  }
}
