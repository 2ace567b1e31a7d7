package simbad.experiments.diagnosis;

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
import simbad.gap.diagnosis.DataSet;
import simbad.gap.diagnosis.Diagnosis;
import simbad.gap.diagnosis.Verdict;
import simbad.gap.fit.Hypothesis;
import simbad.sonar.effect.Effect;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SensingSetup;

class DiagnosisPageTest {
  private static final DataSet DATA = Samples.data("a <b> & c");
  private static final String EXPLAINED = Samples.page(Samples.explained(DATA), DATA);

  /** The words of the page as one reads them. */
  private static String words(String page) {
    return page.replaceAll("(?s)<style>.*</style>", "")
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
            + " cm, by 66 %; no model could come below 51.50 cm.",
        "These data cannot tell gain from absorption.",
        "something without a name here is at work as well has a probability of 3 %",
        "(95 % interval 61 % to 70 %, the line on the bar), measured on 1500 rows",
        "Where most of it lies: bearing 100 to 170°, distance from 0.5 m: missed echo, 41 % of the"
            + " gap, 420.00 cm before and 90.00 cm after.",
        "factor 0.5 0.45 to 0.55",
        "loss_per_m 0.123 1/m not known from these data",
        "dead-zone end_m 0.06 m",
        "stale-reading hold_s at no size",
        "To tell gain and absorption apart, measure at the 40 poses of next-experiment.csv",
        "7.25 nats",
        "gain and latency 4990.0",
        "(1 of 325 pairs)",
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
    assertFalse(Pattern.compile("https?:|src=|href=|url\\(|<script").matcher(EXPLAINED).find());
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
    assertFalse(EXPLAINED.contains("NaN"), "no cell and no bar of no rows");
    assertFalse(EXPLAINED.contains("Infinity"));
  }

  @Test
  void nothing_isSaidAsNothing() {
    String page = words(Samples.page(Samples.without(Verdict.NONE, DATA), DATA));
    assertTrue(
        page.contains("No gap beyond chance: these readings are what the simulator expects"));
    assertTrue(page.contains("Nothing is tied"));
    assertTrue(page.contains("No effect is probable enough for its parameters to mean something"));
    assertFalse(page.contains("something without a name here is at work as well"), page);
  }

  @Test
  void unexplained_saysThatNothingWithANameAccountsForIt() {
    String page = words(Samples.page(Samples.without(Verdict.UNEXPLAINED, DATA), DATA));
    assertTrue(page.contains("There is a gap, and no effect that has a name here accounts for it"));
    assertTrue(page.contains("probability of 97 %"));
  }

  @Test
  void unexplainedInPart_saysWhatIsLeft() {
    Diagnosis whole = Samples.explained(DATA);
    Diagnosis part =
        new Diagnosis(
            Verdict.UNEXPLAINED,
            List.of(Effect.GAIN, Effect.ABSORPTION),
            whole.effects(),
            0.8,
            0.9,
            whole.gap(),
            whole.where(),
            whole.undetectable(),
            Optional.empty(),
            whole.fitted(),
            Hypothesis.NONE,
            whole.tried());
    String page = words(Samples.page(part, DATA));
    assertTrue(
        page.contains(
            "gain and absorption are at work, but a gap is left that no named effect accounts for:"
                + " with them in the simulator"),
        page);
    assertTrue(page.contains("; it then expects 51.50 cm from scatter alone."), page);
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
    double before = meanShade("Gap before: round the obstacle square");
    double after = meanShade("Gap after: round the obstacle square");
    assertTrue(before > after + 0.3, before + " " + after);
  }

  private static double meanShade(String label) {
    int from = EXPLAINED.indexOf("aria-label=\"" + label);
    String svg = EXPLAINED.substring(from, EXPLAINED.indexOf("</svg>", from));
    Matcher cells = Pattern.compile("<path class=\"h(\\d)\"").matcher(svg);
    return cells
        .results()
        .mapToInt(cell -> Integer.parseInt(cell.group(1)))
        .average()
        .orElseThrow();
  }

  @Test
  void sameDiagnosis_sameBytes() {
    assertEquals(EXPLAINED, Samples.page(Samples.explained(DATA), DATA));
  }
}
