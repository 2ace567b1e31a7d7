package simbad.gap.audit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.gap.fixture.Logs;
import simbad.gap.fixture.Worlds;
import simbad.sonar.frame.Pose;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SetupDetails;
import simbad.sonar.sensing.Circumstances;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.MovedObstacle;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.ReadingRow;

/** A tape before a board, four readings each 20 cm; and poses that are known to some degree. */
class MisplacedCheckTest {
  private static Circumstances worded(Optional<String> word) {
    return new Circumstances(
        true,
        word,
        OptionalDouble.empty(),
        MovedObstacle.UNMOVED,
        OptionalDouble.empty(),
        OptionalDouble.empty());
  }

  private static Pose at(int place) {
    return Pose.of(0, 0.4 + 0.2 * place, Math.PI / 2);
  }

  /** Every reading of a place is off by so much. */
  private static List<ReadingRow> tape(double... offM) {
    List<ReadingRow> rows = new ArrayList<>();
    for (int place = 0; place < offM.length; place++) {
      for (int i = 0; i < 4; i++) {
        Echo echo = new Echo(0.4 + 0.2 * place + offM[place]);
        rows.add(new ReadingRow("r", "s", 0.1 * rows.size(), at(place), echo));
      }
    }
    return rows;
  }

  private static List<AuditFinding> found(SensingSetup setup, List<ReadingRow> rows) {
    AuditView view = new AuditView(setup, rows);
    return new MisplacedCheck(view, new Rest(view, RobustLine.IDENTITY)).find();
  }

  private static List<Integer> places(List<ReadingRow> rows) {
    return found(Logs.BOARD, rows).stream().map(one -> one.rows().get(0) / 4).toList();
  }

  @Test
  void misplaced_isSaidWithItsRows() {
    AuditFinding found = found(Logs.BOARD, tape(0, 0, 0.08, 0, 0, 0, 0, 0)).get(0);
    assertEquals(AuditCheck.MISPLACED, found.check());
    assertEquals(Severity.WARN, found.severity());
    assertEquals(List.of(8, 9, 10, 11), found.rows());
    assertEquals(
        "all readings of the placement, at 0.8 m, are 8.0 cm too long, and those beside it are not",
        found.what());
    List<ReadingRow> worded = new ArrayList<>();
    for (ReadingRow row : tape(0, 0, -0.08, 0, 0, 0, 0, 0)) {
      worded.add(row.at(row.pose(), worded(Optional.of("p" + worded.size() / 4))));
    }
    assertEquals(
        "all readings of placement p2, at 0.8 m, are 8.0 cm too short, and those beside it are not",
        found(Logs.BOARD, worded).get(0).what());
  }

  @Test
  void misplaced_isOffByMoreThanAHandIs() {
    assertEquals(List.of(), places(tape(0, 0, 0.0499, 0, 0, 0, 0, 0)));
    assertEquals(List.of(2), places(tape(0, 0, 0.0501, 0, 0, 0, 0, 0)));
    assertEquals(List.of(2), places(tape(0, 0, -0.0501, 0, 0, 0, 0, 0)));
    assertEquals(List.of(0), places(tape(0.0501, 0, 0, 0, 0, 0, 0, 0)));
    assertEquals(List.of(7), places(tape(0, 0, 0, 0, 0, 0, 0, 0.0501)));
    assertEquals(List.of(), places(tape(0, 0, 0.1, 0, 0)), "of five");
    assertEquals(List.of(2), places(tape(0, 0, 0.1, 0, 0, 0)), "of six");
  }

  /** Others that are off by 1 cm: six times 1.4826 cm; places known to 2 cm: twelve. */
  @Test
  void others_setTheLimit() {
    double six = 6 * 1.4826 * 0.01;
    double[] off = {0.01, -0.01, 0, 0.01, -0.01, six - 1e-4, 0.01, -0.01, 0.01, -0.01, 0};
    assertEquals(List.of(), places(tape(off)));
    off[5] = six + 1e-4;
    assertEquals(List.of(5), places(tape(off)));
    SensingSetup stated =
        Logs.BOARD.with(new SetupDetails(0.02, 0, Map.of(), Optional.empty(), List.of()));
    assertEquals(0, found(stated, tape(0, 0, 0.119, 0, 0, 0, 0, 0)).size());
    assertEquals(1, found(stated, tape(0, 0, 0.121, 0, 0, 0, 0, 0)).size());
  }

