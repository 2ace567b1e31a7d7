package simbad.figures.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.definition.Effect;
import simbad.gap.diagnosis.DataSet;
import simbad.gap.diagnosis.Diagnosis;
import simbad.gap.diagnosis.GapFigures;
import simbad.gap.diagnosis.Verdict;
import simbad.gap.fit.Hypothesis;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SensingSetup;

class DiagnosisPageTest {
  private static final DataSet DATA = Samples.data("a <b> & c");
  private static final String EXPLAINED = Samples.page(Samples.explained(DATA), DATA);

  /** The words of the page as one reads them. */
  private static String words(String page) {
    return page.replaceAll("(?s)<style>.*</style>", "")
        .replaceAll("(?s)<script>.*</script>", "")
        .replaceAll("<title>[^<]*</title>", "")
        .replace("</td>", " ")
        .replaceAll("<[^>]*>", "")
        .replace("&nbsp;", " ")
        .replaceAll("\\s+", " ");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "gain accounts for the gap: with it in the simulator the gap shrinks from 178.80 cm to 60.25"
            + " cm, by 66 %. The diagnosed model itself expects a gap of 51.50 cm from scatter.",
        "These data cannot tell gain from absorption.",
        "The probability that something unknown is at work is 3 %",
        "(95 % interval 61 % to 70 %, the line on the bar), measured on 1500 rows",
        "Largest part of the gap: bearing 100 to 170°, distance from 0.5 m: missed "
            + "echo, 41 % of the gap, 420.00 cm before and 90.00 cm after.",
        "factor 0.5 0.45 to 0.55",
        "loss_per_m 0.123 1/m not known from these data",
        "dead-zone end_m 0.06 m",
        "stale-reading hold_s at no size",
        "To tell gain and absorption apart, measure at the 40 poses of next-experiment.csv",
        "7.25 nats",
        "gain and latency 4990.0",
        "(1 of 528 pairs)",
        "What to do: multiply all thresholds by 0.50, or restore the sensor's drive voltage; or, if it"
            + " is absorption: shorten the far thresholds",
        "gain 118.55 (100.00 to 130.00); not explained 8.75 (5.00 to 12.00); scatter (floor) 51.50",
        "program 1 &lt;b&gt;, seed 7",
        "3024 readings, no reference"
      })
  void everythingIsSaid(String words) {
    assertTrue(words(EXPLAINED).contains(words), words(EXPLAINED));
  }

  @Test
  void whatOthersWrote_isNoMarkup() {
    assertTrue(EXPLAINED.contains("a &lt;b&gt; &amp; c"));
    assertFalse(EXPLAINED.contains("<i>run</i>"));
    assertFalse(EXPLAINED.contains("<b>"));
  }

  @Test
  void page_needsNothingElse() {
    Pattern outside = Pattern.compile("https?:(?!//www.w3.org/2000/svg)|src=|href=|url\\(|@import");
    assertFalse(outside.matcher(EXPLAINED).find());
  }

  @Test
  void figures_areAllThere() {
    for (String heading :
        List.of(
            "Before: round the obstacle square",
            "After: round the obstacle square",
            "By distance",
            "By time",
            "By speed",
            "Ranks",
            "Ranges",
            "Poses to measure at")) {
      assertTrue(EXPLAINED.contains("<h3>" + heading + "</h3>"), heading);
    }
    assertFalse(EXPLAINED.contains("<h3>By off-axis angle</h3>"), "the sensor always looks there");
    String read = EXPLAINED.substring(0, EXPLAINED.indexOf("<script>"));
    assertFalse(read.contains("NaN"), "no cell and no bar of no rows");
    assertFalse(read.contains("Infinity"));
  }

  @Test
  void nothing_isSaidAsNothing() {
    String page = words(Samples.page(Samples.without(Verdict.NONE, DATA), DATA));
    assertTrue(
        page.contains("No gap beyond chance: these readings are what the simulator expects"));
    assertTrue(page.contains("There is no tie"));
    assertTrue(page.contains("No effect is probable enough for its values to mean something"));
    assertFalse(page.contains("that something unknown is at work is"), page);
  }

  @Test
  void unexplained_saysThatNothingWithANameAccountsForIt() {
    Diagnosis none = Samples.without(Verdict.UNEXPLAINED, DATA);
    String page = words(Samples.page(none, DATA));
    assertTrue(
        page.contains(
            "The readings differ from what the simulator expects, and no known effect accounts for the"
                + " difference (the gap is 2.00 cm"),
        page);
    assertTrue(page.contains("at work is 97 %"));
    GapFigures large = new GapFigures(20, 9, 9, 2, 0, none.gap().shrinkCi95());
    String drifts =
        words(Samples.page(as(Verdict.UNEXPLAINED, "it drifts", List.of(), large), DATA));
    assertTrue(drifts.contains("What happens: it drifts."), drifts);
    String much = words(Samples.page(as(Verdict.UNEXPLAINED, "", List.of(), large), DATA));
    assertTrue(much.contains("There is a gap, and no known effect accounts for it"));
  }

  /** What comes nearest is not said to be at work, and no gap is left where after is the floor. */
  @Test
  void unexplained_withNames_saysHowNearTheyCome() {
    List<Effect> names = List.of(Effect.GAIN, Effect.ABSORPTION);
    GapFigures left = Samples.explained(DATA).gap();
    String page = words(Samples.page(as(Verdict.UNEXPLAINED, "", names, left), DATA));
    assertTrue(
        page.contains(
            "No named effect accounts for the gap. The nearest are gain and absorption: with them in"
                + " the simulator the gap shrinks from 178.80 cm to 60.25 cm, by 66 %. But that model"
                + " expects only 51.50 cm from scatter."),
        page);
    assertFalse(page.contains("at work, but"), page);
    GapFigures floor = new GapFigures(1500, 178.8, 51.6, 51.5, 0.71, left.shrinkCi95());
    String same = words(Samples.page(as(Verdict.UNEXPLAINED, "", names, floor), DATA));
    assertTrue(same.contains("is left is as large as that model expects from scatter, but"), same);
    String bound = "power of gain stands at the end";
    String reason = words(Samples.page(as(Verdict.UNEXPLAINED, bound, names, left), DATA));
    assertTrue(reason.contains("by 66 %. But power of gain stands at the end."), reason);
  }

  @Test
  void undecidedTie_isSaidOnce() {
    GapFigures gap = Samples.explained(DATA).gap();
    String reason = "these data cannot tell gain from absorption, latency";
    Diagnosis tied = as(Verdict.UNDECIDED, reason, List.of(Effect.GAIN), gap);
    String page = words(Samples.page(tied, DATA));
    assertTrue(page.contains("These data cannot tell gain from absorption, latency."), page);
    assertFalse(page.contains("cannot tell: these data"), page);
    int first = page.indexOf("cannot tell gain");
    assertEquals(first, page.lastIndexOf("cannot tell gain"), page);
  }

  @Test
  void whatToDo_waitsForAVerdictThatNames() {
    GapFigures gap = Samples.explained(DATA).gap();
    List<Effect> names = List.of(Effect.GAIN);
    for (Verdict verdict : List.of(Verdict.EXPLAINED, Verdict.PARTLY)) {
      String page = words(Samples.page(as(verdict, "why", names, gap), DATA));
      assertTrue(page.contains("What to do: multiply all thresholds by 0.50"), page);
    }
    for (Verdict verdict : List.of(Verdict.UNEXPLAINED, Verdict.UNDECIDED)) {
      String page = words(Samples.page(as(verdict, "why", names, gap), DATA));
      assertTrue(page.contains("What to do: nothing yet, since it is not sure."), page);
      assertFalse(page.contains("multiply all thresholds"), page);
    }
  }

  @Test
  void explained_claimsNoMoreThanTheModelExpects() {
    String page = words(EXPLAINED);
    assertTrue(
        page.contains("The diagnosed model itself expects a gap of 51.50 cm from scatter."), page);
    assertFalse(page.contains("no model could"), page);
  }

  @Test
  void undecided_saysWhy_andStatesNoInterval() {
    String html = Samples.page(Samples.without(Verdict.UNDECIDED, DATA), DATA);
    String page = words(html);
    assertTrue(
        html.contains("These data cannot tell:</strong> there are &lt;too few&gt; readings."));
    assertFalse(page.contains("interval"), page);
    assertFalse(page.contains("No gap beyond chance"), page);
    assertFalse(page.contains("has a probability of"), page);
  }

  private static Diagnosis as(Verdict verdict, String reason, List<Effect> names, GapFigures gap) {
    Diagnosis whole = Samples.explained(DATA);
    return new Diagnosis(
        verdict,
        reason,
        names,
        whole.effects(),
        0.8,
        0.9,
        List.of(),
        gap,
        whole.budget(),
        whole.where(),
        whole.undetectable(),
        Optional.empty(),
        whole.fitted(),
        Hypothesis.NONE,
        whole.tried(),
        whole.signs(),
        whole.setupError(),
        whole.audit());
  }

  /** Rows without any obstacle, and a single one of them. */
  @Test
  void emptyScene_oneRow_isAPage() {
    SensingSetup empty =
        new SensingSetup(DATA.setup().sensor(), new Scene(List.of()), DATA.setup().noEchoM());
    DataSet one = new DataSet("one", empty, DATA.readings().subList(0, 1), List.of());
    String page = Samples.page(Samples.without(Verdict.NONE, one), one);
    assertTrue(page.contains("<h3>Ranks</h3>"));
    assertFalse(page.contains("round the obstacle"));
    assertFalse(page.contains("NaN"));
  }

  /** Half of the gain's threshold: the map after it is paler than that before. */
  @Test
  void shades_followTheGap() {
    String before = map("Gap before: round the obstacle square");
    String after = map("Gap after: round the obstacle square");
    assertTrue(meanCm(before) > 1.3 * meanCm(after), meanCm(before) + " " + meanCm(after));
    assertTrue(Pattern.compile("<path class=\"shade h[4-8]\"").matcher(before).find(), before);
  }

  private static String map(String label) {
    int from = EXPLAINED.indexOf("aria-label=\"" + label);
    return EXPLAINED.substring(from, EXPLAINED.indexOf("</svg>", from));
  }

  /** Of the numbers that are read where one points. */
  private static double meanCm(String map) {
    Matcher cells = Pattern.compile("data-cells=\"([^\"]*)").matcher(map);
    assertTrue(cells.find());
    return Pattern.compile("[,;]")
        .splitAsStream(cells.group(1))
        .filter(cell -> !cell.isEmpty())
        .mapToDouble(Double::parseDouble)
        .average()
        .orElseThrow();
  }

  @Test
  void sameDiagnosis_sameBytes() {
    assertEquals(EXPLAINED, Samples.page(Samples.explained(DATA), DATA));
  }
}
