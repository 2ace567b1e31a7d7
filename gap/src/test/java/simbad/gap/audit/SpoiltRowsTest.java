package simbad.gap.audit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import simbad.gap.audit.AuditFinding.File;
import simbad.gap.fixture.Logs;
import simbad.sonar.frame.Pose;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.Reading;
import simbad.sonar.sensing.ReadingRow;

/** What faults do to six rows, and what other ways to write poses are mended to. */
class SpoiltRowsTest {
  private static final List<ReadingRow> ROWS =
      List.of(
          row("a", 0, 1.2345),
          row("a", 0.1, Double.NaN),
          row("a", 0.2, 2),
          row("a", 0.3, Double.NaN),
          row("a", 0.4, 1.5),
          row("b", 0, Double.NaN));

  private static ReadingRow row(String run, double timeS, double rangeM) {
    Reading reading = Double.isNaN(rangeM) ? NoEcho.NO_ECHO : new Echo(rangeM);
    return new ReadingRow(run, "s", timeS, Pose.of(1 + timeS, 2, 0.5), reading);
  }

  private static PostedFault fault(String name) {
    return PostedFault.all().stream()
        .filter(one -> one.name().equals(name))
        .findFirst()
        .orElseThrow();
  }

  private static List<ReadingRow> spoilt(String name, List<ReadingRow> rows) {
    return fault(name).spoil().spoil(rows, Logs.BOARD.sensor(), new SplittableRandom(1));
  }

  private static List<Double> ranges(List<ReadingRow> rows) {
    List<Double> ranges = new ArrayList<>();
    for (ReadingRow row : rows) {
      ranges.add(row.reading() instanceof Echo echo ? echo.rangeM() : Double.NaN);
    }
    return ranges;
  }

  private static void assertRanges(String name, double... expected) {
    List<ReadingRow> spoilt = spoilt(name, ROWS);
    List<Double> ranges = ranges(spoilt);
    for (int i = 0; i < expected.length; i++) {
      assertEquals(expected[i], ranges.get(i), 1e-9, name + " of row " + i);
      assertEquals(ROWS.get(i).pose(), spoilt.get(i).pose());
      assertEquals(ROWS.get(i).timeS(), spoilt.get(i).timeS());
    }
  }

  @Test
  void names_areOfOneFaultEach() {
    List<String> names = PostedFault.all().stream().map(PostedFault::name).toList();
    assertEquals(names.size(), Set.copyOf(names).size());
    Set<AuditCheck> checks = new HashSet<>();
    PostedFault.all().forEach(one -> checks.add(one.check()));
    assertEquals(11, checks.size(), () -> "" + checks);
  }

  /** With tenths of a millimetre, as files have them. */
  @Test
  void factors_areOfEchoes() {
    double none = Double.NaN;
    assertRanges("ranges times 1000.0", 1234.5, none, 2000, none, 1500, none);
    assertRanges("ranges times 0.5", 0.6172, none, 1, none, 0.75, none);
    assertRanges("ranges times 0.3937", 0.486, none, 0.7874, none, 0.5906, none);
    assertEquals(AuditCheck.UNIT, fault("ranges times 5.0").check());
  }

  /** 0.019 s at 343 m/s are 6.517 m. */
  @Test
  void codes_standForNoEcho() {
    assertRanges("0 for no echo", 1.2345, 0, 2, 0, 1.5, 0);
    assertRanges("the most for no echo", 1.2345, 4, 2, 4, 1.5, 4);
    assertRanges("7.65 for no echo", 1.2345, 7.65, 2, 7.65, 1.5, 7.65);
    assertRanges("38 ms for no echo", 1.2345, 6.517, 2, 6.517, 1.5, 6.517);
  }

  /** The greatest is 2 m. */
  @Test
  void ranges_startAgain() {
    double none = Double.NaN;
    assertRanges("again from 0 beyond half the greatest", 0.2345, none, 0, none, 0.5, none);
  }

