package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Path;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simbad.figures.page.Browser;

/**
 * The guides' pages and a run's in headless Chromium, in both themes, wide and narrow. Those of the
 * diagnosis, of the withheld check and of the studio have tests of their own.
 */
class PagesInBrowserTest {
  @TempDir
  @SuppressWarnings("NullAway.Init")
  private static Path folder;

  @BeforeAll
  static void write() throws Exception {
    assumeTrue(Browser.isThere(), "no Chromium on this machine: the pages are not looked at");
    assertEquals(0, Shell.simbad("docs", "--out", folder.resolve("site").toString()).status());
    String run = folder.resolve("run").toString();
    assertEquals(0, Shell.simbad("run", "round", "--speed", "0.5", "--out", run).status());
  }

  @ParameterizedTest
  @CsvSource({
    "site/index.html, 1280, false",
    "site/index.html, 500, true",
    "site/docs/guide/diagnose.html, 500, false",
    "site/docs/performance.html, 1280, true",
    "run/report.html, 1280, false",
    "run/report.html, 500, true"
  })
  void page_isWholeAndForEverybody(String page, int width, boolean dark) throws Exception {
    assertEquals("[]", new Browser(folder).faults(folder.resolve(page), width, dark));
  }
}
