package simbad.figures.blindcheck;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Path;
import java.util.List;
import java.util.OptionalDouble;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simbad.experiments.blindcheck.CheckScores;
import simbad.experiments.blindcheck.Measure;
import simbad.figures.page.Browser;

class CheckPageTest {
  private static final String PAGE =
      CheckPage.of(SampleScores.order("gain"), SampleScores.scores(), List.of());

  @TempDir private Path folder = Path.of("target");

  @Test
  void firstScreen_answers() {
    String words = PAGE.replaceAll("<[^>]*>", "").replace("&nbsp;", " ").replace('\u00a0', ' ');
    assertTrue(words.contains("36 of 40, 90 % (95 % interval 72 % to 100 %)"));
    assertTrue(words.contains("Independence: " + SampleScores.ALL));
    assertTrue(words.contains("The diagnosis did not know gain"));
    assertTrue(words.contains("1 case has no answer. It counts as wrong"));
  }

  /** Each table of figures is headed by its part's name, in which the level stands. */
  @Test
  void everyTable_statesItsLevel() {
    for (String part : List.of(SampleScores.ALL, SampleScores.L1, SampleScores.L2)) {
      assertEquals(2, count("<h3>" + Pattern.quote(part) + ", \\d+ cases</h3>"));
      assertEquals(3, count("aria-label=\"[^\"]*" + Pattern.quote(part) + "; n = \\d+\""));
    }
    assertEquals(6, count("<h3>[^<]*\\d+ cases</h3>"));
  }

  private static int count(String pattern) {
    Matcher matcher = Pattern.compile(pattern).matcher(PAGE);
    int count = 0;
    while (matcher.find()) {
      count++;
    }
    return count;
  }

  @Test
  void whatIsToBeReached_isMetOrMissed() {
    assertTrue(cells("no effect: called none").contains("<b class=\"met\">met</b>"));
    assertTrue(cells("one effect: explained, and named").contains("\"missed\">missed</b>"));
    assertFalse(PAGE.contains("withheld effect: called unexplained"), "of no case");
  }

  /** 95 % are asked of single effects. */
  @ParameterizedTest
  @CsvSource({
    "0.98, 0.96, 0.99, met</b>",
    "0.96, 0.90, 0.98, 'met</b>, not surely'",
    "0.94, 0.90, 0.98, 'missed</b>, not surely'",
    "0.90, 0.85, 0.94, missed</b>"
  })
  void intervalThatHoldsTheReach_leavesItOpen(
      double value, double low, double high, String expected) {
    Measure singles = measure("singles named and explained");
    CheckScores.Estimate found = new CheckScores.Estimate(value, low, high, "1 of 2");
    String cell = ScoreCell.reached(singles, found, false).toString();
    assertTrue(cell.endsWith(expected), cell);
  }

  private static Measure measure(String name) {
    return Measure.ALL.stream().filter(m -> m.name().equals(name)).findFirst().orElseThrow();
  }

  private static String cells(String words) {
    String row = "<th scope=\"row\">" + words + "</th>";
    int from = PAGE.indexOf(row);
    return PAGE.substring(from, PAGE.indexOf("</tr>", from));
  }

  @Test
  void reach_isATenthLessWhereTheSetUpIsOff() {
    Measure none = measure("none called none");
    assertEquals(OptionalDouble.of(0.975), none.reach(false));
    assertEquals(0.8775, none.reach(true).getAsDouble(), 1e-12);
    Measure error = measure("verdict ECE");
    assertEquals(OptionalDouble.of(0.05), error.reach(true));
    assertTrue(error.isCost());
  }

  /** Half a per cent is rounded up everywhere alike. */
  @Test
  void halves_areRoundedUp() {
    assertEquals("63\u00a0%", Measure.percent(0.625));
    assertEquals("63\u00a0%", Measure.ALL.get(0).text(0.625));
    assertEquals("\u22123", Measure.ALL.get(0).number(-0.03));
  }

  @Test
  void wordsFromFiles_areEscaped() {
    assertTrue(PAGE.contains("<td>&lt;b&gt;</td>"));
    assertTrue(
        CheckPage.of(SampleScores.foreign(), SampleScores.scores(), List.of())
            .contains("their &lt;sets&gt;"));
  }

  @Test
  void severalNames_shareAColumn() {
    String table =
        ConfusionTable.of(
                "at work",
                "part",
                ConfusionTable.alone(
                    SampleScores.scores()
                        .figures(SampleScores.ALL, CheckScores.DIAGNOSIS)
                        .orElseThrow()
                        .figures()
                        .path("confusion")))
            .toString();
    String words = table.replaceAll("<[^>]*>", " ").replaceAll(" +", " ").replace(" \n", "\n");
    assertTrue(words.contains("at work none gain several names (no answer) all"), words);
    assertTrue(words.contains("gain 3 2 5"), words);
    assertFalse(words.contains("gain+latency"), words);
  }

  @Test
  void page_isWhole() throws Exception {
    assumeTrue(Browser.isThere(), "no Chromium on this machine: the page is not looked at");
    new Browser(folder).look(PAGE);
  }
}