  /** One in twelve of 6000, to five deviations of a root of 6000 / 12. */
  @Test
  void nowAndThen_isOneInTwelve() {
    List<ReadingRow> many = new ArrayList<>();
    for (int i = 0; i < 6000; i++) {
      many.add(row("a", 0.1 * i, i % 100 == 0 ? Double.NaN : 1));
    }
    for (Map.Entry<String, Double> one :
        Map.of("9999999 now and then", 9_999_999.0, "256 us now and then", 1.0439).entrySet()) {
      List<ReadingRow> spoilt = spoilt(one.getKey(), many);
      Map<Double, Long> counts =
          ranges(spoilt).stream().collect(Collectors.groupingBy(r -> r, Collectors.counting()));
      assertEquals(Set.of(1.0, Double.NaN, one.getValue()), counts.keySet(), one.getKey());
      assertEquals(495, counts.getOrDefault(one.getValue(), 0L), 110, one.getKey());
      assertEquals(60, counts.getOrDefault(Double.NaN, 0L), "what was no echo stays none");
    }
  }

  @Test
  void memory_keepsAValue() {
    double none = Double.NaN;
    assertRanges("last value for no echo", 1.2345, 1.2345, 2, 2, 1.5, none);
    assertRanges("stuck from the middle on", 1.2345, none, 2, 2, 2, 2);
    assertRanges("stuck from the begin", 0.73, 0.73, 0.73, 0.73, 0.73, 0.73);
  }

  /** Before an echo there is nothing to be stuck at. */
  @Test
  void stuck_beginsWithAnEcho() {
    List<ReadingRow> silent =
        List.of(row("a", 0, Double.NaN), row("a", 1, Double.NaN), row("a", 2, 1), row("a", 3, 2));
    assertEquals(
        List.of(Double.NaN, Double.NaN, 1.0, 1.0),
        ranges(spoilt("stuck from the middle on", silent)));
  }

  @Test
  void poses_areWrittenOtherwise() {
    assertPoses("z up the page", p -> Pose.of(x(p), -2, 0.5));
    assertPoses("x and z exchanged", p -> Pose.of(2, x(p), 0.5));
    assertPoses("headings clockwise", p -> Pose.of(x(p), 2, -0.5));
    assertPoses("headings in radians", p -> Pose.of(x(p), 2, Math.toRadians(0.5)));
    assertPoses("headings of a compass", p -> Pose.of(x(p), 2, Math.PI / 2 - 0.5));
    assertPoses("positions in centimetres", p -> Pose.of(100 * x(p), 200, 0.5));
    assertPoses("one pose for all", p -> Pose.of(1, 2, 0.5));
  }

  private static double x(Pose pose) {
    return pose.position().xM();
  }

  private static void assertPoses(String name, UnaryOperator<Pose> expected) {
    List<ReadingRow> spoilt = spoilt(name, ROWS);
    for (int i = 0; i < ROWS.size(); i++) {
      assertPose(expected.apply(ROWS.get(i).pose()), spoilt.get(i).pose(), name);
      assertEquals(ROWS.get(i).reading(), spoilt.get(i).reading());
    }
  }

  private static void assertPose(Pose expected, Pose pose, String name) {
    assertEquals(expected.position().xM(), pose.position().xM(), 1e-9, name);
    assertEquals(expected.position().zM(), pose.position().zM(), 1e-9, name);
    double turned = pose.heading().radians() - expected.heading().radians();
    assertEquals(0, Math.IEEEremainder(turned, 2 * Math.PI), 1e-9, name);
  }

  /** From the middle time of each run on, far back. */
  @Test
  void times_areWrittenOtherwise() {
    List<Double> times =
        spoilt("times in milliseconds", ROWS).stream().map(ReadingRow::timeS).toList();
    assertEquals(List.of(0.0, 100.0, 200.0, 300.0, 400.0, 0.0), times);
    List<ReadingRow> anew = spoilt("the clock begins anew in each run", ROWS);
    double[] expected = {0, 0.1, -1e5, 0.1 - 1e5, 0.2 - 1e5, -1e5};
    for (int i = 0; i < expected.length; i++) {
      assertEquals(expected[i], anew.get(i).timeS(), 1e-6, "row " + i);
      assertEquals(ROWS.get(i).reading(), anew.get(i).reading());
    }
  }

  // ---------------------------------------------------------------- conventions

