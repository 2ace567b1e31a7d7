package simbad.gap.audit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import simbad.gap.fixture.Logs;
import simbad.sonar.fixture.Untimed;
import simbad.sonar.frame.Pose;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.Reading;
import simbad.sonar.sensing.ReadingRow;

/**
 * Rows beside what the scene says of them: before a board, with steps of 5 mm and noise of 3 mm, so
 * that a reading may be 5 + 6 * 3 = 23 mm off, and 5 cm and 7 % of the distance beside.
 */
class AuditViewTest {
  private static final double AHEAD = Math.PI / 2;

  private static ReadingRow row(double timeS, double distanceM, Reading reading) {
    return new ReadingRow("r", "s", timeS, Pose.of(0, distanceM, AHEAD), reading);
  }

  private static AuditView view(ReadingRow... rows) {
    return new AuditView(Logs.BOARD, List.of(rows));
  }

  /** Readings at a distance each. */
  private static AuditView read(double[] distancesM, double[] rangesM) {
    ReadingRow[] rows = new ReadingRow[distancesM.length];
    Arrays.setAll(rows, i -> row(i, distancesM[i], new Echo(rangesM[i])));
    return view(rows);
  }

  // ---------------------------------------------------------------- order

  @Test
  void rows_standByRunSensorTimePoseAndReading() {
    Pose near = Pose.of(0, 1, 0);
    Pose far = Pose.of(1, 1, 0);
    List<ReadingRow> sorted =
        List.of(
            new ReadingRow("a", "l", 2, near, NoEcho.NO_ECHO),
            new ReadingRow("a", "r", 1, near, NoEcho.NO_ECHO),
            new ReadingRow("b", "l", 0, near, NoEcho.NO_ECHO),
            new ReadingRow("b", "l", 1, near, new Echo(1)),
            new ReadingRow("b", "l", 1, near, new Echo(2)),
            new ReadingRow("b", "l", 1, Pose.of(0, 1, 1), new Echo(0.5)),
            new ReadingRow("b", "l", 1, Pose.of(0, 2, 0), new Echo(0.5)),
            new ReadingRow("b", "l", 1, far, new Echo(0.5)));
    int[] file = {3, 7, 0, 5, 1, 6, 2, 4};
    List<ReadingRow> rows = new ArrayList<>();
    for (int at : file) {
      rows.add(sorted.get(at));
    }
    AuditView view = new AuditView(Logs.BOARD, rows);
    assertEquals(8, view.size());
    for (int i = 0; i < 8; i++) {
      assertEquals(sorted.get(i), view.row(i), "row " + i);
      assertEquals(i, file[view.inFile(i)]);
    }
    assertEquals(rows, view.rows());
    // Rows 0, 3 and 1 of the view stand in lines 2, 0 and 4.
    assertEquals(List.of(0, 2, 4), view.inFile(IntStream.of(0, 3, 1)));
    assertEquals(
        List.of(0, 1, 2, 2, 2, 2, 2, 2), IntStream.range(0, 8).mapToObj(view::begin).toList());
    assertEquals(
        List.of(false, false, false, true, true, true, true, true, false),
        IntStream.range(0, 9).mapToObj(view::follows).toList());
  }

  @Test
  void withoutTimes_noRowFollows() {
    List<ReadingRow> rows = new ArrayList<>();
    for (int i = 0; i < 3; i++) {
      rows.add(row(0, 1 + i, new Echo(1)).at(Pose.of(0, 1 + i, AHEAD), Untimed.ROW));
    }
    AuditView view = new AuditView(Logs.BOARD, rows);
    assertEquals(List.of(0, 1, 2), IntStream.range(0, 3).mapToObj(view::begin).toList());
    assertFalse(view.follows(1));
  }

  // ---------------------------------------------------------------- ranges

  @Test
  void ranges_areThoseOfEchoes() {
    AuditView view = view(row(0, 1, new Echo(1.2)), row(1, 1, NoEcho.NO_ECHO));
    assertEquals(1.2, view.rangeM(0));
    assertTrue(view.isEcho(0) && !view.isEcho(1) && Double.isNaN(view.rangeM(1)));
    assertEquals(List.of(0), view.echoes().boxed().toList());
    assertEquals(1.2, view.asM(0));
    // Twice too long and 20 cm more: half a metre is meant.
    AuditView along = view.along(new RobustLine(2, 0.2, 0, 1));
    assertEquals(0.5, along.asM(0), 1e-12);
    assertEquals(1.2, along.rangeM(0));
    assertEquals(view.rows(), along.rows());
    assertSame(Logs.BOARD, along.setup());
  }

  /** Ways of 1, 1, 3 and 9 cm have a middle of 2; equal values are one. */
  @Test
  void step_isTheMedianWay_orTheSensors() {
    double[] one = {1, 1, 1, 1, 1, 1};
    assertEquals(0.02, read(one, new double[] {1, 1.01, 1.02, 1.05, 1.14, 1.14}).stepM(), 1e-9);
    assertEquals(0.005, read(one, new double[] {1, 1.001, 1.002, 1.003, 1.004, 1.005}).stepM());
    assertEquals(0.005, view(row(0, 1, new Echo(1))).stepM());
    assertEquals(0.005, view(row(0, 1, NoEcho.NO_ECHO)).stepM());
  }

