package simbad.blindworld.score;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import simbad.blindworld.check.Checks;
import simbad.blindworld.world.Forecast;

/**
 * What a diagnosis says of a case.
 *
 * @param verdict its verdict
 * @param explanation the effects concluded to be at work
 * @param effects every effect, most probable first
 * @param unknownProbability that something outside the vocabulary is at work
 * @param verdictProbability of each verdict, where the diagnosis states them
 * @param shrink the claimed shrinkage, where stated
 * @param forecast of the sealed rows, where given
 * @param motionGap of its forecast of sealed windows of motion, in units of the nominal one
 */
public record Answer(
    Verdict verdict,
    List<String> explanation,
    List<Named> effects,
    double unknownProbability,
    Optional<Map<Verdict, Double>> verdictProbability,
    Optional<Shrink> shrink,
    Optional<Forecast> forecast,
    Optional<Double> motionGap) {

  /**
   * One effect.
   *
   * @param name from the vocabulary
   * @param probability that it is at work
   * @param ties what these data cannot tell from it
   */
  public record Named(String name, double probability, List<String> ties) {
    /** Refuses what is no such thing. */
    public Named {
      Checks.share("probability", probability);
    }
  }

  /** A shrinkage with its 95 % interval. */
  public record Shrink(double value, double low, double high) {
    /** Refuses what is no such thing. */
    public Shrink {
      Checks.number("shrinkage", value);
      Checks.number("shrinkage, low", low);
      Checks.number("shrinkage, high", high);
    }
  }

  /** Copies the lists. */
  public Answer {
    Checks.share("probability of the unknown", unknownProbability);
    Checks.number("gap", motionGap);
    explanation = List.copyOf(explanation);
    effects = List.copyOf(effects);
  }

  /** An answer to readings. */
  public Answer(
      Verdict verdict,
      List<String> explanation,
      List<Named> effects,
      double unknownProbability,
      Optional<Map<Verdict, Double>> verdictProbability,
      Optional<Shrink> shrink,
      Optional<Forecast> forecast) {
    this(
        verdict,
        explanation,
        effects,
        unknownProbability,
        verdictProbability,
        shrink,
        forecast,
        Optional.empty());
  }

  /** True when it comes with predictions. */
  public boolean predicts() {
    return forecast.isPresent() || motionGap.isPresent();
  }

  /** The name and what is said to be tied with it. */
  public Set<String> tieOf(String name) {
    Set<String> tie = new LinkedHashSet<>();
    tie.add(name);
    effects.stream().filter(e -> e.name().equals(name)).forEach(e -> tie.addAll(e.ties()));
    return tie;
  }

  /** All that is concluded, with ties. */
  public Set<String> namedWithTies() {
    Set<String> all = new LinkedHashSet<>();
    explanation.forEach(name -> all.addAll(tieOf(name)));
    return all;
  }

  /** The probability of an effect; 0 for one that is not listed. */
  public double probabilityOf(String name) {
    return effects.stream()
        .filter(e -> e.name().equals(name))
        .mapToDouble(Named::probability)
        .findFirst()
        .orElse(0);
  }

  /**
   * The probability of a verdict: as stated, or else from that of the unknown and of the most
   * probable effect. "Partly" says as "unexplained" does that something without a name is at work.
   */
  public double probabilityOf(Verdict which) {
    if (which == Verdict.PARTLY) {
      return probabilityOf(Verdict.UNEXPLAINED);
    }
    if (verdictProbability.isPresent()) {
      return verdictProbability.get().getOrDefault(which, 0.0);
    }
    double any = effects.isEmpty() ? 0 : effects.get(0).probability();
    return switch (which) {
      case UNEXPLAINED -> unknownProbability;
      case EXPLAINED -> (1 - unknownProbability) * any;
      case NONE -> (1 - unknownProbability) * (1 - any);
      case UNDECIDED, PARTLY -> 0;
    };
  }
}
