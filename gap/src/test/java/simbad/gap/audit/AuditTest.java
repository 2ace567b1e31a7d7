package simbad.gap.audit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.function.BiFunction;
import java.util.function.DoublePredicate;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simbad.gap.audit.AuditFinding.File;
import simbad.gap.fixture.Logs;
import simbad.sonar.frame.Pose;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.Reading;
import simbad.sonar.sensing.ReadingRow;

/** Each check where it just speaks, and one step below, where it must not. */
class AuditTest {
  private static final List<ReadingRow> LADDER = Logs.ladder(16, 1);
  private static final List<ReadingRow> DRIVE = Logs.drive(500, 1);

  private static List<AuditFinding> found(SensingSetup setup, List<ReadingRow> rows) {
    return Audit.of(setup, rows);
  }

  private static boolean has(AuditCheck check, SensingSetup setup, List<ReadingRow> rows) {
    return found(setup, rows).stream().anyMatch(one -> one.check() == check);
  }

  private static AuditFinding only(SensingSetup setup, List<ReadingRow> rows) {
    List<AuditFinding> found = found(setup, rows);
    assertEquals(1, found.size(), () -> "one finding in " + found);
    return found.get(0);
  }

  private static double rangeM(ReadingRow row) {
    return row.reading() instanceof Echo echo ? echo.rangeM() : Double.NaN;
  }

  private static ReadingRow with(ReadingRow row, Reading reading) {
    return new ReadingRow(row.run(), row.sensor(), row.timeS(), row.pose(), reading);
  }

  private static ReadingRow posed(ReadingRow row, Pose pose) {
    return new ReadingRow(row.run(), row.sensor(), row.timeS(), pose, row.reading());
  }

  private static ReadingRow timed(ReadingRow row, double timeS) {
    return new ReadingRow(row.run(), row.sensor(), timeS, row.pose(), row.reading());
  }

  /** Rows and their numbers. */
  private static List<ReadingRow> each(
      List<ReadingRow> rows, BiFunction<Integer, ReadingRow, ReadingRow> change) {
    List<ReadingRow> changed = new ArrayList<>();
    for (int i = 0; i < rows.size(); i++) {
      changed.add(change.apply(i, rows.get(i)));
    }
    return changed;
  }

  private static List<ReadingRow> ranges(List<ReadingRow> rows, DoubleUnaryOperator change) {
    return each(
        rows,
        (i, row) ->
            row.reading() instanceof NoEcho
                ? row
                : with(row, new Echo(Math.rint(1e4 * change.applyAsDouble(rangeM(row))) / 1e4)));
  }

  /** The first rows of which something holds get another range. */
  private static List<ReadingRow> first(
      int count, List<ReadingRow> rows, DoublePredicate which, DoubleUnaryOperator change) {
    int[] left = {count};
    return each(
        rows,
        (i, row) -> {
          boolean changes = which.test(rangeM(row)) && left[0]-- > 0;
          return changes ? with(row, new Echo(change.applyAsDouble(rangeM(row)))) : row;
        });
  }

  private static SonarSpec sensor(double halfAngleDeg, double maxRangeM, double soundMPerS) {
    SonarSpec old = Logs.BOARD.sensor();
    return new SonarSpec(
        old.name(),
        Math.toRadians(halfAngleDeg),
        old.minRangeM(),
        maxRangeM,
        old.mountHeightM(),
        soundMPerS,
        old.resolutionM(),
        old.rangeNoiseM(),
        old.missRate(),
        old.edgeWidthM(),
        old.updatePeriodS());
  }

  @Test
  void rightOnes_haveNoFinding() {
    assertEquals(List.of(), found(Logs.BOARD, LADDER));
    assertEquals(List.of(), found(Logs.ROOM, DRIVE));
    assertEquals(List.of(), Audit.of(Logs.BOARD, LADDER, Logs.ladder(8, 2)));
    assertEquals(List.of(), Audit.of(Logs.BOARD, List.of()));
  }

  /** Sound in air; what the vocabulary can make of it; a cone in radians; metres. */
  @ParameterizedTest
  @CsvSource({
    "343, 15, 4, -",
    "306, 15, 4, -",
    "305.9, 15, 4, WARN",
    "366, 15, 4, -",
    "366.1, 15, 4, WARN",
    "69, 15, 4, WARN",
    "68, 15, 4, REFUSE",
    "1716, 15, 4, REFUSE",
    "1e-300, 15, 4, REFUSE",
    "343, 0.5, 4, -",
    "343, 0.26, 4, WARN",
    "343, 15, 100, -",
    "343, 15, 101, WARN"
  })
  void constant_thatNoSonarHas(double sound, double halfAngleDeg, double maxM, String severity) {
    List<AuditFinding> found = ConstantCheck.of(sensor(halfAngleDeg, maxM, sound));
    assertEquals(
        severity,
        found.isEmpty() ? "-" : found.get(0).severity().name(),
        () -> String.valueOf(found));
    assertTrue(found.stream().allMatch(one -> one.file() == File.SCENE && one.rows().isEmpty()));
  }

