package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simbad.figures.diagnosis.Browser;

/**
 * The guides' pages and a run's in headless Chromium, in both themes, wide and narrow. Those of the
 * diagnosis and of the withheld check have tests of their own.
 */
class PagesInBrowserTest {
  private static final Path LIVE =
      Path.of("..", "figures/src/main/resources/simbad/figures/bench/live.html");

  /** The page of a sweep under way asks for the state again and again; here it is told one. */
  private static final String ASKING = "show();\n</script>";

  private static final String TOLD =
      """
      const told = {obstacle: 'angle', bearings: 12, pings_each: 10, done: 3, pings: 512, readings: 513,
        reading_cm: '148.2', bearing_deg: 90, levels: [[1.2, 10, 10, false], [1.6, 10, 2, true], [1.4, 3, 3, false]],
        points: [[0, 0.31, 0.3, 0.33], [30, 0.84, 0.8, 0.9], [60, 1.3, 1.29, 1.31]]};
      tell(told); draw(told); live(told);
      </script>""";

  @TempDir
  @SuppressWarnings("NullAway.Init")
  private static Path folder;

  @BeforeAll
  static void write() throws Exception {
    assumeTrue(Browser.isThere(), "no Chromium on this machine: the pages are not looked at");
    assertEquals(0, Shell.simbad("docs", "--out", folder.resolve("site").toString()).status());
    String run = folder.resolve("run").toString();
    assertEquals(0, Shell.simbad("run", "round", "--speed", "0.5", "--out", run).status());
    String live = Files.readString(LIVE);
    assertTrue(live.contains(ASKING), "the page asks for its state at its end");
    Files.writeString(folder.resolve("live.html"), live.replace(ASKING, TOLD));
  }

  @ParameterizedTest
  @CsvSource({
    "site/index.html, 1280, false",
    "site/index.html, 500, true",
    "site/docs/guide/diagnose.html, 500, false",
    "site/docs/performance.html, 1280, true",
    "run/report.html, 1280, false",
    "run/report.html, 500, true",
    "live.html, 1280, false",
    "live.html, 500, true"
  })
  void page_isWholeAndForEverybody(String page, int width, boolean dark) throws Exception {
    assertEquals("[]", new Browser(folder).faults(folder.resolve(page), width, dark));
  }
}