  @Test
  void neighboursThatAreOff_areNoSlip() {
    assertEquals(List.of(), places(tape(0, 0, 0.1, 0.1, 0, 0, 0, 0)));
    assertEquals(List.of(), places(tape(0, 0, 0.1, -0.1, 0, 0, 0, 0)));
  }

  /** One of ten at most: two of 18 are off here and there, two of 20 are slips. */
  @ParameterizedTest
  @ValueSource(ints = {18, 20})
  void several_areSlipsIfTheyAreRare(int places) {
    // Up to 4 m: in steps of 18 cm.
    List<ReadingRow> rows = new ArrayList<>();
    for (int i = 0; i < 4 * places; i++) {
      int place = i / 4;
      double distance = 0.4 + 0.18 * place;
      double off = place == 3 ? 0.1 : place == 9 ? -0.1 : 0;
      Pose pose = Pose.of(0, distance, Math.PI / 2);
      rows.add(new ReadingRow("r", "s", 0.1 * i, pose, new Echo(distance + off)));
    }
    assertEquals(places == 20 ? List.of(3, 9) : List.of(), places(rows));
  }

  /** Of four readings three have to agree with their middle; of two nobody knows which is wrong. */
  @Test
  void readingsOfAPlace_haveToAgree() {
    double[][] offs = {{0.1, 0.1, 0.1, 0.5}, {0.1, 0.12, 0.5, 0.6}, {0.1, 0.1, 0.1, 0.1}};
    boolean[] expected = {true, false, true};
    for (int k = 0; k < offs.length; k++) {
      List<ReadingRow> rows = tape(0, 0, 0, 0, 0, 0, 0, 0);
      for (int i = 0; i < 4; i++) {
        ReadingRow row = rows.get(8 + i);
        Echo echo = new Echo(0.8 + offs[k][i]);
        rows.set(8 + i, new ReadingRow("r", "s", row.timeS(), row.pose(), echo));
      }
      assertEquals(expected[k], !found(Logs.BOARD, rows).isEmpty(), "case " + k);
      ReadingRow last = rows.get(11);
      rows.set(11, new ReadingRow("r", "s", last.timeS(), last.pose(), NoEcho.NO_ECHO));
      assertEquals(1, found(Logs.BOARD, rows).size(), "two or more of three, case " + k);
      for (int i = 10; i < 11; i++) {
        ReadingRow row = rows.get(i);
        rows.set(i, new ReadingRow("r", "s", row.timeS(), row.pose(), NoEcho.NO_ECHO));
      }
      assertEquals(List.of(), found(Logs.BOARD, rows), "two readings");
    }
  }

  /** 5 cm aside or 3 degrees; then it was no tape. */
  @Test
  void tape_isOneLine() {
    for (double aside : new double[] {0.049, -0.049, 0.051, -0.051}) {
      List<ReadingRow> rows = tape(0, 0, 0.1, 0, 0, 0, 0, 0);
      Pose pose = Pose.of(aside, 1.8, Math.PI / 2);
      rows.set(31, new ReadingRow("r", "s", 3.1, pose, new Echo(1.8)));
      assertEquals(Math.abs(aside) < 0.05, !found(Logs.BOARD, rows).isEmpty(), aside + " m");
    }
    for (double deg : new double[] {2.9, -2.9, 3.1, -3.1}) {
      List<ReadingRow> rows = tape(0, 0, 0.1, 0, 0, 0, 0, 0);
      Pose pose = Pose.of(0, 1.8, Math.PI / 2 + Math.toRadians(deg));
      rows.set(31, new ReadingRow("r", "s", 3.1, pose, new Echo(1.8)));
      assertEquals(Math.abs(deg) < 3, !found(Logs.BOARD, rows).isEmpty(), deg + " degrees");
    }
  }

  // ---------------------------------------------------------------- unsure poses

