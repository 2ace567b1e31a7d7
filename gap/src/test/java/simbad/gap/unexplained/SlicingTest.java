package simbad.gap.unexplained;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import simbad.gap.fit.CalibratedLog;
import simbad.gap.fit.Hypothesis;
import simbad.gap.fixture.Worlds;
import simbad.gap.slice.Axis;
import simbad.sonar.frame.Pose;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.ReadingRow;

class SlicingTest {
  /** At 1 m before the post, each looking 1 degree farther past it; the cone ends at 20. */
  private static List<ReadingRow> turning(int count) {
    return IntStream.range(0, count)
        .mapToObj(i -> row(i, Pose.of(1, 0, Math.PI + Math.toRadians(i))))
        .toList();
  }

  private static ReadingRow row(int i, Pose pose) {
    return new ReadingRow("r", "s", 0.1 * i, pose, NoEcho.NO_ECHO);
  }

  private static List<Axis> cuts(List<ReadingRow> rows) {
    CalibratedLog given = Worlds.given(rows);
    return new Slicing(given.log(), given.geometry(given.model(Hypothesis.NONE))).all();
  }

  private static int[] cut(List<ReadingRow> rows, String name) {
    Axis cut =
        cuts(rows).stream().filter(one -> one.variable().equals(name)).findFirst().orElseThrow();
    return bins(cut, rows.size());
  }

  private static int[] bins(Axis cut, int pings) {
    return IntStream.range(0, pings).map(cut::bin).toArray();
  }

  /** Sixteen pings see the post; the eight slices of two hold them in the order of their angle. */
  @Test
  void angle_isCutWhereTheObstacleIsSeen() {
    int[] slice = cut(turning(30), "off axis");
    int seen = (int) Arrays.stream(slice).filter(at -> at >= 0).count();
    assertTrue(seen >= 20 && seen < 25, "the cone's 20 degrees, and half of the post's 6: " + seen);
    for (int i = 0; i < slice.length; i++) {
      int from = i;
      assertEquals(i < seen, slice[i] >= 0, "ping " + i + Arrays.toString(slice));
      assertTrue(i == 0 || i >= seen || slice[i] <= slice[i - 1], () -> "ping " + from);
    }
    assertEquals(7, Arrays.stream(slice).max().orElseThrow());
    for (int at = 0; at < 8; at++) {
      int which = at;
      long rows = Arrays.stream(slice).filter(other -> other == which).count();
      assertTrue(rows >= seen / 8 && rows <= seen / 8 + 1, "slice " + at + " holds " + rows);
    }
  }

  /** Where nothing is in the cone there is no bearing, no distance and no angle to cut by. */
  @Test
  void whatIsNotSeen_isInNoSliceOfIt() {
    List<ReadingRow> away =
        IntStream.range(0, 10).mapToObj(i -> row(i, Pose.of(1 + 0.1 * i, 0, 0))).toList();
    for (String name : List.of("off axis", "distance", "relative distance", "bearing x obstacle")) {
      assertArrayEquals(IntStream.range(0, 10).map(i -> -1).toArray(), cut(away, name), name);
    }
    assertEquals(9, Arrays.stream(cut(away, "time")).max().orElseThrow());
  }

  private static Axis axis(String name, int count, int... bins) {
    return Axis.binned(name, bins.length, count, i -> bins[i]);
  }

  @Test
  void twoCuts_makeEveryPairOfTheirSlices() {
    Axis one = axis("one", 2, 0, 0, 1, 1, -1, 0);
    Axis other = axis("other", 3, 0, 2, 0, 2, 1, -1);
    Axis both = one.times(other);
    assertEquals("one x other", both.variable());
    assertEquals(6, both.count());
    assertArrayEquals(new int[] {0, 2, 3, 5, -1, -1}, bins(both, 6));
  }
}
