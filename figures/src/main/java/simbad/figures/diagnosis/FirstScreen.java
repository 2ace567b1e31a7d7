package simbad.figures.diagnosis;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import simbad.figures.page.AxisScale;
import simbad.figures.page.Bars;
import simbad.figures.page.Html;
import simbad.figures.page.Numbers;
import simbad.figures.page.Page;
import simbad.gap.diagnosis.BudgetEntry;
import simbad.gap.diagnosis.DataSet;
import simbad.gap.diagnosis.Diagnosis;
import simbad.gap.diagnosis.EffectFinding;
import simbad.gap.diagnosis.GapFigures;
import simbad.gap.diagnosis.Place;
import simbad.gap.diagnosis.Remedies;
import simbad.sonar.scene.SonarSpec;

/** What a reader knows who reads no further: verdict, probabilities, shrinkage, the worst place. */
final class FirstScreen {
  private static final int LEAST_BARS = 3;
  private static final int MOST_BARS = 6;
  private static final double WORTH_A_BAR = 0.02;

  private final Diagnosis diagnosis;
  private final SonarSpec sensor;

  private FirstScreen(Diagnosis diagnosis, SonarSpec sensor) {
    this.diagnosis = diagnosis;
    this.sensor = sensor;
  }

  static void add(Page page, Diagnosis diagnosis, DataSet data) {
    FirstScreen screen = new FirstScreen(diagnosis, data.setup().sensor());
    page.verdict(VerdictWords.sentence(diagnosis));
    VerdictWords.addSecond(page, diagnosis);
    page.add(Html.styled("div", "panels", screen.probabilities(), screen.shrinkage()));
    screen.worstPlace(page);
    ReferenceWords.of(data).ifPresent(words -> page.soft(words));
  }

  private Html probabilities() {
    Bars bars = new Bars();
    List<EffectFinding> effects = diagnosis.effects();
    for (int i = 0; i < Math.min(MOST_BARS, effects.size()); i++) {
      EffectFinding finding = effects.get(i);
      if (i < LEAST_BARS || finding.probability() >= WORTH_A_BAR) {
        add(bars, finding.effect().word(), finding.probability(), "after");
      }
    }
    add(bars, "unknown", diagnosis.unknownProbability(), "unknown");
    Html meanings = Html.all(VerdictWords.named(diagnosis).stream().map(this::meaning).toList());
    return Page.panel("", "Which effect is at work: probability", bars.html(), meanings);
  }

  private static void add(Bars bars, String name, double probability, String style) {
    bars.bar(name, probability, style, Numbers.probability(probability));
  }

  private Html meaning(EffectFinding finding) {
    return Html.styled(
        "p",
        "soft",
        finding.effect().word(),
        ": ",
        VerdictWords.meaning(finding.effect()),
        ". ",
        remedy(finding));
  }

  /** What is not sure enough to be named is not sure enough to be acted upon. */
  private Html remedy(EffectFinding finding) {
    return Html.of(
        Html.strong("What to do:"),
        " ",
        diagnosis.verdict().namesEffects()
            ? Remedies.of(finding, sensor) + otherwise(finding)
            : "nothing yet, since it is not sure",
        ".");
  }

  /** What to do if it is what these data cannot tell from it. */
  private String otherwise(EffectFinding finding) {
    return Remedies.toActUpon(diagnosis).stream()
        .filter(other -> finding.indistinguishableFrom().contains(other.effect()))
        .map(other -> "; or, if it is " + other.effect() + ": " + Remedies.of(other, sensor))
        .collect(Collectors.joining());
  }

