package simbad.gap.locate;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import simbad.gap.diagnosis.Interval;
import simbad.gap.fixture.Ladders;
import simbad.sonar.frame.Pose;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.sensing.Circumstances;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.MovedObstacle;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.ReadingRow;

/**
 * Placements whose readings are off by figures by hand. Four readings of one are off by -3, -1, 1
 * and 3 mm about what it is off by: the middle half is those of -1 and 1, and half of all lie
 * within 2 mm, so that they scatter by 1.4826 * 2 mm.
 */
class PlacementMeansTest {
  private static final double[] MM = {-3, -1, 1, 3};
  private static final double WITHIN_M = 1.4826 * 0.002;

  /** Of a mean of the middle of four: root of 1.35 / 4 of the scatter. */
  private static final double DEVIATION_M = WITHIN_M * Math.sqrt(1.35 / 4);

  private static ReadingRow row(int place, int number, double rangeM, Optional<String> label) {
    Circumstances circumstances =
        new Circumstances(
            true,
            label,
            OptionalDouble.empty(),
            MovedObstacle.UNMOVED,
            OptionalDouble.empty(),
            OptionalDouble.empty());
    Pose pose = Pose.of(0, 1 + 0.1 * place, Math.PI / 2);
    return new ReadingRow("r", "s", 0.1 * number, pose, new Echo(rangeM), circumstances);
  }

  /** Placements 10 cm apart of four readings each, off by so much. */
  private static List<ReadingRow> rows(double... offM) {
    List<ReadingRow> rows = new ArrayList<>();
    for (int place = 0; place < offM.length; place++) {
      for (double mm : MM) {
        double range = 1 + 0.1 * place + offM[place] + mm / 1000;
        rows.add(row(place, rows.size(), range, Optional.empty()));
      }
    }
    return rows;
  }

  private static List<OptionalDouble> off(PingLog log, double byM) {
    return IntStream.range(0, log.size())
        .mapToObj(i -> OptionalDouble.of(log.rangeM(i) - log.zM(i) + byM))
        .toList();
  }

  private static List<PlacementOffset> offsets(SensingSetup setup, List<ReadingRow> rows) {
    PingLog log = new PingLog(rows);
    return PlacementOffsets.of(setup, log, off(log, 0.05), off(log, 0));
  }

  private static List<Integer> off(SensingSetup setup, double... offM) {
    List<PlacementOffset> found = offsets(setup, rows(offM));
    return IntStream.range(0, found.size()).filter(i -> found.get(i).isOff()).boxed().toList();
  }

  @Test
  void placement_isSaidWithItsMeans() {
    PlacementOffset third = offsets(Ladders.BOARD, rows(0, 0, 0.02, 0, 0, 0)).get(2);
    assertEquals("3", third.label());
    assertEquals(List.of(8, 9, 10, 11), third.pings());
    assertEquals(4, third.rows());
    // What the simulator expects is the reading less what it is off by: 5 cm nearer.
    assertEquals(1.15, third.distanceM(), 1e-9);
    assertEquals(0.07, third.beforeM(), 1e-9);
    assertEquals(0.02, third.afterM(), 1e-9);
    assertEquals(0.02 - 1.96 * DEVIATION_M, third.after95().low(), 1e-9);
    assertEquals(0.02 + 1.96 * DEVIATION_M, third.after95().high(), 1e-9);
    assertEquals(1.96 * DEVIATION_M, third.halfM(), 1e-9);
  }

  @Test
  void halfTheWidth_isHalfOfTheInterval() {
    PlacementOffset offset =
        new PlacementOffset("a", 1, List.of(4, 7), 0, 0, new Interval(0.02, 0.05), false);
    assertEquals(0.015, offset.halfM(), 1e-12);
    assertEquals(2, offset.rows());
  }

  /** A step of 1 cm that all readings share is not averaged away: 1 cm / root 12. */
  @Test
  void step_widensTheInterval() {
    PlacementOffset first = offsets(Ladders.board(0.01, 0, 0), rows(0, 0, 0, 0, 0, 0)).get(0);
    assertEquals(1.96 * Math.hypot(DEVIATION_M, 0.01 / Math.sqrt(12)), first.halfM(), 1e-9);
  }

  /** More than six deviations from the others, which agree: 10.34 mm. */
  @Test
  void off_isBeyondSixDeviations() {
    double six = 6 * DEVIATION_M;
    assertEquals(List.of(), off(Ladders.BOARD, 0, 0, 0, six - 1e-5, 0, 0));
    assertEquals(List.of(3), off(Ladders.BOARD, 0, 0, 0, six + 1e-5, 0, 0));
    assertEquals(List.of(3), off(Ladders.BOARD, 0, 0, 0, -six - 1e-5, 0, 0));
    assertEquals(List.of(3), off(Ladders.BOARD, 0.5, 0.5, 0.5, 0.5 + six + 1e-5, 0.5, 0.5));
    assertEquals(List.of(0), off(Ladders.BOARD, six + 1e-5, 0, 0, 0, 0, 0));
    assertEquals(List.of(5), off(Ladders.BOARD, 0, 0, 0, 0, 0, six + 1e-5));
    assertEquals(List.of(), off(Ladders.BOARD, 0, 0, 2 * six, 0, 0), "of five");
  }

