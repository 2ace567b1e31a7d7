package simbad.gap.locate;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import simbad.gap.diagnosis.Interval;
import simbad.gap.diagnosis.Place;
import simbad.gap.fixture.Worlds;
import simbad.gap.slice.Axis;
import simbad.sonar.frame.Placement;
import simbad.sonar.frame.Pose;
import simbad.sonar.ping.Geometry;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.ReadingRow;

/** The ways to cut a log, and the rows that the words for a place mean. */
class CutsTest {
  private static final double FAR_X_M = 3;

  /** Posts at the origin and 3 m to the right of it. */
  private static SensingSetup posts(int count) {
    Obstacle near = Worlds.POST.scene().obstacles().get(0);
    Obstacle far =
        new Obstacle("far", new Placement(FAR_X_M, 0, 0), near.outline(), near.detection());
    Scene scene = new Scene(List.of(near, far).subList(0, count));
    return new SensingSetup(Worlds.POST.sensor(), scene, Worlds.POST.noEchoM());
  }

  private static ReadingRow row(
      String run, String sensor, double timeS, double x, double z, double headingDeg) {
    Pose pose = Pose.of(x, z, Math.toRadians(headingDeg));
    return new ReadingRow(run, sensor, timeS, pose, NoEcho.NO_ECHO);
  }

  /** Nearer and nearer to the first post from the left, and always faster. */
  private static List<ReadingRow> drive(String run, String sensor) {
    List<ReadingRow> rows = new ArrayList<>();
    for (int i = 0; i < 6; i++) {
      rows.add(row(run, sensor, i, -2 + 0.04 * i * i, 0, 5 * i));
    }
    return rows;
  }

  private static Geometry geometry(int obstacles, List<ReadingRow> rows) {
    return new Geometry(new PingLog(rows), posts(obstacles), List.of());
  }

  private static List<String> words(Geometry geometry) {
    return Cuts.of(geometry).stream()
        .map(
            cut ->
                cut.within().conditions().stream()
                        .map(one -> "in " + one.name().orElse("?") + ": ")
                        .collect(Collectors.joining())
                    + cut.axes().stream().map(Axis::variable).collect(Collectors.joining(" x ")))
        .toList();
  }

  @Test
  void oneSensorBeforeOneObstacle_isCutByNumbers() {
    assertEquals(
        List.of(
            "distance_m",
            "off_axis_deg",
            "bearing_deg",
            "bearing_deg x distance_m",
            "distance_m x off_axis_deg",
            "distance_m x t_s",
            "distance_m x speed_m_s",
            "off_axis_deg x speed_m_s",
            "t_s",
            "speed_m_s"),
        words(geometry(1, drive("r", "s"))));
  }

  @Test
  void withoutObstacles_thereIsNoDistance() {
    assertEquals(List.of("t_s", "speed_m_s"), words(geometry(0, drive("r", "s"))));
  }

  /** A bearing is of one obstacle of several; two sensors and two runs tell pings apart. */
  @Test
  void severalOfAll_areCutByPairsAsWell() {
    List<ReadingRow> rows = new ArrayList<>(drive("one", "left"));
    rows.addAll(drive("two", "right"));
    assertEquals(
        List.of(
            "sensor",
            "run",
            "obstacle",
            "distance_m",
            "off_axis_deg",
            "in post: bearing_deg",
            "in post: bearing_deg x distance_m",
            "in far: bearing_deg",
            "in far: bearing_deg x distance_m",
            "distance_m x off_axis_deg",
            "obstacle x distance_m",
            "obstacle x off_axis_deg",
            "obstacle x t_s",
            "sensor x distance_m",
            "sensor x off_axis_deg",
            "distance_m x t_s",
            "distance_m x speed_m_s",
            "off_axis_deg x speed_m_s",
            "t_s",
            "speed_m_s",
            "sensor x t_s",
            "run x t_s"),
        words(geometry(2, rows)));
  }

  private static Axis axis(Geometry geometry, String variable) {
    return Cuts.of(geometry).stream()
        .flatMap(cut -> cut.axes().stream())
        .filter(axis -> axis.variable().equals(variable))
        .findFirst()
        .orElseThrow();
  }

  /** What a ping is in the cut is what its place says. */
  @Test
  void bins_areThoseOfTheValues() {
    Geometry geometry = geometry(1, drive("r", "s"));
    for (int i = 0; i < 6; i++) {
      assertIn(geometry, "distance_m", i, 2 - 0.04 * i * i);
      // It looks along x, past the post's centre to the left as it turns.
      assertIn(geometry, "off_axis_deg", i, -5 * i);
      assertIn(geometry, "bearing_deg", i, 270);
      assertIn(geometry, "t_s", i, i);
      // From 2 - 0.04 (i - 1)^2 to 2 - 0.04 i^2 in a second; the first goes as the second.
      assertIn(geometry, "speed_m_s", i, 0.04 * (2 * Math.max(1, i) - 1));
    }
  }

  private static void assertIn(Geometry geometry, String variable, int ping, double value) {
    Axis axis = axis(geometry, variable);
    int bin = axis.bin(ping);
    Interval ends = axis.condition(bin, bin + 1).interval().orElseThrow();
    String what = variable + " " + value + " of ping " + ping + " in " + ends;
    assertEquals(true, ends.low() <= value + 1e-9 && value - 1e-9 <= ends.high(), what);
  }

