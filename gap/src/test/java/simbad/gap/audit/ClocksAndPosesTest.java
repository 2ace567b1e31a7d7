package simbad.gap.audit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.DoubleUnaryOperator;
import java.util.function.IntPredicate;
import java.util.function.IntToDoubleFunction;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simbad.gap.audit.AuditFinding.File;
import simbad.gap.fixture.Logs;
import simbad.sonar.frame.Placement;
import simbad.sonar.frame.Point;
import simbad.sonar.frame.Pose;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.UniformDetection;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.ReadingRow;
import simbad.sonar.shape.Outline;

/** Clocks, poses and limits, each just below what is found and just beyond, with what is said. */
class ClocksAndPosesTest {
  private static AuditView timed(int rows, IntToDoubleFunction timeS) {
    List<ReadingRow> all = new ArrayList<>();
    for (int i = 0; i < rows; i++) {
      Pose pose = Pose.of(0, 1 + 0.01 * i, Math.PI / 2);
      all.add(new ReadingRow("r", "s", timeS.applyAsDouble(i), pose, new Echo(1 + 0.01 * i)));
    }
    return new AuditView(Logs.BOARD, all);
  }

  // ---------------------------------------------------------------- clocks

  /** A row is a second earlier than it should be. */
  private static List<AuditFinding> back(int rows, IntPredicate early) {
    return ClockCheck.of(timed(rows, i -> early.test(i) ? i - 1.5 : i));
  }

  @Test
  void clockThatGoesBack_doesSoNowAndThen() {
    assertEquals(List.of(7), back(20, i -> i == 7).get(0).rows());
    assertEquals(List.of(), back(19, i -> i == 7), "of nineteen rows it may be any order");
    assertEquals(List.of(), back(20, i -> i == 7 || i == 12), "twice in twenty rows");
    assertEquals(List.of(20, 70), back(100, i -> i == 20 || i == 70).get(0).rows());
    assertEquals(List.of(), back(100, i -> i % 30 == 20), "thrice in a hundred");
    assertEquals(List.of(), back(100, i -> false));
    AuditFinding found = back(20, i -> i == 7).get(0);
    assertEquals("t_s goes back at 1 row of a file in the order of time", found.what());
    assertEquals(AuditCheck.CLOCK, found.check());
    assertEquals(Severity.WARN, found.severity());
  }

  /** Each sensor of each run has its own clock. */
  @Test
  void clocks_areOfSequences() {
    List<ReadingRow> rows = new ArrayList<>();
    for (int i = 0; i < 80; i++) {
      double time = Math.floorDiv(i, 4) - (i == 41 || i == 62 ? 1.5 : 0);
      String run = i % 4 < 2 ? "a" : "b";
      String sensor = i % 2 == 0 ? "l" : "r";
      rows.add(new ReadingRow(run, sensor, time, Pose.of(0, 1, 0), NoEcho.NO_ECHO));
    }
    assertEquals(List.of(41, 62), ClockCheck.of(new AuditView(Logs.BOARD, rows)).get(0).rows());
  }

  @Test
  void rowsOfOneTime_areTheSameOrNot() {
    Pose pose = Pose.of(0, 1, 0);
    ReadingRow first = new ReadingRow("r", "s", 1, pose, new Echo(1));
    ReadingRow other = new ReadingRow("r", "s", 1, pose, new Echo(2));
    ReadingRow later = new ReadingRow("r", "s", 2, pose, new Echo(2));
    List<AuditFinding> found =
        ClockCheck.of(new AuditView(Logs.BOARD, List.of(later, other, first, first)));
    assertEquals(
        List.of(
            "1 row that are in the file twice",
            "t_s stays at 1 row, so the order of these rows is unknown"),
        found.stream().map(AuditFinding::what).toList());
    assertEquals(List.of(3), found.get(0).rows());
    assertEquals(List.of(1), found.get(1).rows());
    assertEquals(List.of("--drop-duplicates", ""), found.stream().map(AuditFinding::mend).toList());
    ReadingRow elsewhere = new ReadingRow("q", "s", 1, pose, new Echo(1));
    assertEquals(
        List.of(), ClockCheck.of(new AuditView(Logs.BOARD, List.of(first, elsewhere, later))));
  }

