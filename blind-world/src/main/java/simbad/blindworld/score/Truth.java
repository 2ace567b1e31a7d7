package simbad.blindworld.score;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import simbad.blindworld.check.Checks;

/**
 * What was at work in a case.
 *
 * @param id the case
 * @param effects the names put in
 * @param strange those of them that the diagnosis has no name for
 * @param reference whether a reference came with it
 * @param countedM the sealed rows' readings, no-echo counted
 * @param nominalCm the nominal gap on the sealed rows, where known
 * @param oracleCm the true world's gap on the sealed rows, where known
 * @param accept the sets of names by which all that is at work may be called
 * @param z by how many standard errors the least plain effect shows, where known
 * @param size of the one effect that was put in, in practical sizes, where there is one
 * @param motion the sealed windows, of a case of motion, whose gaps are in units of the nominal one
 */
public record Truth(
    String id,
    List<String> effects,
    Set<String> strange,
    boolean reference,
    List<Double> countedM,
    Optional<Double> nominalCm,
    Optional<Double> oracleCm,
    List<Set<String>> accept,
    Optional<Double> z,
    Optional<Double> size,
    Optional<MotionSealed> motion) {

  private static final double LEAST_REMOVAL_CM = 0.5;

  /** Of the nominal gap of motion. */
  private static final double LEAST_REMOVAL_SHARE = 0.05;

  /** What shows less plainly is asked of nobody, and scored by itself. */
  private static final double PLAIN = 5;

  /** Copies the collections. */
  public Truth {
    Checks.number("nominal gap", nominalCm);
    Checks.number("oracle's gap", oracleCm);
    Checks.number("standard errors", z);
    Checks.number("size", size);
    effects = List.copyOf(effects);
    strange = Set.copyOf(strange);
    countedM = Checks.numbers("readings", countedM);
    accept = List.copyOf(accept);
  }

  /** A truth that may be called by its own names only; what is strange has none. */
  public Truth(
      String id,
      List<String> effects,
      Set<String> strange,
      boolean reference,
      List<Double> countedM,
      Optional<Double> nominalCm,
      Optional<Double> oracleCm) {
    this(
        id,
        effects,
        strange,
        reference,
        countedM,
        nominalCm,
        oracleCm,
        strange.isEmpty() ? List.of(Set.copyOf(effects)) : List.of(),
        Optional.empty());
  }

  /** A truth of readings. */
  public Truth(
      String id,
      List<String> effects,
      Set<String> strange,
      boolean reference,
      List<Double> countedM,
      Optional<Double> nominalCm,
      Optional<Double> oracleCm,
      List<Set<String>> accept,
      Optional<Double> z) {
    this(
        id,
        effects,
        strange,
        reference,
        countedM,
        nominalCm,
        oracleCm,
        accept,
        z,
        Optional.empty(),
        Optional.empty());
  }

  /** True for a name that may stand for something that is at work. */
  public boolean mayBeCalled(String name) {
    return effects.contains(name) || accept.stream().anyMatch(names -> names.contains(name));
  }

  /** The verdict that is right. */
  public Verdict verdict() {
    if (!strange.isEmpty()) {
      return Verdict.UNEXPLAINED;
    }
    return effects.isEmpty() ? Verdict.NONE : Verdict.EXPLAINED;
  }

  /** True when an effect is at work that hardly shows, as where all sizes are drawn. */
  public boolean isFaint() {
    return !effects.isEmpty() && z.isPresent() && z.get() < PLAIN;
  }

  /** True when something is at work that the diagnosis has no name for. */
  public boolean isStrange() {
    return !strange.isEmpty();
  }

  /**
   * What the case asks: none, single, pair (two or more), outside (of the vocabulary), withheld (of
   * it, but the diagnosis was not told), or faint (any of these that hardly shows).
   */
  public String kind() {
    if (isFaint()) {
      return "faint";
    }
    if (!strange.isEmpty()) {
      return strange.stream().allMatch(Names::contains) ? "withheld" : "outside";
    }
    return effects.isEmpty() ? "none" : effects.size() == 1 ? "single" : "pair";
  }

  /**
   * True when the true world's forecast removes half a centimetre of the nominal gap or more, of
   * motion a twentieth.
   */
  public boolean hasGap() {
    return nominalCm.isPresent()
        && oracleCm.isPresent()
        && nominalCm.get() - oracleCm.get()
            >= (motion.isPresent() ? LEAST_REMOVAL_SHARE : LEAST_REMOVAL_CM);
  }
}
