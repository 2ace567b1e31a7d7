package simbad.blindworld.score;

import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;

/**
 * A case whose answer proposed what to measure, with the answer after that was measured.
 *
 * @param truth what was at work
 * @param proposal what was to be told apart
 * @param before the answer that proposed it
 * @param after the answer to the readings with those that were proposed; absent when there is none
 */
record Parted(Truth truth, Proposal proposal, Answer before, Optional<Answer> after) {

  /** What came of it. */
  enum Outcome {
    /** What is at work of the separated is named, and the others are neither named nor tied. */
    RIGHT,
    /** The verdict is undecided, or what is at work is still tied with another of the separated. */
    TIED,
    /** Something that is not at work is named for it, or nothing, or there is no answer. */
    WRONG;

    /** As files spell it. */
    String word() {
      return name().toLowerCase(Locale.ROOT);
    }
  }

  /** Those of the separated that are at work, or by which the truth may be called. */
  List<String> atWork() {
    return proposal.separates().stream().filter(truth::mayBeCalled).toList();
  }

  /** How the separated came apart, whatever else the answer says. */
  Outcome outcome() {
    if (after.isEmpty()) {
      return Outcome.WRONG;
    }
    if (after.get().verdict() == Verdict.UNDECIDED) {
      return Outcome.TIED;
    }
    List<String> named = concluded(after.get());
    Set<String> withTies = new HashSet<>();
    named.forEach(name -> withTies.addAll(after.get().tieOf(name)));
    List<String> atWork = atWork();
    Set<String> others = new HashSet<>(proposal.separates());
    others.removeAll(atWork);
    if (named.containsAll(atWork) && others.stream().noneMatch(withTies::contains)) {
      return Outcome.RIGHT;
    }
    boolean tied = named.stream().anyMatch(name -> among(after.get().tieOf(name)) >= 2);
    return tied && withTies.containsAll(atWork) ? Outcome.TIED : Outcome.WRONG;
  }

  /** Names are concluded by these two verdicts; beside the others they are the best that fits. */
  private static List<String> concluded(Answer answer) {
    boolean names = answer.verdict() == Verdict.EXPLAINED || answer.verdict() == Verdict.PARTLY;
    return names ? answer.explanation() : List.of();
  }

  /** How many of the separated are of a tie. */
  private long among(Set<String> tie) {
    return proposal.separates().stream().filter(tie::contains).count();
  }

  Graded gradedBefore() {
    return new Graded(truth, Optional.of(before));
  }

  Graded gradedAfter() {
    return new Graded(truth, after);
  }
}