  // ---------------------------------------------------------------- periods

  private static Optional<AuditFinding> period(int rows, double times) {
    double step = times * Logs.BOARD.sensor().updatePeriodS();
    return new PeriodCheck(timed(rows, i -> step * i)).find();
  }

  /** Between a 1.5th and 1.5 times of a thousand or a million; else off a whole number. */
  @ParameterizedTest
  @CsvSource({
    "1, ''", "0.76, ''", "0.74, NOTE", "1.24, ''", "1.26, NOTE", "1.74, NOTE", "1.76, ''",
    "0.1, NOTE", "3, ''", "3.3, NOTE", "666, ''", "667, WARN", "1499, WARN", "1501, ''",
    "700000, WARN", "1.4e6, WARN", "1.6e6, ''"
  })
  void period_isTheSensors_orAMultiple(double times, String severity) {
    String found = period(30, times).map(one -> one.severity().name()).orElse("");
    assertEquals(severity, found);
  }

  @Test
  void period_isSaid() {
    AuditFinding milli = period(30, 1000).orElseThrow();
    assertEquals(
        "rows of a sensor are 60 s apart, where update_period_s = 0.06: t_s is not in seconds",
        milli.what());
    assertEquals("--time-scale 0.001", milli.mend());
    assertEquals(File.READINGS, milli.file());
    assertEquals("--time-scale 0.000001", period(30, 1e6).orElseThrow().mend());
    AuditFinding stated = period(30, 0.5).orElseThrow();
    assertEquals("update_period_s = 0.06, but rows of a sensor are 0.03 s apart", stated.what());
    assertEquals(File.SCENE, stated.file());
  }

  /** Twenty steps, of which the middle half differs by no more than a quarter. */
  @Test
  void period_isThatOfARegularClock() {
    assertTrue(period(20, 0.5).isEmpty());
    assertTrue(period(21, 0.5).isPresent());
    // Steps of 30 ms and of 30 ms more by turns of ten: quartiles of 30 and 37 or 38 ms.
    for (double more : new double[] {0.007, 0.008}) {
      DoubleUnaryOperator time = i -> 0.03 * i + more * Math.max(0, i - 26);
      boolean regular = new PeriodCheck(timed(41, i -> time.applyAsDouble(i))).find().isPresent();
      assertEquals(more < 0.0075, regular, more + " s");
    }
  }

  // ---------------------------------------------------------------- poses

  private static List<AuditFinding> poses(SensingSetup setup, List<Pose> poses) {
    List<ReadingRow> rows = new ArrayList<>();
    for (Pose pose : poses) {
      rows.add(new ReadingRow("r", "s", rows.size(), pose, NoEcho.NO_ECHO));
    }
    return PoseCheck.of(new AuditView(setup, rows));
  }

  /** An L of two arms of 1 m by 0.4 m, its corner at (2, 3). */
  private static SensingSetup corner() {
    Outline outline =
        Outline.of(
            List.of(
                new Point(0, 0),
                new Point(0, 1),
                new Point(0.4, 1),
                new Point(0.4, 0.4),
                new Point(1, 0.4),
                new Point(1, 0)));
    Obstacle obstacle = new Obstacle("L", new Placement(2, 3, 0), outline, new UniformDetection(2));
    return new SensingSetup(Logs.BOARD.sensor(), new Scene(List.of(obstacle)), 4);
  }

