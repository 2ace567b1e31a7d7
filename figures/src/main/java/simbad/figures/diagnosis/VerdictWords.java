package simbad.figures.diagnosis;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import simbad.definition.Effect;
import simbad.figures.page.Html;
import simbad.figures.page.Numbers;
import simbad.figures.page.Page;
import simbad.gap.diagnosis.Diagnosis;
import simbad.gap.diagnosis.EffectFinding;
import simbad.gap.diagnosis.GapFigures;
import simbad.gap.diagnosis.Verdict;
import simbad.sonar.effect.Definitions;

/** The verdict in one sentence, and those that follow from it. */
final class VerdictWords {
  private static final double WORTH_SAYING = 0.005;

  /** A gap that is less than this times the floor is the floor's, give or take the fit. */
  private static final double LEFT = 1.05;

  private VerdictWords() {}

  /** The verdict in a sentence or two. */
  static Html sentence(Diagnosis diagnosis) {
    return switch (diagnosis.verdict()) {
      case NONE ->
          Html.of(
              Html.strong("No gap beyond chance:"),
              " these readings are what the simulator expects",
              withinFigures(diagnosis.gap()),
              ".");
      case EXPLAINED -> explained(diagnosis);
      case PARTLY -> partly(diagnosis);
      case UNEXPLAINED -> unexplained(diagnosis);
      case UNDECIDED ->
          isOfATie(diagnosis)
              ? Html.strong("T" + diagnosis.reason().substring(1) + ".")
              : Html.of(Html.strong("These data cannot tell:"), " ", diagnosis.reason(), ".");
    };
  }

  /** Whether the reason is itself what these data cannot tell. */
  private static boolean isOfATie(Diagnosis diagnosis) {
    return diagnosis.reason().startsWith("these data cannot tell ");
  }

  private static Html explained(Diagnosis diagnosis) {
    return Html.of(
        Html.strong(Names.list(diagnosis.explanation())),
        diagnosis.explanation().size() == 1
            ? " accounts for the gap"
            : " together account for the gap",
        ": ",
        shrinkage(diagnosis),
        expected(diagnosis.gap()));
  }

  private static Html partly(Diagnosis diagnosis) {
    return Html.of(
        Html.strong(
            Names.list(diagnosis.explanation()),
            diagnosis.explanation().size() == 1 ? " is" : " are",
            " at work, and something else too"),
        ": ",
        shrinkage(diagnosis),
        expected(diagnosis.gap()),
        diagnosis.reason().isEmpty() ? "" : " Also: " + diagnosis.reason() + ".");
  }

  private static String expected(GapFigures gap) {
    return ". The diagnosed model itself expects a gap of "
        + Numbers.centimetres(gap.floorCm())
        + " from scatter.";
  }

  private static Html unexplained(Diagnosis diagnosis) {
    return diagnosis.explanation().isEmpty() ? nameless(diagnosis) : nearest(diagnosis);
  }

  private static Html nameless(Diagnosis diagnosis) {
    return Html.of(
        Html.strong(
            leavesGap(diagnosis.gap())
                ? "There is a gap, and no known effect accounts for it"
                : "The readings differ from what the simulator expects, and no known effect "
                    + "accounts for the difference"),
        withinFigures(diagnosis.gap()),
        ".",
        diagnosis.reason().isEmpty() ? "" : " What happens: " + diagnosis.reason() + ".");
  }

  private static Html nearest(Diagnosis diagnosis) {
    return Html.of(
        Html.strong("No named effect accounts for the gap."),
        diagnosis.explanation().size() == 1 ? " The nearest is " : " The nearest are ",
        Names.list(diagnosis.explanation()),
        ": ",
        shrinkage(diagnosis),
        ". ",
        diagnosis.reason().isEmpty()
            ? remains(diagnosis.gap())
            : "But " + diagnosis.reason() + ".");
  }

  /** Why what comes nearest is no explanation. */
  private static String remains(GapFigures gap) {
    return leavesGap(gap)
        ? "But that model expects only " + Numbers.centimetres(gap.floorCm()) + " from scatter."
        : "What is left is as large as that model expects from scatter, but the readings "
            + "spread in another way than it says.";
  }

  /** Whether what is left is plainly more than the model expects of itself. */
  private static boolean leavesGap(GapFigures gap) {
    return gap.afterCm() > LEFT * gap.floorCm();
  }

  private static String withinFigures(GapFigures gap) {
    return " (the gap is "
        + Numbers.centimetres(gap.beforeCm())
        + "; the model expects "
        + Numbers.centimetres(gap.floorCm())
        + " from scatter alone)";
  }

  private static Html shrinkage(Diagnosis diagnosis) {
    GapFigures gap = diagnosis.gap();
    return Html.of(
        "with ",
        diagnosis.explanation().size() == 1 ? "it" : "them",
        " in the simulator the gap shrinks from ",
        Numbers.centimetres(gap.beforeCm()),
        " to ",
        Numbers.centimetres(gap.afterCm()),
        ", by ",
        Html.strong(Numbers.percent(gap.shrink())));
  }

  /** Adds what stands under the verdict: ties and the chance of something unknown. */
  static void addSecond(Page page, Diagnosis diagnosis) {
    ties(diagnosis).forEach(page::note);
    addUnknown(page, diagnosis.verdict(), diagnosis.unknownProbability(), " is at work is ");
  }

  /** Adds the probability that something unknown is there, with the words between the two. */
  static void addUnknown(Page page, Verdict verdict, double probability, String between) {
    if (verdict != Verdict.UNDECIDED && probability >= WORTH_SAYING) {
      page.say(
          "The probability that something unknown", between, Numbers.probability(probability), ".");
    }
  }

  private static List<String> ties(Diagnosis diagnosis) {
    List<String> ties = new ArrayList<>();
    if (isOfATie(diagnosis)) {
      return ties;
    }
    for (EffectFinding finding : named(diagnosis)) {
      if (!finding.indistinguishableFrom().isEmpty()) {
        ties.add(
            "These data cannot tell "
                + finding.effect().word()
                + " from "
                + Names.list(finding.indistinguishableFrom())
                + ".");
      }
    }
    return ties;
  }

  /** The findings of the effects concluded to be at work. */
  static List<EffectFinding> named(Diagnosis diagnosis) {
    return diagnosis.effects().stream()
        .filter(finding -> diagnosis.explanation().contains(finding.effect()))
        .sorted(Comparator.comparingInt(f -> diagnosis.explanation().indexOf(f.effect())))
        .toList();
  }

  /** What an effect means, in a few words. */
  static String meaning(Effect effect) {
    return Definitions.of(effect).briefly();
  }
}