  @Test
  void tolerances_areThoseOfSensorPlaceAndAir() {
    AuditView view = view(row(0, 1, new Echo(1)));
    assertEquals(0.023, view.scatterM(), 1e-12);
    assertEquals(Math.sqrt(9e-6 + 25e-6 / 12), view.noiseM(), 1e-12);
    assertEquals(0.023 + 0.05 + 0.14, view.toleranceM(2), 1e-12);
    assertTrue(view.isOf(2, 2.2129) && view.isOf(2, 1.7871));
    assertFalse(view.isOf(2, 2.2131) || view.isOf(2, 1.7869));
    assertFalse(view.isOf(Double.POSITIVE_INFINITY, 2), "nowhere");
  }

  /** At 1 m and 1.143 m one value may be read, at 1.144 m it is no distance any more. */
  @Test
  void valueReadEverywhere_isNoDistance() {
    assertFalse(read(new double[] {1, 1.1429}, new double[] {0.9, 0.9}).isEverywhere(0));
    AuditView far = read(new double[] {1, 1.1431, 1.05}, new double[] {0.9, 0.9, 0.8});
    assertTrue(far.isEverywhere(0) && far.isEverywhere(1) && !far.isEverywhere(2));
    assertFalse(
        read(new double[] {1, 6}, new double[] {0.9, 0.9}).isEverywhere(0),
        "nothing is expected beyond the reach");
  }

  // ---------------------------------------------------------------- scene

  /** The board's front is at z = 0, and it reaches 60 cm to either side. */
  @Test
  void expected_isWhatIsHeardAhead() {
    AuditView view =
        view(
            row(0, 1, NoEcho.NO_ECHO),
            row(1, 4.1, NoEcho.NO_ECHO),
            new ReadingRow("r", "s", 2, Pose.of(0, 1, -AHEAD), NoEcho.NO_ECHO));
    assertEquals(1, view.expectedM(0), 1e-9);
    assertTrue(view.isExpected(0));
    assertFalse(view.isExpected(1), "beyond 4 m");
    assertFalse(view.isExpected(2), "behind");
    assertTrue(view.isInCone(0, 1.1) && !view.isInCone(0, 1.2));
    assertTrue(view.isInCone(1, 4.1) && !view.isInCone(2, 1));
    assertTrue(view.isAround(2, 1) && !view.isAround(2, 1.2));
    assertEquals(1, view.nearestM(2), 1e-9);
    assertEquals(0, view.obstacleAt(2, 7));
    assertEquals(6, view.offM(2, 0, 7), 1e-9);
  }

  /** From between two boxes of the room: one at 0.4 m, one at 1 m. */
  @Test
  void obstacle_isTheOneAtThatDistance() {
    // Boxes from -0.1 to 0.1 and from 1.2 to 1.8 m along x, where the second has z of 0.6 m.
    Pose pose = Pose.of(0.5, 0, 0);
    ReadingRow row = new ReadingRow("r", "s", 0, pose, new Echo(0.5));
    AuditView view = new AuditView(Logs.ROOM, List.of(row));
    double second = Math.hypot(0.7, 0.55);
    assertEquals(0.4, view.nearestM(0), 1e-9);
    assertEquals(0, view.obstacleAt(0, 0.5));
    assertEquals(1, view.obstacleAt(0, 0.9));
    assertEquals(Math.abs(0.9 - second), view.offM(0, 1, 0.9), 1e-9);
    assertEquals(3, view.outlines().size());
    AuditView empty =
        new AuditView(new SensingSetup(Logs.ROOM.sensor(), new Scene(List.of()), 4), List.of(row));
    assertEquals(-1, empty.obstacleAt(0, 0.5));
    assertEquals(Double.POSITIVE_INFINITY, empty.nearestM(0));
    assertFalse(empty.isAround(0, 0.4) || empty.isExpected(0));
  }

  // ---------------------------------------------------------------- rests

  /** Distances of 1 m to 2 m, each read so much too long. */
  private static Rest rest(RobustLine line, double slope, double... off) {
    double[] distances = new double[off.length];
    double[] ranges = new double[off.length];
    for (int i = 0; i < off.length; i++) {
      distances[i] = 1 + (double) i / off.length;
      ranges[i] = slope * distances[i] + off[i];
    }
    return new Rest(read(distances, ranges), line);
  }