  // ---------------------------------------------------------------- rows of a place

  /** Before the far post, before the near one, and looking away from both, nearer to the far. */
  private static Geometry lookingAround() {
    return geometry(
        2,
        List.of(
            row("one", "left", 0, 2, 0, 0),
            row("one", "left", 1, 0.5, 0, 180),
            row("one", "right", 2, 2, 0, 90),
            row("two", "right", 3, 0, 1, 100)));
  }

  private static int[] rows(Place.Condition... conditions) {
    return PlaceRows.of(lookingAround(), List.of(conditions));
  }

  private static Place.Condition named(String variable, String name) {
    return new Place.Condition(variable, Optional.empty(), Optional.of(name));
  }

  private static Place.Condition between(String variable, double low, double high) {
    return new Place.Condition(variable, Optional.of(new Interval(low, high)), Optional.empty());
  }

  @Test
  void names_areOfSensorRunAndObstacle() {
    assertArrayEquals(new int[] {0, 1}, rows(named("sensor", "left")));
    assertArrayEquals(new int[] {2, 3}, rows(named("sensor", "right")));
    assertArrayEquals(new int[] {3}, rows(named("run", "two")));
    assertArrayEquals(new int[] {0, 2}, rows(named("obstacle", "far")));
    assertArrayEquals(new int[] {1, 3}, rows(named("obstacle", "post")));
    assertArrayEquals(new int[0], rows(named("colour", "post")));
    assertArrayEquals(new int[] {0, 1, 2, 3}, rows());
  }

  /** From the low end on, up to before the high one; distances are 1, 0.5, 1 and 1 m. */
  @Test
  void numbers_areWithinTheirEnds() {
    assertArrayEquals(new int[] {1, 2}, rows(between("t_s", 1, 3)));
    assertArrayEquals(new int[] {1}, rows(between("distance_m", 0.5, 1)));
    assertArrayEquals(new int[] {0, 2, 3}, rows(between("distance_m", 0.9, 1.01)));
    // One second from x = 2 m to 0.5 m; the others have no ping before or after in their run.
    assertArrayEquals(new int[] {0, 1}, rows(between("speed_m_s", 1.5, 1.6)));
    assertArrayEquals(new int[] {2, 3}, rows(between("speed_m_s", 0, 1)));
    assertArrayEquals(new int[0], rows(between("colour", -1e9, 1e9)));
  }

  /** To the left of the heading an angle is positive: the third has the post at its right hand. */
  @Test
  void offAxis_isToTheObstacleThatIsMeant() {
    assertArrayEquals(new int[] {0, 1}, rows(between("off_axis_deg", -1, 1)));
    assertArrayEquals(new int[] {2}, rows(between("off_axis_deg", -91, -89)));
    assertArrayEquals(new int[] {3}, rows(between("off_axis_deg", -11, -9)));
  }

  /** Of the obstacle that is named; else of the first: from x = 2 m that is seen at 90 degrees. */
  @Test
  void bearing_isFromTheObstacleThatIsNamed() {
    assertArrayEquals(new int[] {0, 1, 2}, rows(between("bearing_deg", 89, 91)));
    assertArrayEquals(new int[] {3}, rows(between("bearing_deg", 0, 1)));
    assertArrayEquals(
        new int[] {0, 2}, rows(named("obstacle", "far"), between("bearing_deg", 269, 271)));
    assertArrayEquals(new int[0], rows(named("obstacle", "far"), between("bearing_deg", 89, 91)));
  }

  @Test
  void withoutObstacles_noRowIsAtADistance() {
    Geometry empty = geometry(0, List.of(row("r", "s", 0, 1, 0, 0), row("r", "s", 2, 2, 0, 0)));
    assertArrayEquals(new int[0], PlaceRows.of(empty, List.of(between("distance_m", -1e9, 1e9))));
    assertArrayEquals(new int[0], PlaceRows.of(empty, List.of(named("obstacle", "post"))));
    assertArrayEquals(new int[] {0, 1}, PlaceRows.of(empty, List.of(between("t_s", 0, 3))));
    assertArrayEquals(
        new int[] {0, 1}, PlaceRows.of(empty, List.of(between("speed_m_s", 0.4, 0.6))));
  }

  /** Whatever bins a cut has, its words mean the rows that are in them. */
  @Test
  void wordsOfAPlace_meanItsRows() {
    List<ReadingRow> rows = new ArrayList<>(drive("one", "left"));
    rows.addAll(drive("two", "right"));
    Geometry geometry = geometry(2, rows);
    for (String variable :
        List.of("sensor", "run", "obstacle", "distance_m", "off_axis_deg", "t_s", "speed_m_s")) {
      Axis axis = axis(geometry, variable);
      for (int bin = 0; bin < axis.count(); bin++) {
        int own = bin;
        assertArrayEquals(
            IntStream.range(0, geometry.pings()).filter(i -> axis.bin(i) == own).toArray(),
            PlaceRows.of(geometry, List.of(axis.condition(bin, bin + 1))),
            variable + " " + axis.condition(bin, bin + 1));
      }
    }
  }
}
