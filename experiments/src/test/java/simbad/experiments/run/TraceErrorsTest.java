package simbad.experiments.run;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.OptionalDouble;
import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Test;
import simbad.sonar.shape.ThresholdTable;

/** Errors of traces made by hand against tables of eight bearings and more. */
class TraceErrorsTest {
  private static final double STEP_S = 0.05;
  private static final int MANY = 7200;

  /** A place on a bearing, (r sin b, r cos b). */
  private static void add(Trace trace, double bearingDeg, double radius) {
    double bearing = Math.toRadians(bearingDeg);
    trace.add(radius * Math.sin(bearing), radius * Math.cos(bearing), 0, false);
  }

  /** Once round and a little more, counter-clockwise, on the edge from the first place. */
  private static Trace round(DoubleUnaryOperator radiusAtDeg) {
    Trace trace = new Trace(STEP_S);
    for (int i = 0; i <= MANY + 5; i++) {
      double bearing = i * 360.0 / MANY - 0.02;
      add(trace, bearing, radiusAtDeg.applyAsDouble(bearing));
      if (i == 0) {
        trace.edgeFound();
      }
    }
    return trace;
  }

  private static TraceErrors errors(Trace trace, double... thresholds) {
    return TraceErrors.of(trace, ThresholdTable.of(thresholds));
  }

  /**
   * A trace that visits the table's own points and nothing else lies on its edge; places that lie
   * exactly on a bearing but for rounding are each counted.
   */
  @Test
  void perfectTrace_hasNoError() {
    double[] table = {1, 0.5, 2, 0.3, 1, 1.5, 0.7, 0.2};
    Trace trace = new Trace(STEP_S);
    for (int i = 0; i <= 9; i++) {
      add(trace, 45 * i, table[i % 8]);
      if (i == 0) {
        trace.edgeFound();
      }
    }
    TraceErrors errors = errors(trace, table);
    assertEquals(0, errors.unreachedBearings());
    assertEquals(0, errors.meanM().orElseThrow(), 1e-12);
    assertEquals(0, errors.maxM().orElseThrow(), 1e-12);
    assertEquals(0, errors.lateralMaxM(), 1e-12);
  }

  /**
   * One centimetre outside the circle of a table of 720 bearings at 2 m: 1 cm radially at each
   * bearing. To the edge it is 1 cm at a corner, and in the middle of a straight piece more by the
   * piece's depth, 2 (1 - cos 0.25 degrees) = 0.019 mm.
   */
  @Test
  void oneCentimetreOutside_isOneCentimetre() {
    TraceErrors errors = TraceErrors.of(round(bearing -> 2.01), ThresholdTable.uniform(720, 2));
    assertEquals(0, errors.unreachedBearings());
    assertEquals(0.01, errors.meanM().orElseThrow(), 1e-6);
    assertEquals(0.01, errors.rmsM().orElseThrow(), 1e-6);
    assertEquals(0.01, errors.medianM().orElseThrow(), 1e-6);
    assertEquals(0.01, errors.maxM().orElseThrow(), 1e-6);
    assertEquals(0.01, errors.lateralMeanM(), 2e-5);
    assertEquals(0.01, errors.lateralP95M(), 2e-5);
    assertEquals(0.01, errors.lateralMaxM(), 2e-5);
  }

  /**
   * A lobe of 3 m at bearing 180 among thresholds of 1 m, cut off along the circle: every bearing
   * is crossed, and the trace lies beside the edge nearly everywhere. Only the other way round does
   * it show: the lobe's sides are 2 m long each and its end is 2 m away.
   */
  @Test
  void lobeThatIsCutOff_isSeenFromTheEdge() {
    double[] table = new double[72];
    Arrays.fill(table, 1);
    table[36] = 3;
    TraceErrors errors = TraceErrors.of(round(bearing -> 1), ThresholdTable.of(table));
    assertEquals(0, errors.unreachedBearings());
    assertTrue(errors.lateralMeanM() < 0.01, "beside the edge: " + errors.lateralMeanM());
    EdgeKept edge = errors.edge();
    double sides = 2 * Math.sqrt(1 + 9 - 6 * Math.cos(Math.toRadians(5)));
    double circle = 70 * 2 * Math.sin(Math.toRadians(2.5));
    assertEquals(circle / (circle + sides), edge.share().orElseThrow(), 0.02);
    assertEquals(2, edge.maxM().orElseThrow(), 0.01);
    assertTrue(edge.isLost());
    Arc arc = edge.skipped().get(0);
    assertEquals(1, edge.skipped().size());
    assertEquals(175, Math.toDegrees(arc.fromRad()), 0.6);
    assertEquals(185, Math.toDegrees(arc.toRad()), 0.6);
    assertEquals(sides, arc.lengthM(), 0.15);
  }

  @Test
  void edgeThatIsKept_isKeptWhole() {
    TraceErrors errors = TraceErrors.of(round(bearing -> 1.01), ThresholdTable.uniform(720, 1));
    assertEquals(1, errors.edge().share().orElseThrow());
    assertEquals(0.01, errors.edge().maxM().orElseThrow(), 1e-4);
    assertEquals(List.of(), errors.edge().skipped());
    assertFalse(errors.edge().isLost());
  }

  /** Inside counts as outside does: errors are absolute. */
  @Test
  void oneCentimetreInside_isOneCentimetre() {
    TraceErrors errors = TraceErrors.of(round(bearing -> 1.99), ThresholdTable.uniform(720, 2));
    assertEquals(0.01, errors.meanM().orElseThrow(), 1e-6);
    assertEquals(0.01, errors.lateralMeanM(), 2e-5);
  }

