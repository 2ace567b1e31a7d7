package simbad.blindworld.score;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;

/**
 * Whether measuring what answers propose tells apart what it is proposed for: the answers after
 * that against those before, case by case.
 */
public final class NextScores {

  private static final String HEADER =
      "case,level,kind,so,separates,at_work,expected_log_odds,outcome,said_before,said_after,"
          + "standing_before,standing_after\n";

  private final int answered;
  private final boolean waves;
  private final List<Parted> cases = new ArrayList<>();

  /**
   * A scoring of answers to these truths; an answer that is missing afterwards is wrong.
   *
   * @param truths what was at work
   * @param waves whether they are of worlds of waves
   * @param proposals by case
   * @param before the answers that propose, by case
   * @param after the answers to the readings with those that were proposed, by case
   */
  public NextScores(
      List<Truth> truths,
      boolean waves,
      Map<String, Proposal> proposals,
      Map<String, Answer> before,
      Map<String, Answer> after) {
    this.answered = before.size();
    this.waves = waves;
    for (Truth truth : truths) {
      Proposal proposal = proposals.get(truth.id());
      Answer first = before.get(truth.id());
      if (proposal != null && first != null) {
        Optional<Answer> second = Optional.ofNullable(after.get(truth.id()));
        cases.add(new Parted(truth, proposal, first, second));
      }
    }
  }

  private String level(Parted one) {
    String ofEquations = one.truth().reference() ? "L2" : "L1";
    return waves ? "L2w" : ofEquations;
  }

  /** One line for each case with a proposal, under a header. */
  public String csv() {
    StringBuilder text = new StringBuilder(HEADER);
    for (Parted one : cases) {
      double odds = one.proposal().expectedLogOdds();
      text.append(
          String.join(
              ",",
              one.truth().id(),
              level(one),
              one.truth().kind(),
              CaseLines.so(one.truth()),
              String.join("+", one.proposal().separates()),
              String.join("+", one.atWork()),
              odds < Double.POSITIVE_INFINITY ? String.format(Locale.ROOT, "%.2f", odds) : "",
              one.outcome().word(),
              one.gradedBefore().said(),
              one.gradedAfter().said(),
              word(one.gradedBefore()),
              word(one.gradedAfter())));
      text.append('\n');
    }
    return text.toString();
  }

  private static String word(Graded graded) {
    return graded.standing().name().toLowerCase(Locale.ROOT);
  }

  /** A line for each case, and shares of all and of each level with 95 % intervals. */
  public String text() {
    StringBuilder text = new StringBuilder();
    text.append(
        "next experiments: %d of %d answers propose one\n".formatted(cases.size(), answered));
    for (Parted one : cases) {
      text.append(
          "  %s %s, so %s, to tell apart %s: %s; said %s, then %s; %s, then %s\n"
              .formatted(
                  one.truth().id(),
                  level(one),
                  CaseLines.so(one.truth()),
                  String.join(" and ", one.proposal().separates()),
                  one.outcome().word(),
                  one.gradedBefore().said(),
                  one.gradedAfter().said(),
                  word(one.gradedBefore()),
                  word(one.gradedAfter())));
    }
    List<String> levels = cases.stream().map(this::level).distinct().sorted().toList();
    append(text, "all", cases);
    for (String level : levels.size() > 1 ? levels : List.<String>of()) {
      append(text, level, cases.stream().filter(one -> level(one).equals(level)).toList());
    }
    return text.toString();
  }

  private static void append(StringBuilder text, String part, List<Parted> of) {
    text.append('\n').append(part).append('\n');
    List<Parted> atWork = of.stream().filter(one -> !one.atWork().isEmpty()).toList();
    line(text, "told apart rightly", of, NextScores::isRight);
    line(text, "  where one of them is at work", atWork, NextScores::isRight);
    line(text, "told apart wrongly", of, one -> one.outcome() == Parted.Outcome.WRONG);
    line(text, "still tied, or undecided", of, one -> one.outcome() == Parted.Outcome.TIED);
    for (Graded.Standing standing : Graded.Standing.values()) {
      String word = standing.name().toLowerCase(Locale.ROOT);
      line(text, word + " before", of, one -> one.gradedBefore().standing() == standing);
      line(text, word + " after", of, one -> one.gradedAfter().standing() == standing);
    }
  }

  private static boolean isRight(Parted one) {
    return one.outcome() == Parted.Outcome.RIGHT;
  }

  private static void line(
      StringBuilder text, String what, List<Parted> of, Predicate<Parted> hit) {
    Proportion share = new Proportion((int) of.stream().filter(hit).count(), of.size());
    text.append("  %-34s %s\n".formatted(what, share));
  }
}