  @Test
  void inside_isBetweenTheSides() {
    double[][] in = {{2.2, 3.2}, {2.2, 3.9}, {2.9, 3.2}, {2.01, 3.01}, {2.39, 3.5}};
    double[][] out = {{2.5, 3.5}, {2.9, 3.9}, {1.9, 3.2}, {3.1, 3.2}, {2.2, 2.9}, {2.2, 4.1}};
    List<Pose> poses = new ArrayList<>();
    for (double[] at : out) {
      poses.add(Pose.of(at[0], at[1], 0));
    }
    assertEquals(List.of(), poses(corner(), poses));
    for (double[] at : in) {
      poses.add(Pose.of(at[0], at[1], 0));
    }
    AuditFinding found = poses(corner(), poses).get(0);
    assertEquals(AuditCheck.INSIDE, found.check());
    assertEquals(IntStream.range(6, 11).boxed().toList(), found.rows());
    assertEquals("5 rows with the sensor inside an obstacle's outline", found.what());
    assertEquals(Severity.WARN, found.severity());
    poses.add(Pose.of(2.3, 3.3, 0));
    assertEquals(Severity.WARN, poses(corner(), poses).get(0).severity(), "half of all");
    poses.add(Pose.of(2.3, 3.2, 0));
    assertEquals(Severity.REFUSE, poses(corner(), poses).get(0).severity());
  }

  private static List<AuditFinding> still(double... rangesM) {
    List<ReadingRow> rows = new ArrayList<>();
    for (double range : rangesM) {
      Pose pose = Pose.of(0, 1, Math.PI / 2);
      rows.add(new ReadingRow("r", "s", rows.size(), pose, new Echo(range)));
    }
    return PoseCheck.of(new AuditView(Logs.BOARD, rows));
  }

  /** Quartiles of ten are the third and the eighth; 23 mm are scatter. */
  @Test
  void still_isOnePoseOfTenEchoes() {
    assertEquals(List.of(), still(1, 1, 1, 1, 1, 1, 1, 1, 1));
    AuditFinding steady = still(1, 1, 1, 1, 1, 1.0229, 1.0229, 1.0229, 1.0229, 5).get(0);
    assertEquals("one pose in all rows", steady.what());
    assertEquals(Severity.NOTE, steady.severity());
    AuditFinding moving = still(1, 1, 1, 1, 1, 1, 1.5, 1.5, 1.5, 1.5).get(0);
    assertEquals("one pose in all rows, though readings differ by 0.5 m", moving.what());
    assertEquals(Severity.WARN, moving.severity());
    assertEquals(List.of(), moving.rows());
    assertEquals(Severity.WARN, still(1, 1, 1, 1, 1, 1, 1.0231, 2, 2, 2).get(0).severity());
  }

  // ---------------------------------------------------------------- limits

  private static Optional<AuditFinding> limit(double... rangesM) {
    List<ReadingRow> rows = new ArrayList<>();
    for (double range : rangesM) {
      Pose pose = Pose.of(0, 1 + 0.1 * rows.size(), Math.PI / 2);
      rows.add(new ReadingRow("r", "s", rows.size(), pose, new Echo(range)));
    }
    return new SensorLimitCheck(new AuditView(Logs.BOARD, rows)).find();
  }

  @Test
  void limit_isSaidWithWhatLeavesItOut() {
    AuditFinding one = limit(1, 1, 1, 4.31, 4.31).orElseThrow();
    assertEquals("2 readings of 4.31 m before max_range_m = 4, more than its reach", one.what());
    assertEquals("--no-echo 4.31", one.mend());
    assertEquals(List.of(3, 4), one.rows());
    AuditFinding two = limit(1, 1, 1, 4.31, 5).orElseThrow();
    assertEquals("2 readings of up to 5 m before max_range_m = 4, more than its reach", two.what());
    assertEquals("--no-echo-above 4", two.mend());
    AuditFinding most = limit(1, 21, 22).orElseThrow();
    assertEquals(
        "2 readings of up to 22 m before max_range_m = 4, which no sonar reads", most.what());
    assertEquals(Severity.REFUSE, most.severity());
    assertEquals("", most.mend());
    assertEquals(Severity.WARN, limit(1, 21).orElseThrow().severity(), "half of all");
    // Only what is beyond all constants counts, where there is some.
    assertEquals(List.of(1), limit(5, 21, 1, 1).orElseThrow().rows());
    assertTrue(limit(4.3, 1).isEmpty());
  }

