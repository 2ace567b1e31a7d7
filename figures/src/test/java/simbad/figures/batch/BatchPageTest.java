package simbad.figures.batch;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Collections;
import java.util.List;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import simbad.experiments.batch.BatchSurvey;
import simbad.experiments.batch.BatchSurvey.Group;
import simbad.experiments.batch.BatchSurvey.Wrong;

class BatchPageTest {
  private static final Group GOOD =
      new Group("a<b>", "shadow", 7, 0, 0, 0, OptionalDouble.of(1.234), OptionalDouble.of(5));
  private static final Wrong WRONG =
      new Wrong("3", "a<b>", "shadow", "e, 0.1 m/s", "x".repeat(9999));

  @Test
  void goodBatch_saysSo() {
    String page = BatchPage.of(new BatchSurvey(7, 0, List.of(GOOD), List.of()), "1");
    assertTrue(
        page.contains(
            "<strong>7 runs</strong>: all completed their round, and nothing went wrong."));
    assertTrue(page.contains("<h3>a&lt;b&gt;</h3>"), page);
    assertTrue(page.contains("<td class=\"n\">1.23</td>"), page);
    assertTrue(page.contains("<title>shadow: mean 1.23 cm, maximum 5.00 cm</title>"), page);
  }

  /** However many groups and however long their errors. */
  @Test
  void hugeBatch_isASmallPage() {
    BatchSurvey huge =
        new BatchSurvey(
            1_000_000, 5000, Collections.nCopies(5000, GOOD), Collections.nCopies(200, WRONG));
    String page = BatchPage.of(huge, "1");
    assertTrue(page.length() < 300_000, page.length() + " characters");
    assertTrue(page.contains("The first 200 are listed here; all are in results.csv."));
    assertEquals(page, BatchPage.of(huge, "1"));
  }
}
