package simbad.gap.audit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.gap.fixture.Logs;
import simbad.sonar.fixture.Untimed;
import simbad.sonar.frame.Pose;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.Reading;
import simbad.sonar.sensing.ReadingRow;

/**
 * Ladders of two columns, a distance and a reading: nobody knows which row came before, and yet
 * values tell that they are held, stuck or off by a timer's byte.
 */
class UntimedAuditTest {
  private static final Set<AuditCheck> NO_READING = Set.of(AuditCheck.STUCK, AuditCheck.HELD);
  private static final double BYTE_M = 0.0439;

  /** What a log's reading is, from its distance, what a right sensor reads there, and chance. */
  private interface Fault {
    double readM(double distanceM, double rightM, Random random);
  }

  /** Distances of a ladder of steps with repeats, or at random. */
  private static List<Double> distances(boolean random, int seed) {
    Random draw = new Random(seed);
    List<Double> all = new ArrayList<>();
    for (int i = 0; i < 240; i++) {
      all.add(random ? 0.1 + 2.9 * draw.nextDouble() : 0.2 + 0.1 * Math.floorDiv(i, 8));
    }
    return all;
  }

  /** Readings in steps, with scatter of 3 mm; infinity is read as no echo. */
  private static List<ReadingRow> log(boolean isRandom, double stepM, int seed, Fault fault) {
    Random random = new Random(seed);
    List<ReadingRow> rows = new ArrayList<>();
    for (double d : distances(isRandom, seed)) {
      double right = stepM * Math.rint((d + 0.003 * random.nextGaussian()) / stepM);
      double read = fault.readM(d, right, random);
      Reading reading =
          Double.isInfinite(read) ? NoEcho.NO_ECHO : new Echo(Math.rint(read * 1e4) / 1e4);
      rows.add(untimed(d, reading));
    }
    return rows;
  }

  private static ReadingRow untimed(double distance, Reading reading) {
    Pose pose = Pose.of(0, distance, Math.PI / 2);
    return new ReadingRow("run", "front", 0, pose, reading, Untimed.ROW);
  }

  private static List<AuditCheck> warnings(List<ReadingRow> rows) {
    return Audit.of(Logs.BOARD, rows).stream()
        .filter(one -> one.severity() != Severity.NOTE)
        .map(AuditFinding::check)
        .toList();
  }

  /** The value before, wherever it was, stays. */
  private static Fault heldBeyond(double limitM) {
    double[] last = {0.5};
    return (d, right, random) -> {
      last[0] = d > limitM ? last[0] : right;
      return last[0];
    };
  }

  private static Fault heldNowAndThen() {
    double[] last = {0.5};
    return (d, right, random) -> {
      last[0] = random.nextInt(4) == 0 ? last[0] : right;
      return last[0];
    };
  }

  /** Forty right logs of each sort are not warned of, be they written in millimetres or worse. */
  @ParameterizedTest
  @ValueSource(doubles = {0.001, 0.0017, 0.01})
  void rightOnes_areNotWarnedOf(double stepM) {
    for (int seed = 0; seed < 40; seed++) {
      for (boolean random : new boolean[] {false, true}) {
        List<ReadingRow> rows =
            log(
                random,
                stepM,
                seed,
                (d, right, r) -> d > 2.5 || r.nextInt(30) == 0 ? Double.POSITIVE_INFINITY : right);
        assertEquals(List.of(), warnings(rows), "seed " + seed + " random " + random);
      }
    }
  }

  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void held_beyondADistance(boolean random) {
    for (int seed = 0; seed < 20; seed++) {
      List<ReadingRow> rows = log(random, 0.001, seed, heldBeyond(1.8));
      List<AuditFinding> found =
          Audit.of(Logs.BOARD, rows).stream()
              .filter(one -> NO_READING.contains(one.check()))
              .toList();
      long beyond = rows.stream().filter(row -> row.pose().position().zM() > 1.8).count();
      long hits =
          found.stream()
              .flatMap(one -> one.rows().stream())
              .filter(row -> rows.get(row).pose().position().zM() > 1.8)
              .count();
      assertTrue(hits >= 0.9 * beyond, "seed " + seed + ": " + hits + " of " + beyond);
    }
  }

  @Test
  void held_nowAndThen() {
    for (int seed = 0; seed < 20; seed++) {
      List<AuditCheck> warnings = warnings(log(true, 0.001, seed, heldNowAndThen()));
      assertEquals(List.of(AuditCheck.HELD), warnings, "seed " + seed);
    }
  }