  /** Places that are known to 3 mm may be off by as much besides. */
  @Test
  void statedPlaces_countAsWell() {
    SensingSetup stated = Ladders.board(0, 0.003, 0);
    double six = 6 * Math.hypot(DEVIATION_M, 0.003);
    assertEquals(List.of(), off(stated, 0, 0, 0, six - 1e-5, 0, 0));
    assertEquals(List.of(3), off(stated, 0, 0, 0, six + 1e-5, 0, 0));
  }

  /** Placements at 0, 0, 10, -10, 0, 10, -10 and x mm: half lie within 10 of their median, 0. */
  @Test
  void othersThatPart_makeItHarder() {
    double six = 6 * 1.4826 * 0.01;
    assertEquals(
        List.of(), off(Ladders.BOARD, 0, 0, 0.01, -0.01, 0, 0.01, -0.01, six - 1e-5, -0.01));
    assertEquals(
        List.of(7), off(Ladders.BOARD, 0, 0, 0.01, -0.01, 0, 0.01, -0.01, six + 1e-5, -0.01));
  }

  @Test
  void neighbours_toTheSameSide_areAStretch() {
    assertEquals(List.of(), off(Ladders.BOARD, 0, 0, 0, 0.1, 0.1, 0, 0, 0, 0));
    assertEquals(List.of(3, 4), off(Ladders.BOARD, 0, 0, 0, 0.1, -0.1, 0, 0, 0, 0));
    assertEquals(List.of(3, 5), off(Ladders.BOARD, 0, 0, 0, 0.1, 0, 0.1, 0, 0, 0));
  }

  /** Two readings may both be of something else, three are not. */
  @Test
  void fewReadings_areNotCalledOff() {
    for (int kept : new int[] {2, 3}) {
      List<ReadingRow> rows = new ArrayList<>(rows(0, 0, 0, 0.1, 0, 0));
      rows.subList(12, 16 - kept).clear();
      assertEquals(kept == 3, offsets(Ladders.BOARD, rows).get(3).isOff(), kept + " readings");
    }
  }

  /** Where readings of a placement agree to the last digit the sensor's own noise counts. */
  @Test
  void readingsThatAgree_scatterAsBelieved() {
    List<ReadingRow> rows = new ArrayList<>();
    for (int i = 0; i < 24; i++) {
      int place = i / 4;
      rows.add(row(place, i, 1 + 0.1 * place, Optional.empty()));
    }
    PingLog log = new PingLog(rows);
    List<OptionalDouble> exact =
        IntStream.range(0, 24).mapToObj(i -> OptionalDouble.of(0.0)).toList();
    PlacementOffset first = PlacementOffsets.of(Ladders.BOARD, log, exact, exact).get(0);
    assertEquals(1.96 * Ladders.NOISE_M * Math.sqrt(1.35 / 4), first.halfM(), 1e-9);
  }

  /** Words stand for their placement, and the nearest one comes first. */
  @Test
  void words_areKept_andDistancesSorted() {
    List<ReadingRow> rows = new ArrayList<>();
    String[] words = {"d", "a", "e", "c", "b"};
    for (int place = 4; place >= 0; place--) {
      for (double mm : MM) {
        double range = 1 + 0.1 * place + mm / 1000;
        rows.add(row(place, rows.size(), range, Optional.of(words[place])));
      }
    }
    List<PlacementOffset> offsets = offsets(Ladders.BOARD, rows);
    assertEquals(List.of(words), offsets.stream().map(PlacementOffset::label).toList());
  }

  /** Of pings of which one model expects nothing there is nothing to compare. */
  @Test
  void pingsThatOneModelLacks_areLeftOut() {
    PingLog log = new PingLog(rows(0, 0, 0, 0, 0, 0));
    List<OptionalDouble> before = new ArrayList<>(off(log, 0));
    List<OptionalDouble> after = new ArrayList<>(off(log, 0));
    before.set(0, OptionalDouble.empty());
    after.set(5, OptionalDouble.empty());
    for (int i = 8; i < 12; i++) {
      after.set(i, OptionalDouble.empty());
    }
    List<PlacementOffset> offsets = PlacementOffsets.of(Ladders.BOARD, log, before, after);
    assertEquals(
        List.of(List.of(1, 2, 3), List.of(4, 6, 7), List.of(12, 13, 14, 15)),
        offsets.stream().limit(3).map(PlacementOffset::pings).toList());
    assertEquals(List.of("1", "2", "4", "5", "6"), offsets.stream().map(o -> o.label()).toList());
    // Of three the one in the middle: of -1, 1 and 3, and of -3, 1 and 3 mm, that of 1.
    assertEquals(0.001, offsets.get(0).afterM(), 1e-9);
    assertEquals(0.001, offsets.get(1).afterM(), 1e-9);
  }

  /** Of two readings the mean, of one itself; a drive has no placements. */
  @Test
  void one_andTwo_areTheirMean() {
    List<ReadingRow> rows = new ArrayList<>(rows(0, 0, 0, 0, 0, 0));
    rows.subList(18, 20).clear();
    rows.subList(0, 3).clear();
    List<PlacementOffset> offsets = offsets(Ladders.BOARD, rows);
    assertEquals(0.003, offsets.get(0).afterM(), 1e-9);
    assertEquals(-0.002, offsets.get(4).afterM(), 1e-9);
    List<ReadingRow> drive = new ArrayList<>();
    for (int i = 0; i < 9; i++) {
      drive.add(new ReadingRow("r", "s", i, Pose.of(0, 1 + i, 0), NoEcho.NO_ECHO));
    }
    assertEquals(List.of(), offsets(Ladders.BOARD, drive));
  }
}