  private static SensingSetup known(double poseM, double headingDeg) {
    return Worlds.POST.with(
        new SetupDetails(poseM, Math.toRadians(headingDeg), Map.of(), Optional.empty(), List.of()));
  }

  private static ReadingRow look(double x, double headingDeg) {
    Pose pose = Pose.of(x, 0.8, Math.toRadians(headingDeg));
    return new ReadingRow("r", "s", 0, pose, NoEcho.NO_ECHO, worded(Optional.empty()));
  }

  /**
   * From 80 cm the near corners of the post are at atan(5 / 75) = 3.81 degrees: with a cone of 20
   * they leave it at 23.81. Headings that are known to 1 degree are off by 2.
   */
  @Test
  void headings_areUnsure_besideTheBorder() {
    double[] turns = {0, 21.6, 22, 23, 25, 25.7, 26, 40};
    boolean[] unsure = {false, false, true, true, true, true, false, false};
    for (int side = -1; side <= 1; side += 2) {
      List<ReadingRow> rows = new ArrayList<>();
      for (double turn : turns) {
        rows.add(look(0, 90 + side * turn));
      }
      Set<Integer> found = UncertainPoses.rows(known(0, 1), rows, List.of());
      for (int i = 0; i < turns.length; i++) {
        assertEquals(unsure[i], found.contains(i), side * turns[i] + " degrees");
      }
      assertEquals(Set.of(), UncertainPoses.rows(Worlds.POST, rows, List.of()), "exact");
      rows.subList(6, 8).clear();
      assertEquals(
          Set.of(), UncertainPoses.rows(known(0, 1), rows, List.of()), "more than half of all");
    }
  }

  /**
   * Looking past the post its far corner, 85 cm ahead, leaves the cone at 5 + 85 tan 20 = 35.94 cm
   * aside. Places that are known to 2 mm are off by 4; on the side of the post that changes the
   * range by 4 / sin 20 = 12 mm, which is less than two steps.
   */
  @Test
  void places_areUnsure_besideTheBorder() {
    double[] aside = {0, 0.354, 0.357, 0.362, 0.365, 0.5};
    boolean[] unsure = {false, false, true, true, false, false};
    for (int side = -1; side <= 1; side += 2) {
      List<ReadingRow> rows = new ArrayList<>();
      for (double x : aside) {
        rows.add(look(side * x, 90));
      }
      Set<Integer> found = UncertainPoses.rows(known(0.002, 0), rows, List.of());
      for (int i = 0; i < aside.length; i++) {
        assertEquals(unsure[i], found.contains(i), side * aside[i] + " m");
      }
    }
  }

  /** From 2 m the post is heard in no direction: its corners leave the cone at 21.47 degrees. */
  @Test
  void whatIsNotHeard_isNeverUnsure() {
    List<ReadingRow> rows = new ArrayList<>(List.of(look(0, 90), look(0, 91), look(0, 113)));
    for (double turn : new double[] {21, 22}) {
      Pose far = Pose.of(0, 2, Math.toRadians(90 + turn));
      rows.add(new ReadingRow("r", "s", 0, far, NoEcho.NO_ECHO));
    }
    assertEquals(Set.of(2), UncertainPoses.rows(known(0, 1), rows, List.of()));
  }

  /** What a finding says of them is a note, with their rows. */
  @Test
  void unsurePoses_areNoted() {
    List<ReadingRow> rows = List.of(look(0, 90), look(0, 113), look(0, 66.5), look(0, 91));
    AuditFinding found = EdgeCheck.of(new AuditView(known(0, 1), rows)).orElseThrow();
    assertEquals(AuditCheck.EDGE, found.check());
    assertEquals(Severity.NOTE, found.severity());
    assertEquals(List.of(1, 2), found.rows());
    assertTrue(found.what().startsWith("2 readings at poses"), found.what());
    assertEquals(Optional.empty(), EdgeCheck.of(new AuditView(Worlds.POST, rows)));
    assertEquals(
        List.of(AuditCheck.EDGE),
        Audit.of(known(0, 1), rows).stream()
            .map(AuditFinding::check)
            .filter(AuditCheck.EDGE::equals)
            .toList());
    assertEquals(4, IntStream.range(0, rows.size()).count());
  }
}
