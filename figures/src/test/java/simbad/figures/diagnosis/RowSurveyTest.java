package simbad.figures.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import simbad.definition.Effect;
import simbad.gap.diagnosis.DataSet;
import simbad.sonar.frame.Pose;
import simbad.sonar.ping.Change;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.ReadingRow;

class RowSurveyTest {
  private static final DataSet GRID = Samples.data("grid");

  /** Before one range for all bearings, forecasts are wrong; under the truth, ranks are even. */
  @Test
  void ranks_areEvenWhenTheForecastHolds() {
    List<ReadingRow> drawn = GRID.readings();
    DataSet data = new DataSet("one", GRID.setup(), drawn, List.of());
    List<RowFinding> rows = RowSurvey.of(data, List.of(), new SplittableRandom(3));
    double wrong = rows.stream().mapToDouble(row -> row.before().pit()).average().orElseThrow();
    assertTrue(wrong > 0.6, "echoes that did not come rank high: " + wrong);
    assertTrue(rows.stream().allMatch(row -> row.before().equals(row.after())));
    assertTrue(rows.stream().allMatch(row -> row.before().pit() >= 0 && row.before().pit() <= 1));
  }

  /** An offset of 10 cm in the model moves the residual and nothing else. */
  @Test
  void residual_isOfTheModel() {
    Change offset = Samples.form(Effect.RANGE_OFFSET, GRID).with(0.1);
    ReadingRow row = new ReadingRow("r", "s", 0, Pose.of(1, 0, Math.PI), new Echo(0.98));
    DataSet data = new DataSet("one", GRID.setup(), List.of(row), List.of());
    RowFinding finding = RowSurvey.of(data, List.of(offset), new SplittableRandom(3)).get(0);
    // The face of the one inch square is 0.9873 m away, read as 0.98 at the least.
    assertEquals(0, finding.before().residualCm().orElseThrow(), 1.01);
    assertEquals(-10, finding.after().residualCm().orElseThrow(), 1.01);
    assertEquals(1, finding.distanceM().orElseThrow(), 1e-12);
    assertEquals(90, finding.bearingDeg(), 1e-9);
    assertEquals(0, finding.offAxisDeg().orElseThrow(), 1e-9);
  }

  /**
   * The sensor looks away: no echo is expected, none comes, nothing is amiss; the bearing is known.
   */
  @Test
  void lookingAway_expectsNothing() {
    ReadingRow row = new ReadingRow("r", "s", 0, Pose.of(0, 1, -Math.PI / 2), NoEcho.NO_ECHO);
    DataSet data = new DataSet("one", GRID.setup(), List.of(row), List.of());
    RowFinding finding = RowSurvey.of(data, List.of(), new SplittableRandom(3)).get(0);
    assertEquals(0, finding.before().gapCm(), 1e-9);
    assertTrue(finding.before().residualCm().isEmpty());
    assertEquals(0, finding.bearingDeg(), 1e-9);
    assertEquals(180, finding.offAxisDeg().orElseThrow(), 1e-9);
  }

  @Test
  void quantile_isOfTheSortedValues() {
    assertEquals(3, RowSurvey.quantile(new double[] {3, 1, 2}, 0.98));
    assertEquals(1, RowSurvey.quantile(new double[] {3, 1, 2}, 0));
    assertEquals(0, RowSurvey.quantile(new double[0], 0.5));
  }
}