  private Html shrinkage() {
    GapFigures gap = diagnosis.gap();
    double most = Math.max(gap.beforeCm(), Math.max(gap.afterCm(), gap.floorCm()));
    AxisScale scale = AxisScale.over(0, most, 4);
    boolean shrinks = !diagnosis.explanation().isEmpty();
    Html after = Bars.fill(scale.share(gap.afterCm()), "after");
    Bars bars = new Bars();
    bars.bar("before", scale.share(gap.beforeCm()), "before", Numbers.fixed(gap.beforeCm(), 2));
    bars.bar(
        "after",
        shrinks ? Html.of(after, whisker(gap, scale)) : after,
        Numbers.fixed(gap.afterCm(), 2));
    bars.bar("floor", scale.share(gap.floorCm()), "floor", Numbers.fixed(gap.floorCm(), 2));
    return Page.panel(
        "",
        "How far the gap shrinks: mean gap in cm",
        bars.html(),
        Html.styled("p", "soft", shrinks(gap)),
        budget());
  }

  /** One bar, as long as the gap before: each effect's share, the rest, the floor. */
  private Html budget() {
    double all = diagnosis.budget().stream().mapToDouble(entry -> Math.max(0, entry.cm())).sum();
    if (!(all > 0)) {
      return Html.NONE;
    }
    List<Html> bar = new ArrayList<>();
    List<Html> words = new ArrayList<>();
    int effect = 0;
    for (BudgetEntry entry : diagnosis.budget()) {
      String style = budgetStyle(entry, effect++);
      String grow = "flex-grow:" + Numbers.share(Math.max(0, entry.cm()) / all);
      bar.add(Html.placed("span", "fill " + style, grow));
      words.add(Html.of(Html.key(style), "\u00a0", words(entry), "; "));
    }
    words.add(Html.of("in brackets 95\u00a0% intervals. The parts add up to the gap before."));
    return Html.of(
        Html.styled("h3", "soft", "Parts of the gap before, in cm"),
        Html.styled("div", "budget", Html.all(bar)),
        Html.styled("p", "soft", Html.all(words)));
  }

  private static String budgetStyle(BudgetEntry entry, int effect) {
    return switch (entry.what()) {
      case BudgetEntry.REST -> "unknown";
      case BudgetEntry.FLOOR -> "floor";
      default -> "effect" + Math.min(2, effect);
    };
  }

  private static String words(BudgetEntry entry) {
    return Names.part(entry.what())
        + " "
        + Numbers.fixed(entry.cm(), 2)
        + " ("
        + Numbers.fixed(entry.ci95().low(), 2)
        + " to "
        + Numbers.fixed(entry.ci95().high(), 2)
        + ")";
  }

  private String shrinks(GapFigures gap) {
    if (diagnosis.explanation().isEmpty()) {
      return "No effect was put into the simulator, so the gap after equals the gap before. "
          + "The floor is the gap that the simulator expects from scatter alone.";
    }
    return "The gap shrinks by "
        + Numbers.percent(gap.shrink())
        + " (95\u00a0% interval "
        + Numbers.percent(gap.shrinkCi95().low())
        + " to "
        + Numbers.percent(gap.shrinkCi95().high())
        + ", the line on the bar), measured on "
        + gap.rowsHeldOut()
        + " rows that were not used for the fit. The floor is the gap that the diagnosed "
        + "model expects from scatter alone.";
  }

  /** The interval of the shrinkage as one of the gap after it, for the gap before it is fixed. */
  private static Html whisker(GapFigures gap, AxisScale scale) {
    return Bars.whisker(
        scale.share(gap.beforeCm() * (1 - gap.shrinkCi95().high())),
        scale.share(gap.beforeCm() * (1 - gap.shrinkCi95().low())));
  }

  private void worstPlace(Page page) {
    if (diagnosis.where().isEmpty()) {
      return;
    }
    Place place = diagnosis.where().get(0);
    page.say(
        Html.strong("Largest part of the gap:"),
        " ",
        PlaceWords.words(place),
        ": ",
        place.kind().words(),
        ", ",
        Numbers.percent(place.shareOfGap()),
        " of the gap, ",
        Numbers.centimetres(place.beforeCm()),
        " before and ",
        Numbers.centimetres(place.afterCm()),
        " after.");
  }
}
