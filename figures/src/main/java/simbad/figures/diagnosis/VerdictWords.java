package simbad.figures.diagnosis;

import java.util.Comparator;
import java.util.List;
import simbad.definition.Effect;
import simbad.figures.markup.Markup;
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

  /** The verdict in a sentence or two of HTML. */
  static String sentence(Diagnosis diagnosis) {
    return switch (diagnosis.verdict()) {
      case NONE ->
          "<strong>No gap beyond chance:</strong> these readings are what the simulator expects"
              + withinFigures(diagnosis.gap())
              + ".";
      case EXPLAINED ->
          "<strong>"
              + Html.list(diagnosis.explanation())
              + "</strong>"
              + explains(diagnosis)
              + ": "
              + shrinkage(diagnosis)
              + ". The diagnosed model itself expects a gap of "
              + Html.centimetres(diagnosis.gap().floorCm())
              + " from scatter.";
      case PARTLY ->
          "<strong>"
              + Html.list(diagnosis.explanation())
              + (diagnosis.explanation().size() == 1 ? " is" : " are")
              + " at work, and something else is too</strong>: "
              + shrinkage(diagnosis)
              + ". The diagnosed model itself expects a gap of "
              + Html.centimetres(diagnosis.gap().floorCm())
              + " from scatter"
              + (diagnosis.reason().isEmpty()
                  ? "."
                  : ". Beside it, " + Markup.escaped(diagnosis.reason()) + ".");
      case UNEXPLAINED -> unexplained(diagnosis);
      case UNDECIDED ->
          "<strong>These data cannot tell:</strong> " + Markup.escaped(diagnosis.reason()) + ".";
    };
  }

  private static String unexplained(Diagnosis diagnosis) {
    if (diagnosis.explanation().isEmpty()) {
      return "<strong>"
          + (leavesGap(diagnosis.gap())
              ? "There is a gap, and no effect that has a name here accounts for it"
              : "The readings differ from what the simulator expects in a way that no effect with a"
                  + " name here accounts for")
          + "</strong>"
          + withinFigures(diagnosis.gap())
          + "."
          + (diagnosis.reason().isEmpty()
              ? ""
              : " What happens: " + Markup.escaped(diagnosis.reason()) + ".");
    }
    boolean one = diagnosis.explanation().size() == 1;
    return "<strong>No named effect accounts for the gap.</strong> Nearest "
        + (one ? "comes " : "come ")
        + Html.list(diagnosis.explanation())
        + ": "
        + shrinkage(diagnosis)
        + ". "
        + (diagnosis.reason().isEmpty()
            ? remains(diagnosis.gap())
            : "But " + Markup.escaped(diagnosis.reason()) + ".");
  }

  /** Why what comes nearest is no explanation. */
  private static String remains(GapFigures gap) {
    return leavesGap(gap)
        ? "But that model expects only " + Html.centimetres(gap.floorCm()) + " from scatter."
        : "The size of what is left is what that model expects from scatter, but the readings"
            + " spread otherwise than it says.";
  }

  /** Whether what is left is plainly more than the model expects of itself. */
  private static boolean leavesGap(GapFigures gap) {
    return gap.afterCm() > LEFT * gap.floorCm();
  }

  private static String explains(Diagnosis diagnosis) {
    return diagnosis.explanation().size() == 1
        ? " accounts for the gap"
        : " together account for the gap";
  }

  private static String withinFigures(GapFigures gap) {
    return " (the gap is "
        + Html.centimetres(gap.beforeCm())
        + ", of which the model expects "
        + Html.centimetres(gap.floorCm())
        + " from scatter alone)";
  }

  private static String shrinkage(Diagnosis diagnosis) {
    GapFigures gap = diagnosis.gap();
    return "with "
        + (diagnosis.explanation().size() == 1 ? "it" : "them")
        + " in the simulator the gap shrinks from "
        + Html.centimetres(gap.beforeCm())
        + " to "
        + Html.centimetres(gap.afterCm())
        + ", by <strong>"
        + Html.percent(gap.shrink())
        + "</strong>";
  }

  /**
   * What stands under the verdict: ties and the chance of something unknown, where worth saying.
   */
  static String second(Diagnosis diagnosis) {
    StringBuilder words = new StringBuilder();
    for (EffectFinding finding : named(diagnosis)) {
      if (!finding.indistinguishableFrom().isEmpty()) {
        words.append(
            "<p class=\"note\">These data cannot tell "
                + finding.effect().word()
                + " from "
                + Html.list(finding.indistinguishableFrom())
                + ".</p>\n");
      }
    }
    if (diagnosis.verdict() != Verdict.UNDECIDED
        && diagnosis.unknownProbability() >= WORTH_SAYING) {
      words.append(
          "<p>That something without a name here is at work has a probability of "
              + Html.probability(diagnosis.unknownProbability())
              + ".</p>\n");
    }
    return words.toString();
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