  /** Air makes no factor of 1.1; five is the most that a constant of sound-speed makes. */
  @ParameterizedTest
  @CsvSource({
    "1, -",
    "1.1, -",
    "0.9, -",
    "1.2, WARN",
    "0.8, WARN",
    "0.3937, WARN",
    "2, WARN",
    "5, WARN",
    "5.6, REFUSE",
    "0.18, REFUSE",
    "100, REFUSE"
  })
  void unit_beyondAir(double factor, String severity) {
    List<AuditFinding> found = found(Logs.BOARD, ranges(LADDER, range -> factor * range));
    found = found.stream().filter(one -> one.check() == AuditCheck.UNIT).toList();
    assertEquals(severity, found.isEmpty() ? "-" : found.get(0).severity().name());
  }

  /** An offset is none, however large, nor is a limit, a knee or a board in the way. */
  @Test
  void unit_noOtherLine() {
    assertFalse(has(AuditCheck.UNIT, Logs.BOARD, ranges(LADDER, range -> range + 0.5)));
    assertFalse(has(AuditCheck.UNIT, Logs.BOARD, ranges(LADDER, range -> Math.max(range, 1.5))));
    assertFalse(has(AuditCheck.UNIT, Logs.BOARD, ranges(LADDER, range -> Math.min(range, 2.1))));
    assertFalse(
        has(
            AuditCheck.UNIT,
            Logs.BOARD,
            ranges(LADDER, range -> range < 2 ? range : 2 + (range - 2) / 2)));
    assertFalse(
        has(AuditCheck.UNIT, Logs.BOARD, ranges(LADDER, range -> range + 0.05 * range * range)));
  }

  @Test
  void unit_namesWhatUndoesIt() {
    AuditFinding inches = only(Logs.BOARD, ranges(LADDER, range -> range / 2.54 + 0.02));
    assertEquals("--scale 2.54", inches.mend());
    assertTrue(inches.what().endsWith("inches taken for centimetres"), inches.what());
    AuditFinding centimetres = only(Logs.BOARD, ranges(LADDER, range -> 98 * range));
    assertEquals("--scale 0.01", centimetres.mend());
    assertTrue(centimetres.refuses());
  }

  /** One distance, or two, and no line can be told from another. */
  @Test
  void unit_needsDistances() {
    List<ReadingRow> three =
        LADDER.stream().filter(row -> row.pose().position().zM() < 0.8).toList();
    assertEquals(
        3, three.stream().map(row -> row.pose().position().zM()).distinct().count(), "distances");
    assertFalse(has(AuditCheck.UNIT, Logs.BOARD, ranges(three, range -> 2 * range)));
  }

  /** Reach 4 m, 7 % of air, a step and six deviations of noise: 4.303 m. */
  @ParameterizedTest
  @CsvSource({"4.30, -", "4.31, WARN", "20, WARN", "20.1, WARN", "9999999, WARN"})
  void rangeLimit_beyondReach(double range, String severity) {
    List<AuditFinding> found = found(Logs.BOARD, first(1, LADDER, r -> r > 1, r -> range));
    assertEquals(severity, found.isEmpty() ? "-" : found.get(0).severity().name());
    assertTrue(found.stream().allMatch(one -> one.rows().size() == 1));
  }

  /** Of most readings beyond all that constants make, none is to be believed. */
  @Test
  void rangeLimit_ofMost() {
    int echoes = (int) LADDER.stream().filter(row -> rangeM(row) > 0).count();
    List<ReadingRow> most = first(echoes / 2 + 1, LADDER, r -> r > 0, r -> 30 + 100 * (r % 0.1));
    List<ReadingRow> fewer = first(echoes / 2, LADDER, r -> r > 0, r -> 30 + 100 * (r % 0.1));
    assertEquals(Severity.REFUSE, limit(most).severity());
    assertEquals("", limit(most).mend());
    assertEquals(Severity.WARN, limit(fewer).severity());
    assertEquals("--no-echo-above 4", limit(fewer).mend());
  }