  // ---------------------------------------------------------------- wraps

  private static Optional<AuditFinding> wrap(double stepM, int rows, DoubleUnaryOperator read) {
    List<ReadingRow> all = new ArrayList<>();
    for (int i = 0; i < rows; i++) {
      double distance = 0.5 + stepM * i;
      Pose pose = Pose.of(0, distance, Math.PI / 2);
      all.add(new ReadingRow("r", "s", i, pose, new Echo(read.applyAsDouble(distance))));
    }
    return new WrapCheck(new AuditView(Logs.BOARD, all)).find();
  }

  /**
   * From 0.5 m to 3.6 m in steps of 10 cm, again from 0 beyond 1.95 m: the greatest is 1.9 m, with
   * 206 mm of tolerance, so that those from 2.2 m on are beyond.
   */
  @Test
  void wrap_isWhatAllBeyondLack() {
    AuditFinding found = wrap(0.1, 32, d -> d % 1.95).orElseThrow();
    assertEquals(
        "15 readings too short by the same 1.95 m, and none longer: ranges start again from 0"
            + " there",
        found.what());
    assertEquals(IntStream.range(17, 32).boxed().toList(), found.rows());
    assertEquals(Severity.WARN, found.severity());
    assertTrue(wrap(0.1, 32, d -> d).isEmpty());
    assertTrue(wrap(0.1, 32, d -> Math.min(d, 1.9)).isEmpty(), "something in the way");
    assertTrue(wrap(0.1, 32, d -> d > 1.95 ? d - 0.9 : d).isEmpty(), "half of the greatest");
  }

  /** Five beyond, in steps of 30 cm; four say nothing. */
  @Test
  void wrap_isOfFive() {
    // 0.5 to 1.7 m, then 2.0, 2.3 and so on, where 1.7 and its tolerance end at 1.89 m.
    assertTrue(wrap(0.3, 10, d -> d % 1.8).isPresent());
    assertTrue(wrap(0.3, 9, d -> d % 1.8).isEmpty());
  }

  // ---------------------------------------------------------------- jumps

  /** Of sixty readings each sixth is a timer's byte too long: 256 us at 343 m/s, there and back. */
  private static Optional<AuditFinding> jumps(double offM, Set<Integer> told) {
    List<ReadingRow> rows = new ArrayList<>();
    for (int i = 0; i < 60; i++) {
      double distance = 1.2 + 0.045 * i;
      Pose pose = Pose.of(0, distance, Math.PI / 2);
      rows.add(new ReadingRow("r", "s", i, pose, new Echo(distance + (i % 6 == 3 ? offM : 0))));
    }
    AuditView view = new AuditView(Logs.BOARD, rows);
    return new JumpCheck(view, new Rest(view, RobustLine.IDENTITY), told).find();
  }

  @Test
  void jumps_areOfOneSize() {
    AuditFinding found = jumps(0.0439, Set.of()).orElseThrow();
    assertEquals(IntStream.range(0, 10).map(i -> 6 * i + 3).boxed().toList(), found.rows());
    assertEquals(Severity.WARN, found.severity());
    assertEquals(
        "10 readings alone among right ones are too long by the same 0.0439 m, as by a timer's byte"
            + " that is read while it turns over: 256 us of flight",
        found.what());
    AuditFinding metre = jumps(-1, Set.of()).orElseThrow();
    assertTrue(metre.what().contains("too short by the same 1 m, as when a number"), metre.what());
    assertEquals(Severity.NOTE, metre.severity());
    assertEquals(Optional.empty(), jumps(0, Set.of()));
  }

  /** Of rows of which something else was found nothing more is said; two are no jump. */
  @Test
  void jumps_areNotOfRowsThatWereToldOf() {
    Set<Integer> eight =
        IntStream.range(0, 8).mapToObj(i -> 6 * i + 3).collect(Collectors.toUnmodifiableSet());
    assertEquals(Optional.empty(), jumps(0.0439, eight));
    assertEquals(9, jumps(0.0439, Set.of(3)).orElseThrow().rows().size());
  }
}