  /** In whole centimetres two readings agree by chance, and nothing can be said. */
  @Test
  void held_notOfWholeCentimetres() {
    for (int seed = 0; seed < 20; seed++) {
      assertEquals(List.of(), warnings(log(true, 0.01, seed, (d, right, r) -> right)));
    }
  }

  @Test
  void stuck_inTheMiddleOfTheReach() {
    int[] count = {0};
    List<ReadingRow> rows =
        log(false, 0.001, 1, (d, right, random) -> count[0]++ % 2 == 0 ? 0.873 : right);
    List<AuditFinding> found = Audit.of(Logs.BOARD, rows);
    assertTrue(NO_READING.contains(found.get(0).check()), () -> "found " + said(found));
    assertEquals(Severity.WARN, found.get(0).severity());
  }

  /** The least value of all, where things are nearer: the sensor reports nothing below it. */
  @Test
  void stuck_notOfANearLimit() {
    List<ReadingRow> rows =
        log(
            false,
            1e-3,
            6,
            (d, right, random) ->
                random.nextInt(20) == 0 ? 3 + 0.9 * random.nextDouble() : Math.max(0.5, right));
    assertEquals(List.of(), warnings(rows), "a near limit is an effect");
    // Below it something else is read: no limit.
    List<ReadingRow> stuck =
        log(false, 1e-3, 6, (d, right, random) -> d < 0.3 ? right : Math.max(0.9, right));
    assertEquals(1, warnings(stuck).size());
  }

  /** A floor's echo scatters as any other. */
  @Test
  void stuck_notOfAFloor() {
    for (int seed = 0; seed < 20; seed++) {
      List<ReadingRow> rows =
          log(
              true,
              0.001,
              seed,
              (d, right, random) -> d > 1.8 ? 1.8 + 0.003 * random.nextGaussian() : right);
      List<AuditCheck> warnings = warnings(rows);
      assertTrue(
          warnings.stream().noneMatch(NO_READING::contains), "seed " + seed + " " + warnings);
    }
  }

  /** What stands where the scene has nothing is as far at each place of a line past it. */
  @Test
  void stuck_notOfWhatTheSensorMovesPast() {
    List<ReadingRow> rows = new ArrayList<>(log(false, 0.01, 1, (d, right, random) -> right));
    List<ReadingRow> past = new ArrayList<>();
    List<ReadingRow> towards = new ArrayList<>();
    for (int i = 0; i < 16; i++) {
      for (int again = 0; again < 10; again++) {
        past.add(at(0.01 * i - 0.08, 1.2));
        towards.add(at(0, 1.2 + 0.02 * i));
      }
    }
    past.addAll(rows);
    towards.addAll(rows);
    assertTrue(warnings(past).stream().noneMatch(NO_READING::contains), "past it");
    assertTrue(warnings(towards).stream().anyMatch(NO_READING::contains), "towards it");
  }

  private static ReadingRow at(double xM, double zM) {
    Pose pose = Pose.of(xM, zM, Math.PI / 2);
    return new ReadingRow("run", "front", 0, pose, new Echo(0.873), Untimed.ROW);
  }

  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void jump_ofATimersByte_bothWays(boolean random) {
    for (int seed = 0; seed < 20; seed++) {
      List<ReadingRow> rows =
          log(
              random,
              0.001,
              seed,
              (d, right, r) ->
                  r.nextInt(7) > 0 ? right : right + (r.nextBoolean() ? BYTE_M : -BYTE_M));
      assertEquals(List.of(AuditCheck.JUMP), warnings(rows), "seed " + seed);
    }
  }

  /** The air and an offset are no jumps. */
  @Test
  void jump_besideAScaleAndAnOffset() {
    List<ReadingRow> rows =
        log(
            true,
            0.001,
            3,
            (d, right, r) -> 0.98 * right - 0.009 + (r.nextInt(9) > 0 ? 0 : BYTE_M));
    assertEquals(List.of(AuditCheck.JUMP), warnings(rows));
  }

  @Test
  void order_changesNothing() {
    List<ReadingRow> rows = log(true, 0.001, 5, heldBeyond(1.8));
    List<Integer> order = new ArrayList<>(IntStream.range(0, rows.size()).boxed().toList());
    Collections.shuffle(order, new Random(1));
    List<ReadingRow> shuffled = order.stream().map(rows::get).toList();
    List<AuditFinding> first = Audit.of(Logs.BOARD, rows);
    List<AuditFinding> second = Audit.of(Logs.BOARD, shuffled);
    assertEquals(said(first), said(second));
    assertEquals(
        first.get(0).rows(), second.get(0).rows().stream().map(order::get).sorted().toList());
  }

  private static List<String> said(List<AuditFinding> found) {
    return found.stream().map(AuditFinding::what).toList();
  }
}