  private static AuditFinding limit(List<ReadingRow> rows) {
    return found(Logs.BOARD, rows).stream()
        .filter(one -> one.check() == AuditCheck.RANGE_LIMIT)
        .findFirst()
        .orElseThrow();
  }

  /** Three are a code, two are none; 1.2345 says nothing. */
  @ParameterizedTest
  @CsvSource({"0, 2, false", "0, 3, true", "4, 2, false", "4, 3, true", "1.2345, 3, false"})
  void code_fromThreeOn(double value, int count, boolean isFound) {
    List<ReadingRow> rows =
        each(LADDER, (i, row) -> i >= LADDER.size() - count ? with(row, new Echo(value)) : row);
    assertEquals(isFound, has(AuditCheck.NO_ECHO_CODE, Logs.BOARD, rows));
  }

  /** What is cut off at 0 is near. */
  @Test
  void code_notOfWhatIsCutOff() {
    List<ReadingRow> rows = ranges(LADDER, range -> Math.max(0, range - 0.6));
    assertFalse(has(AuditCheck.NO_ECHO_CODE, Logs.BOARD, rows));
  }

  @Test
  void pile_ofAValueThatMeansNothing() {
    List<ReadingRow> rows =
        each(
            DRIVE,
            (i, row) ->
                row.reading() instanceof NoEcho && i % 5 == 0 ? with(row, new Echo(2.665)) : row);
    AuditFinding pile = only(Logs.ROOM, rows);
    assertEquals(AuditCheck.PILE, pile.check());
    assertEquals(Severity.NOTE, pile.severity());
    List<ReadingRow> few =
        each(
            DRIVE,
            (i, row) ->
                row.reading() instanceof NoEcho && i < 40 ? with(row, new Echo(2.665)) : row);
    assertEquals(List.of(), found(Logs.ROOM, few));
  }

  @ParameterizedTest
  @CsvSource({"2.55, true", "1.28, true", "3.9, false"})
  void wrap_whereSomethingIsBeyond(double end, boolean isFound) {
    assertEquals(isFound, has(AuditCheck.WRAP, Logs.BOARD, ranges(LADDER, range -> range % end)));
  }

  /** A board in the way stays where it is; a wrapped range moves with the distance. */
  @Test
  void wrap_notOfABoardInTheWay() {
    assertFalse(has(AuditCheck.WRAP, Logs.BOARD, ranges(LADDER, range -> Math.min(range, 1.9))));
  }

  /** Of 500 rows 2^-20 is the first chance below the level: twenty rows too many. */
  @ParameterizedTest
  @CsvSource({"16, false", "200, true"})
  void stuck_whenLongEnough(int count, boolean isFound) {
    int heard =
        IntStream.range(16, 32)
            .filter(i -> LADDER.get(i).reading() instanceof Echo)
            .max()
            .orElseThrow();
    Reading last = LADDER.get(heard).reading();
    List<ReadingRow> rows =
        each(LADDER, (i, row) -> i > heard && i < 32 + count ? with(row, last) : row);
    assertEquals(isFound, has(AuditCheck.STUCK, Logs.BOARD, rows));
  }

  /** A floor that answers wherever nothing stands before it reads one distance nearly always. */
  @ParameterizedTest
  @CsvSource({"20, false", "2, true"})
  void stuck_notOfAFloor(int nearer, boolean isFound) {
    int[] left = {nearer};
    List<ReadingRow> rows =
        each(
            DRIVE,
            (i, row) ->
                row.reading() instanceof Echo && i > 5 && left[0]-- > 0
                    ? row
                    : with(row, new Echo(1.4)));
    assertEquals(
        isFound,
        found(Logs.ROOM, rows).stream().anyMatch(one -> one.severity() == Severity.REFUSE));
  }

  /** A sensor before which nothing moves reads the same again and again. */
  @Test
  void stuck_notWhereNothingMoves() {
    Pose pose = Pose.of(0, 1, Math.PI / 2);
    List<ReadingRow> rows =
        each(LADDER, (i, row) -> with(posed(row, pose), new Echo(i < 200 ? 0.995 : 1)));
    assertFalse(has(AuditCheck.STUCK, Logs.BOARD, rows));
  }