  /** Bearing 90 is crossed at 1.1, 1.2 and 0.6 m; its threshold is 1: (0.1 + 0.2 + 0.4) / 3. */
  @Test
  void bearingCrossedThreeTimes_isAveraged() {
    double[][] zigzag = {{80, 1.1}, {100, 1.1}, {100, 1.2}, {80, 1.2}, {80, 0.6}, {100, 0.6}};
    Trace trace = onEdgeFromTheFirst(zigzag);
    // A chord between two places of one radius, 10 degrees to either side, is nearer by cos 10.
    TraceErrors errors = errors(trace, 1, 1, 1, 1, 1, 1, 1, 1);
    assertEquals(0.7 / 3, errors.radialM().get(2).orElseThrow(), 1e-9);
    assertEquals(7, errors.unreachedBearings());
  }

  private static Trace onEdgeFromTheFirst(double[][] places) {
    Trace trace = new Trace(STEP_S);
    for (int i = 0; i < places.length; i++) {
      add(trace, places[i][0], places[i][1] / Math.cos(Math.toRadians(10)));
      if (i == 0) {
        trace.edgeFound();
      }
    }
    return trace;
  }

  /** A place that lies on a bearing belongs to one of the two ways that meet there. */
  @Test
  void placeOnABearing_isCountedOnce() {
    Trace trace = new Trace(STEP_S);
    add(trace, 80, 1);
    trace.edgeFound();
    add(trace, 90, 1.5);
    add(trace, 100, 9);
    TraceErrors errors = errors(trace, 1, 1, 1, 1, 1, 1, 1, 1);
    assertEquals(0.5, errors.radialM().get(2).orElseThrow(), 1e-9);
  }

  /** Bearing 0 is crossed by ways from 350 to 10 degrees and back: no jump by a turn. */
  @Test
  void bearingZero_isCrossedLikeAnyOther() {
    double[][] places = {{350, 1.2}, {10, 1.2}, {-10, 1.4}};
    TraceErrors errors = errors(onEdgeFromTheFirst(places), 1, 1, 1, 1, 1, 1, 1, 1);
    assertEquals(7, errors.unreachedBearings());
    // First 1.2; then half-way between (1.2 sin 10 ...) and (1.4 ...): where x = 0, at the share
    // 1.2 / 2.6 from 1.2 to 1.4, which is 1.2 + 0.2 * 1.2 / 2.6 = 1.29231.
    assertEquals((0.2 + 0.2923077) / 2, errors.radialM().get(0).orElseThrow(), 1e-6);
  }

  /** Before the edge was found, nothing counts. */
  @Test
  void wayToTheEdge_doesNotCount() {
    Trace trace = new Trace(STEP_S);
    add(trace, 30, 5);
    add(trace, 60, 5);
    add(trace, 80, 1);
    trace.edgeFound();
    add(trace, 100, 1);
    TraceErrors errors = errors(trace, 1, 1, 1, 1, 1, 1, 1, 1);
    assertTrue(errors.radialM().get(1).isEmpty());
    assertTrue(errors.radialM().get(2).isPresent());
    // The two places lie at 1 m, between the polygon's corners (1 m) and sides (cos 22.5 = 0.92).
    assertTrue(errors.lateralMaxM() < 0.08, "far places are left out: " + errors.lateralMaxM());
  }

  @Test
  void edgeNeverFound_isReportedAsSuch() {
    Trace trace = new Trace(STEP_S);
    add(trace, 80, 1);
    add(trace, 100, 1);
    assertEquals(2, trace.firstOnEdge());
    assertFalse(trace.isClosed());
    TraceErrors errors = errors(trace, 1, 1, 1, 1);
    assertEquals(4, errors.unreachedBearings());
    assertEquals(OptionalDouble.empty(), errors.meanM());
    assertEquals(OptionalDouble.empty(), errors.rmsM());
    assertEquals(OptionalDouble.empty(), errors.medianM());
    assertEquals(OptionalDouble.empty(), errors.maxM());
    assertEquals(0, errors.lateralMeanM());
  }

  @Test
  void emptyTrace_isAsIfTheEdgeWasNeverFound() {
    assertEquals(3, errors(new Trace(STEP_S), 1, 1, 1).unreachedBearings());
  }

  /** Errors of 1, 2, 3 and 6 m: mean 3, mean square 50/4, median 2.5. */
  @Test
  void statistics_areOverTheReachedBearings() {
    TraceErrors errors =
        new TraceErrors(
            List.of(
                OptionalDouble.of(1),
                OptionalDouble.of(6),
                OptionalDouble.empty(),
                OptionalDouble.of(3),
                OptionalDouble.of(2)),
            0,
            0,
            0,
            EdgeKept.of(new Trace(STEP_S), ThresholdTable.of(0, 0, 0)));
    assertEquals(3, errors.meanM().orElseThrow());
    assertEquals(Math.sqrt(12.5), errors.rmsM().orElseThrow(), 1e-12);
    assertEquals(2.5, errors.medianM().orElseThrow());
    assertEquals(6, errors.maxM().orElseThrow());
    assertEquals(1, errors.unreachedBearings());
  }

  /** More places than the first capacity. */
  @Test
  void trace_grows() {
    Trace trace = new Trace(STEP_S);
    for (int i = 0; i < 70_000; i++) {
      trace.add(i, -i, 1e-3 * i, i % 2 == 0);
    }
    assertEquals(70_000, trace.size());
    assertEquals(69_999, trace.xM(69_999));
    assertEquals(-69_999, trace.zM(69_999));
    assertEquals(69.999, trace.headingRad(69_999), 1e-9);
    assertFalse(trace.heard(69_999));
    assertTrue(trace.heard(0));
    assertEquals(3500, trace.timeS(69_999), 1e-6);
  }
}
