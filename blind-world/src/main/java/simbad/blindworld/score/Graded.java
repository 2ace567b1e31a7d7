package simbad.blindworld.score;

import java.util.Collection;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * A truth with the answer to it; no answer is wrong in every respect.
 *
 * @param truth what was at work
 * @param answer what the diagnosis says
 */
public record Graded(Truth truth, Optional<Answer> answer) {

  private static final int LARGEST_TIE = 2;

  /** True when there is an answer with this verdict. */
  public boolean says(Verdict verdict) {
    return answer.isPresent() && answer.get().verdict() == verdict;
  }

  /** True when something is said to be at work that has no name. */
  public boolean leavesSomething() {
    return says(Verdict.UNEXPLAINED) || says(Verdict.PARTLY);
  }

  /** True when the verdict is the right one; what has no name may stand beside names. */
  public boolean verdictRight() {
    return truth.isStrange() ? leavesSomething() || explainedAsAccepted() : says(truth.verdict());
  }

  /** True when names are concluded to be all that is at work, and they are not. */
  public boolean wronglyExplained() {
    return says(Verdict.EXPLAINED) && (truth.isStrange() ? !accepted() : !named());
  }

  /** True when the names concluded are one of the sets that the truth accepts. */
  private boolean accepted() {
    return answer.isPresent() && truth.accept().contains(new HashSet<>(answer.get().explanation()));
  }

  private boolean explainedAsAccepted() {
    return says(Verdict.EXPLAINED) && accepted();
  }

  /** How an answer stands before the truth. */
  public enum Standing {
    /** It says what is so. */
    RIGHT,
    /** It says less than is so, and nothing that is not. */
    CAUTIOUS,
    /** It says what is not so, or nothing. */
    WRONG
  }

  /** By the format's table of verdicts; no answer is wrong. */
  public Standing standing() {
    if (right()) {
      return withKnown() ? Standing.RIGHT : Standing.CAUTIOUS;
    }
    boolean named = !truth.isStrange() && !truth.effects().isEmpty();
    boolean cautious = says(Verdict.UNDECIDED) || (named && leavesSomething() && holdsTheNames());
    return cautious ? Standing.CAUTIOUS : Standing.WRONG;
  }

  /** False where it says "partly" of a known effect beside something strange and leaves it out. */
  private boolean withKnown() {
    List<String> known =
        truth.effects().stream().filter(e -> !truth.strange().contains(e)).toList();
    return !truth.isStrange()
        || !says(Verdict.PARTLY)
        || known.isEmpty()
        || known.stream()
            .allMatch(e -> answer.orElseThrow().explanation().stream().anyMatch(n -> covers(n, e)));
  }

  /** True when the names that the truth accepts are among those concluded. */
  private boolean holdsTheNames() {
    List<String> said = answer.map(Answer::explanation).orElse(List.of());
    return truth.accept().stream().anyMatch(said::containsAll)
        || truth.effects().stream().allMatch(e -> said.stream().anyMatch(n -> covers(n, e)));
  }

  /** True when the verdict is right and, but for what is strange, so are the names. */
  public boolean right() {
    return verdictRight() && (truth.isStrange() || named());
  }

  /**
   * The probability that the answer puts on what is so: on none, on something without a name, or on
   * all of the effects by the best of the sets of names that the truth accepts.
   */
  public double probabilityOfTruth() {
    if (answer.isEmpty()) {
      return 0;
    }
    Answer said = answer.get();
    if (truth.isStrange() || truth.effects().isEmpty()) {
      return said.probabilityOf(truth.verdict());
    }
    double own = together(said, truth.effects());
    double best =
        truth.accept().stream().mapToDouble(names -> together(said, names)).max().orElse(own);
    return (1 - said.unknownProbability()) * Math.max(own, best);
  }

  /** The least probable of the names; what is tied with one may stand for it. */
  private double together(Answer said, Collection<String> names) {
    return names.stream()
        .mapToDouble(
            name ->
                said.effects().stream()
                    .filter(e -> covers(e.name(), name))
                    .mapToDouble(Answer.Named::probability)
                    .max()
                    .orElse(0))
        .min()
        .orElse(0);
  }

  /** True when something is said to be at work. */
  public boolean detected() {
    return answer.isPresent() && !says(Verdict.NONE) && !says(Verdict.UNDECIDED);
  }

  /** True when the explanation is the truth's effects by their very names and no other. */
  public boolean namedExactly() {
    return answer.isPresent()
        && new HashSet<>(answer.get().explanation()).equals(new HashSet<>(truth.effects()));
  }

  /**
   * True when each name concluded stands for one true effect and each of them has one; a tie of two
   * may stand for either, and whatever set of names the truth accepts for all of them.
   */
  public boolean named() {
    return accepted()
        || (answer.isPresent()
            && answer.get().explanation().size() == truth.effects().size()
            && matches(truth.effects(), answer.get().explanation()));
  }

  /** Whether names can be dealt out to the effects, each once, by going through all ways. */
  private boolean matches(List<String> effects, List<String> names) {
    if (effects.isEmpty()) {
      return true;
    }
    String effect = effects.get(0);
    for (String name : names) {
      if (covers(name, effect)) {
        List<String> others = names.stream().filter(n -> !n.equals(name)).toList();
        if (matches(effects.subList(1, effects.size()), others)) {
          return true;
        }
      }
    }
    return false;
  }

  private boolean covers(String name, String effect) {
    Set<String> tie = answer.map(a -> a.tieOf(name)).orElse(Set.of());
    return name.equals(effect) || (tie.size() <= LARGEST_TIE && tie.contains(effect));
  }

  /** True when at least one of the true effects is among the names. */
  public boolean namedSome() {
    return answer.isPresent()
        && truth.effects().stream()
            .anyMatch(e -> answer.get().explanation().stream().anyMatch(n -> covers(n, e)));
  }

  /** True when what is named first acts at the stage of the true effect. */
  public boolean familyRight() {
    return answer.isPresent()
        && !answer.get().explanation().isEmpty()
        && Names.isSameStage(answer.get().explanation().get(0), truth.effects().get(0));
  }

  /**
   * The gap of the answer's forecast on the sealed rows, in centimetres; of motion, in units of the
   * nominal gap.
   */
  public Optional<Double> afterCm() {
    if (truth.motion().isPresent()) {
      return answer.flatMap(Answer::motionGap);
    }
    return answer
        .flatMap(Answer::forecast)
        .map(
            forecast ->
                forecast.gapCm(
                    truth.countedM().stream().mapToDouble(Double::doubleValue).toArray(), 0));
  }

  /** The shrinkage on the sealed rows: 1 - after / before. */
  public Optional<Double> sealedShrink() {
    return afterCm()
        .filter(after -> truth.nominalCm().orElse(0.0) > 0)
        .map(after -> 1 - after / truth.nominalCm().orElseThrow());
  }

  /**
   * What the answer's forecast removes of the nominal gap, as a share of what the truth's would.
   */
  public Optional<Double> shareOfRemoval() {
    if (!truth.hasGap()) {
      return Optional.empty();
    }
    double nominal = truth.nominalCm().orElseThrow();
    double whole = nominal - truth.oracleCm().orElseThrow();
    return afterCm().map(after -> (nominal - after) / whole);
  }

  /** What the answer says in a word: none, unexplained, the names, or no answer. */
  public String said() {
    if (answer.isEmpty()) {
      return "(no answer)";
    }
    return says(Verdict.EXPLAINED)
        ? String.join("+", answer.get().explanation().stream().sorted().toList())
        : answer.get().verdict().word();
  }
}