  /**
   * Held for the rest of each gap, and not where gaps are one row long and the robot hardly moved.
   */
  @Test
  void held_whereTheSensorMovedOn() {
    List<ReadingRow> sorted =
        DRIVE.stream()
            .sorted(
                java.util.Comparator.comparing(ReadingRow::sensor).thenComparing(ReadingRow::timeS))
            .toList();
    List<ReadingRow> all = new ArrayList<>(sorted);
    List<ReadingRow> once = new ArrayList<>(sorted);
    for (int i = 1; i < all.size(); i++) {
      boolean follows = all.get(i).sensor().equals(all.get(i - 1).sensor());
      if (follows && all.get(i).reading() instanceof NoEcho) {
        all.set(i, with(all.get(i), all.get(i - 1).reading()));
        once.set(i, with(once.get(i), sorted.get(i - 1).reading()));
      }
    }
    assertTrue(has(AuditCheck.HELD, Logs.ROOM, all));
    assertFalse(has(AuditCheck.HELD, Logs.ROOM, once));
  }

  /** A timer's byte is 43.9 mm; seven jumps are enough, six are not; twice as far is no byte. */
  @ParameterizedTest
  @CsvSource({
    "7, 0.0439, WARN",
    "6, 0.0439, -",
    "9, 0.0878, NOTE",
    "9, -0.0439, WARN",
    "9, 0.02, -"
  })
  void jump_ofOneSize(int count, double off, String severity) {
    int[] left = {count};
    List<ReadingRow> rows =
        each(
            LADDER,
            (i, row) ->
                i % 16 == 7 && rangeM(row) > 0.2 && left[0]-- > 0
                    ? with(row, new Echo(rangeM(row) + off))
                    : row);
    List<AuditFinding> found = found(Logs.BOARD, rows);
    assertEquals(
        severity, found.isEmpty() ? "-" : found.get(0).severity().name(), () -> "" + found);
  }

  /** Now and then a clock goes back; rows that were sorted otherwise do so all the time. */
  @Test
  void clock_thatGoesBack() {
    List<ReadingRow> back =
        each(LADDER, (i, row) -> timed(row, row.timeS() - (i < 100 ? 0 : 1000)));
    AuditFinding found = only(Logs.BOARD, back);
    assertEquals(AuditCheck.CLOCK, found.check());
    assertEquals(List.of(100), found.rows());
    assertEquals(AuditCheck.CLOCK, found(Logs.BOARD, back.subList(80, 120)).get(0).check());
    List<ReadingRow> shuffled = new ArrayList<>(LADDER);
    Collections.shuffle(shuffled, new Random(1));
    assertEquals(List.of(), found(Logs.BOARD, shuffled));
  }

  @Test
  void clock_thatStandsStill() {
    // Two rows of one time and one reading would be one row twice.
    int last = 8;
    while (LADDER.get(last).reading().equals(LADDER.get(last + 1).reading())) {
      last++;
    }
    double tS = LADDER.get(last).timeS();
    int next = last + 1;
    List<ReadingRow> still = each(LADDER, (i, row) -> i == next ? timed(row, tS) : row);
    assertTrue(only(Logs.BOARD, still).what().startsWith("t_s stays at 1 row"));
    List<ReadingRow> twice = new ArrayList<>(LADDER);
    twice.add(40, LADDER.get(39));
    assertEquals("--drop-duplicates", only(Logs.BOARD, twice).mend());
  }

  @ParameterizedTest
  @CsvSource({
    "1, -",
    "1.2, -",
    "1.3, NOTE",
    "3, -",
    "0.5, NOTE",
    "1000, WARN",
    "1200, WARN",
    "1e6, WARN"
  })
  void period_besideTheSensors(double factor, String severity) {
    List<AuditFinding> found =
        found(Logs.BOARD, each(LADDER, (i, row) -> timed(row, factor * row.timeS())));
    assertEquals(severity, found.isEmpty() ? "-" : found.get(0).severity().name());
  }

  /** The box is 10 cm from its centre to its sides. */
  @ParameterizedTest
  @CsvSource({"0.101, false", "0.099, true"})
  void inside_anOutline(double x, boolean isFound) {
    List<ReadingRow> rows = new ArrayList<>(DRIVE);
    rows.add(new ReadingRow("run", "ahead", 1000, Pose.of(x, 0.02, 0), NoEcho.NO_ECHO));
    assertEquals(isFound, has(AuditCheck.INSIDE, Logs.ROOM, rows));
  }

  /** Whoever mends his places learns in the same breath that his ranges are wrong, too. */
  @Test
  void placesThatAreRefused_hideNoFaultOfTheRanges() {
    List<ReadingRow> rows =
        each(
            DRIVE,
            (i, row) ->
                with(posed(row, Pose.of(0.001 * (i % 9), 0.001, 0)), new Echo(500 + 0.01 * i)));
    assertTrue(
        found(Logs.ROOM, rows).stream()
            .anyMatch(one -> one.check() == AuditCheck.INSIDE && one.refuses()));
    assertTrue(
        found(Logs.ROOM, rows).stream().anyMatch(one -> one.check() == AuditCheck.RANGE_LIMIT));
  }