  private static void assertMended(String mend, double x, double z, double headingRad) {
    Convention convention =
        Convention.all().stream().filter(one -> one.mend().equals(mend)).findFirst().orElseThrow();
    assertPose(Pose.of(x, z, headingRad), convention.mended(Pose.of(3, 2, 0.5)), mend);
  }

  @Test
  void conventions_areMendedOneAfterTheOther() {
    double right = Math.PI / 2;
    assertMended("--flip-z", 3, -2, 0.5);
    assertMended("--flip-x", -3, 2, 0.5);
    assertMended("--swap-xz", 2, 3, 0.5);
    assertMended("--heading-clockwise", 3, 2, -0.5);
    assertMended("--heading-radians", 3, 2, Math.toDegrees(0.5));
    assertMended("--heading-offset 90", 3, 2, 0.5 + right);
    assertMended("--heading-offset -90", 3, 2, 0.5 - right);
    assertMended("--heading-offset 180", 3, 2, 0.5 + 2 * right);
    assertMended("--heading-clockwise --heading-offset 90", 3, 2, right - 0.5);
    assertMended("--heading-clockwise --heading-offset 180", 3, 2, 2 * right - 0.5);
    assertMended("--heading-radians --heading-clockwise", 3, 2, -Math.toDegrees(0.5));
    assertMended(
        "--heading-radians --heading-clockwise --heading-offset 90",
        3,
        2,
        right - Math.toDegrees(0.5));
    assertMended("--flip-z --heading-radians", 3, -2, Math.toDegrees(0.5));
    assertMended("--flip-z --heading-clockwise --heading-offset 90", 3, -2, right - 0.5);
    assertMended("--flip-z --heading-clockwise", 3, -2, -0.5);
    assertMended("--flip-x --heading-clockwise", -3, 2, -0.5);
    assertMended("--swap-xz --heading-clockwise", 2, 3, -0.5);
    assertMended("--swap-xz --heading-clockwise --heading-offset 90", 2, 3, right - 0.5);
    assertMended("--flip-z --heading-offset 180", 3, -2, 0.5 + 2 * right);
    assertMended("--pose-scale 0.01", 0.03, 0.02, 0.5);
    assertMended("--pose-scale 0.0254", 3 * 0.0254, 2 * 0.0254, 0.5);
    assertMended("--pose-scale 1000", 3000, 2000, 0.5);
  }

  /** None is named twice, none is what is right, and words say what was done. */
  @Test
  void conventions_areAllOthers() {
    List<Convention> all = Convention.all();
    assertEquals(all.size(), all.stream().map(Convention::mend).distinct().count());
    assertEquals(25, all.size());
    assertEquals(
        "z points up the page, headings turn clockwise",
        all.stream()
            .filter(one -> one.mend().equals("--flip-z --heading-clockwise"))
            .findFirst()
            .orElseThrow()
            .words());
    assertTrue(all.stream().noneMatch(one -> one.words().isEmpty() || one.steps().isEmpty()));
  }

  // ---------------------------------------------------------------- findings

  @Test
  void finding_isTheSameOfAnotherFile() {
    AuditFinding of =
        new AuditFinding(
            AuditCheck.CLOCK, File.READINGS, "what", List.of(3), "do", "--mend", Severity.REFUSE);
    assertTrue(of.refuses() && Audit.refuses(List.of(of)));
    assertEquals(
        new AuditFinding(
            AuditCheck.CLOCK, File.REFERENCE, "what", List.of(3), "do", "--mend", Severity.REFUSE),
        of.in(File.REFERENCE));
    AuditFinding warns =
        new AuditFinding(AuditCheck.CLOCK, File.TRACK, "", List.of(), "", "", Severity.WARN);
    assertTrue(!warns.refuses() && !Audit.refuses(List.of(warns)));
    assertEquals("no-echo-code", AuditCheck.NO_ECHO_CODE.word());
    assertEquals("t_s", AuditCheck.CLOCK.field());
    Set<String> words = new HashSet<>();
    for (AuditCheck check : AuditCheck.values()) {
      assertTrue(words.add(check.word()) && !check.field().isEmpty(), check.name());
    }
  }
}
