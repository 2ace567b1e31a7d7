package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simbad.figures.page.Browser;
import simbad.figures.page.Typist;

/**
 * The guides' pages and those of a run and a batch in headless Chromium, in both themes, on a
 * phone, a desk and a wall; one browser for all. Those of the diagnosis, of the withheld check and
 * of the studio have tests of their own.
 */
@Timeout(300)
class PagesInBrowserTest {
  /** What a report may have. */
  private static final int MOST_BYTES = 300_000;

  private static final String SPEC =
      """
      {"format": "simbad-batch/1", "obstacles": ["round"], "sensors": ["original", "shadow"],
       "controllers": [{"name": "edge-follower"}], "speeds_m_per_s": [0.5], "seeds": [1]}
      """;

  @TempDir
  @SuppressWarnings("NullAway.Init")
  private static Path folder;

  @SuppressWarnings("NullAway.Init")
  private static Typist typist;

  @BeforeAll
  static void write() throws Exception {
    assumeTrue(Browser.isThere(), "no Chromium on this machine: the pages are not looked at");
    assertEquals(0, Shell.simbad("docs", "--out", folder.resolve("site").toString()).status());
    String run = folder.resolve("run").toString();
    assertEquals(0, Shell.simbad("run", "angle", "--speed", "0.3", "--out", run).status());
    Path spec = Files.writeString(folder.resolve("spec.json"), SPEC);
    String batch = folder.resolve("batch").toString();
    Shell shell = Shell.simbad("batch", spec.toString(), "--out", batch);
    assertEquals(0, shell.status(), shell.err());
    typist = Typist.before(page("run/report.html"), folder);
  }

  @AfterAll
  static void close() {
    if (typist != null) {
      typist.close();
    }
  }

  private static URI page(String name) {
    return folder.resolve(name).toUri();
  }

  @ParameterizedTest
  @CsvSource({
    "site/index.html, 1280, false",
    "site/index.html, 390, true",
    "site/docs/guide/diagnose.html, 390, false",
    "site/docs/performance.html, 1280, true",
    "run/report.html, 1280, true",
    "run/report.html, 390, false",
    "run/report.html, 2560, false",
    "batch/report.html, 1280, false",
    "batch/report.html, 390, true"
  })
  void page_isWholeAndForEverybody(String page, int width, boolean dark) throws Exception {
    typist.show(width, dark);
    typist.open(page(page));
    assertEquals("[]", typist.faults());
  }

  @ParameterizedTest
  @CsvSource({"run/report.html", "batch/report.html"})
  void report_isSmall(String page) throws Exception {
    long bytes = Files.size(folder.resolve(page));
    assertTrue(bytes <= MOST_BYTES, bytes + " bytes");
  }

  /** The angle's lobes are cut at this speed: drawn, marked, and read where one points. */
  @Test
  void cutLobe_isSeenBesideItsError() throws Exception {
    typist.show(1280, false);
    typist.open(page("run/report.html"));
    String errors = "figure:nth-of-type(2)";
    assertEquals("1", typist.look("document.querySelectorAll('" + errors + " .lobe').length / 2"));
    assertTrue(
        Integer.parseInt(typist.look("document.querySelectorAll('" + errors + " .cut').length"))
            > 2);
    typist.look("document.querySelector('" + errors + " .view').focus()");
    typist.press("Home");
    typist.press("ArrowRight");
    String said = typist.look("document.querySelector('" + errors + " output').textContent");
    assertTrue(
        said.matches(
            "bearing, degrees 5, threshold, cm 288\\.0, original error, cm [\\d.]+, shadow error, cm [\\d.]+"),
        said);
  }
}