  /** By 1 cm to either side, and one by 1 m: that is no scatter. */
  @Test
  void rest_isOffTheMiddle_andScattersAsMostDo() {
    double[] off = new double[11];
    Arrays.setAll(off, i -> 0.3 + (i % 2 == 0 ? -0.01 : 0.01));
    off[10] = 1.3;
    Rest rest = rest(RobustLine.IDENTITY, 1, off);
    // Of 5, 5 and 1 values the middle is 0.31: two centimetres below it lie five.
    assertEquals(-0.02, rest.offM(0), 1e-9);
    assertEquals(0, rest.offM(1), 1e-9);
    assertEquals(0.99, rest.offM(10), 1e-9);
    double noise = Math.sqrt(5 * 4e-4 / 10);
    assertEquals(noise, rest.noiseM(), 1e-9);
    assertEquals(4 * noise, rest.coreM(), 1e-9);
    assertTrue(rest.isRight(0) && !rest.isOff(0) && rest.isOff(10) && !rest.isRight(10));
    assertEquals(List.of(10), rest.off().boxed().toList());
  }

  /** What scatters less than the sensor does scatters as the sensor does. */
  @Test
  void rest_scattersAsBelieved_atLeast() {
    Rest rest = rest(RobustLine.IDENTITY, 1, 0, 0.001, -0.001, 0, 0.05);
    double noise = Math.sqrt(9e-6 + 25e-6 / 12);
    assertEquals(noise, rest.noiseM(), 1e-12);
    assertTrue(rest.isOff(4) && rest.isRight(1));
  }

  /** A line is taken away where most are on it and its slope is known to what air does. */
  @Test
  void rest_isOffTheLine_ifItIsOne() {
    double[] none = new double[9];
    assertEquals(0, rest(new RobustLine(0.5, 0.3, 0.07, 0.7), 0.5, none).offM(8), 1e-9);
    double most = -0.5 * (4 / 9.0);
    for (RobustLine no :
        List.of(
            new RobustLine(0.5, 0, 0.071, 1),
            new RobustLine(0.5, 0, 0, 0.69),
            new RobustLine(-0.5, 0, 0, 1))) {
      assertEquals(most, rest(no, 0.5, none).offM(8), 1e-9, no.toString());
    }
  }

  @Test
  void rest_knowsEchoesOfTheSceneAlone() {
    Rest rest =
        new Rest(
            view(row(0, 1, new Echo(1)), row(1, 1, NoEcho.NO_ECHO), row(2, 6, new Echo(3))),
            RobustLine.IDENTITY);
    assertTrue(rest.isKnown(0) && !rest.isKnown(1) && !rest.isKnown(2));
    assertFalse(rest.isRight(1) || rest.isOff(1));
  }

  // ---------------------------------------------------------------- lines

  /**
   * Four points at 1 to 4: squares of 5 about their middle. Two degrees of freedom, 95 %: 4.30265
   * deviations, of 1 mm and half a tenth.
   */
  @Test
  void line_isKnownToItsScatter() {
    double[] x = {1, 2, 3, 4};
    RobustLine exact = RobustLine.through(x, new double[] {3, 5, 7, 9}, 0.001, 0.05);
    assertEquals(2, exact.slope(), 1e-9);
    assertEquals(1, exact.offset(), 1e-9);
    assertEquals(1, exact.share());
    assertEquals(4.30265 * 0.00105 / Math.sqrt(5), exact.halfWidth(), 1e-7);
    // On a flatter line points scatter less.
    RobustLine flat = RobustLine.through(x, new double[] {1, 1.5, 2, 2.5}, 0.001, 0.05);
    assertEquals(4.30265 * 0.00055 / Math.sqrt(5), flat.halfWidth(), 1e-7);
    // Off by 1, -1, -1 and 1 cm, no slope: a sum of squares of 4 cm^2 over two.
    RobustLine rough = RobustLine.through(x, new double[] {0.01, -0.01, -0.01, 0.01}, 0.01, 0.05);
    assertEquals(0, rough.slope(), 1e-9);
    assertEquals(0, rough.offset(), 1e-9);
    assertEquals(4.30265 * Math.sqrt(2e-4) / Math.sqrt(5), rough.halfWidth(), 1e-6);
  }

  /** Further off than 3.5 times 1.05 mm. */
  @Test
  void point_isOnTheLine_ifItIsNear() {
    double[] x = {1, 2, 3, 4, 5, 6, 7};
    double[] y = {1, 2, 3, 4.0036, 5, 6, 7};
    assertEquals(1, RobustLine.through(x, y, 0.001, 0.05).share());
    y[3] = 4.0038;
    assertEquals(6 / 7.0, RobustLine.through(x, y, 0.001, 0.05).share(), 1e-12);
  }

  @Test
  void threePoints_areNoLine() {
    RobustLine none =
        RobustLine.through(new double[] {1, 2, 3}, new double[] {1, 2, 3}, 0.001, 0.05);
    assertTrue(Double.isNaN(none.slope()));
    assertEquals(0, none.share());
    assertEquals(Double.POSITIVE_INFINITY, none.halfWidth());
    double[] same = {2, 2, 2, 2, 2};
    assertEquals(0, RobustLine.through(same, new double[] {1, 2, 3, 4, 5}, 0.001, 0.05).share());
  }
}