  @Test
  void still_onlyWhereReadingsMove() {
    Pose pose = Pose.of(0, 1, Math.PI / 2);
    List<ReadingRow> moving = each(LADDER, (i, row) -> posed(row, pose));
    AuditFinding found =
        found(Logs.BOARD, moving).stream()
            .filter(one -> one.check() == AuditCheck.STILL)
            .findFirst()
            .orElseThrow();
    assertEquals(Severity.WARN, found.severity());
    List<ReadingRow> steady = each(LADDER, (i, row) -> with(posed(row, pose), new Echo(1)));
    assertEquals(Severity.NOTE, only(Logs.BOARD, steady).severity());
  }

  /** Half of the poses right, and readings can be believed. */
  @Test
  void axes_whereNothingFits() {
    AuditFinding found =
        found(Logs.ROOM, each(DRIVE, (i, row) -> posed(row, flipped(row.pose())))).get(0);
    assertEquals(AuditCheck.AXES, found.check());
    assertEquals("--flip-z", found.mend());
    assertTrue(found.refuses());
    assertFalse(
        has(
            AuditCheck.AXES,
            Logs.ROOM,
            each(DRIVE, (i, row) -> i % 5 < 3 ? row : posed(row, flipped(row.pose())))));
  }

  private static Pose flipped(Pose pose) {
    return Pose.of(pose.position().xM(), -pose.position().zM(), pose.heading().radians());
  }

  @Test
  void reference_isAuditedAsWell() {
    AuditFinding found =
        Audit.of(Logs.BOARD, LADDER, ranges(Logs.ladder(16, 2), range -> 100 * range)).get(0);
    assertEquals(File.REFERENCE, found.file());
    assertTrue(found.refuses());
  }

  /** The worst stands first. */
  @Test
  void findings_areSorted() {
    List<ReadingRow> rows = first(20, LADDER, Double::isNaN, r -> 0);
    rows = ranges(rows, range -> 100 * range);
    List<Severity> severities =
        found(Logs.BOARD, rows).stream().map(AuditFinding::severity).toList();
    List<Severity> sorted = new ArrayList<>(severities);
    sorted.sort(Collections.reverseOrder());
    assertEquals(sorted, severities);
    assertEquals(Set.of(Severity.REFUSE, Severity.WARN), Set.copyOf(severities));
  }

  /** What is said, and of which rows, whatever their order. */
  @Test
  void order_changesNothing() {
    for (PostedFault fault : PostedFault.all()) {
      List<ReadingRow> rows =
          fault.spoil().spoil(DRIVE, Logs.ROOM.sensor(), new java.util.SplittableRandom(3));
      if (fault.check() != AuditCheck.CLOCK) {
        List<ReadingRow> shuffled = new ArrayList<>(rows);
        Collections.shuffle(shuffled, new Random(5));
        assertEquals(said(rows), said(shuffled), fault.name());
      }
    }
  }

  private static List<String> said(List<ReadingRow> rows) {
    return Audit.of(Logs.ROOM, rows).stream()
        .map(
            one ->
                one.what()
                    + one.rows().stream()
                        .map(row -> String.valueOf(rows.get(row)))
                        .sorted()
                        .collect(Collectors.joining()))
        .toList();
  }

  /** Whatever numbers stand in a file: an answer, and no row that is not there. */
  @Test
  void anyNumbers_areAudited() {
    double[] numbers = {0, 1e-300, 1e-9, 0.01, 1, 4, 6.5, 7.65, 255, 1e4, 1e7};
    Random random = new Random(11);
    for (int log = 0; log < 400; log++) {
      List<ReadingRow> rows = new ArrayList<>();
      int size = random.nextInt(60);
      for (int i = 0; i < size; i++) {
        double x = numbers[random.nextInt(numbers.length)] * (random.nextInt(3) - 1);
        double z = numbers[random.nextInt(numbers.length)] * (random.nextInt(3) - 1);
        double range = numbers[random.nextInt(numbers.length)];
        rows.add(
            new ReadingRow(
                "r" + random.nextInt(2),
                "s",
                random.nextInt(50),
                Pose.of(x, z, random.nextGaussian()),
                random.nextInt(3) == 0 ? NoEcho.NO_ECHO : new Echo(range)));
      }
      for (AuditFinding finding : Audit.of(Logs.ROOM, rows)) {
        assertTrue(finding.rows().stream().allMatch(row -> row >= 0 && row < size));
        assertFalse(finding.what().isEmpty());
      }
    }
  }
}
