package simbad.figures.diagnosis;

import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Path;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.figures.page.Browser;
import simbad.gap.diagnosis.DataSet;
import simbad.gap.diagnosis.Diagnosis;
import simbad.gap.diagnosis.Verdict;

/** The page in headless Chromium, in both themes and at three widths. */
class PageInBrowserTest {
  @TempDir private Path folder = Path.of("target");

  @ParameterizedTest
  @ValueSource(strings = {"explained", "none", "unexplained"})
  void page_isWhole(String verdict) throws Exception {
    assumeTrue(Browser.isThere(), "no Chromium on this machine: the page is not looked at");
    DataSet data = Samples.data("bench of a rather long name, 2026-11-21");
    new Browser(folder).look(Samples.page(diagnosis(verdict, data), data));
  }

  private static Diagnosis diagnosis(String verdict, DataSet data) {
    return verdict.equals("explained")
        ? Samples.explained(data)
        : Samples.without(verdict.equals("none") ? Verdict.NONE : Verdict.UNEXPLAINED, data);
  }
}
