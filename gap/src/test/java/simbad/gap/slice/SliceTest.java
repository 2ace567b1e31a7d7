package simbad.gap.slice;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import simbad.gap.diagnosis.Interval;
import simbad.gap.diagnosis.Place;
import simbad.gap.fixture.Worlds;
import simbad.sonar.frame.Placement;
import simbad.sonar.frame.Pose;
import simbad.sonar.ping.Geometry;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.ReadingRow;

/** Ten pings: their number, and whether it is odd. */
class SliceTest {
  private static final Axis NUMBER = Axis.numbered("number", 10, 1, i -> i);
  private static final Axis PARITY =
      Axis.named("parity", 10, List.of("even", "odd"), i -> i == 0 ? -1 : i % 2);

  private static List<Integer> held(Slice slice) {
    return IntStream.range(0, 10).filter(slice::holds).boxed().toList();
  }

  @Test
  void range_holdsFromTheFirstToBeforeTheLast() {
    Slice.Range range = new Slice.Range(NUMBER, 3, 6);
    assertEquals(List.of(3, 4, 5), IntStream.range(0, 10).filter(range::holds).boxed().toList());
    assertFalse(new Slice.Range(PARITY, 0, 2).holds(0), "belongs to no bin");
  }

  @Test
  void slice_holdsWhatAllRangesHold() {
    Slice all = new Slice(List.of());
    Slice some = all.and(new Slice.Range(NUMBER, 3, 8));
    Slice odd = some.and(new Slice.Range(PARITY, 1, 2));
    assertEquals(10, held(all).size());
    assertEquals(List.of(3, 4, 5, 6, 7), held(some));
    assertEquals(List.of(3, 5, 7), held(odd));
  }

  @Test
  void conditions_areSaidInTheirOrder() {
    Slice slice = new Slice(List.of(new Slice.Range(PARITY, 1, 2), new Slice.Range(NUMBER, 3, 8)));
    assertEquals(
        List.of(
            new Place.Condition("parity", Optional.empty(), Optional.of("odd")),
            new Place.Condition("number", Optional.of(new Interval(3, 8)), Optional.empty())),
        slice.conditions());
    assertEquals(List.of(), new Slice(List.of()).conditions());
  }

  @Test
  void slice_staysAsItIs() {
    List<Slice.Range> ranges = new ArrayList<>(List.of(new Slice.Range(NUMBER, 3, 8)));
    Slice slice = new Slice(ranges);
    ranges.clear();
    assertEquals(5, held(slice).size());
    assertTrue(held(slice.and(new Slice.Range(NUMBER, 0, 3))).isEmpty());
    assertEquals(5, held(slice).size());
  }

  /** Posts of 10 cm along x, seen from the origin: at so many metres each. */
  private static Geometry before(double headingRad, double... postsM) {
    Obstacle post = Worlds.POST.scene().obstacles().get(0);
    List<Obstacle> posts = new ArrayList<>();
    for (double at : postsM) {
      posts.add(post.with(new Placement(at, 0, 0)));
    }
    ReadingRow row = new ReadingRow("r", "s", 0, Pose.of(0, 0, headingRad), NoEcho.NO_ECHO);
    ReadingRow back =
        new ReadingRow("r", "s", 1, Pose.of(0, 0, Math.PI - headingRad), NoEcho.NO_ECHO);
    SensingSetup setup = new SensingSetup(Worlds.POST.sensor(), new Scene(posts), 4);
    return new Geometry(new PingLog(List.of(row, back)), setup, List.of());
  }

  @Test
  void ofObstaclesInTheCone_theNearestIsMeant() {
    assertEquals(1, Nearest.of(before(0, 1.2, 0.7, 0.9), 0));
    assertEquals(2, Nearest.of(before(0, 1.2, 0.9, 0.7), 0));
    assertEquals(0, Nearest.of(before(0, 0.7, 0.9, 1.2), 0));
  }

  /** The second ping looks the other way. */
  @Test
  void whatIsInTheCone_isMeant_howeverNearOthersAreAside() {
    Geometry both = before(0, 1.2, -0.5);
    assertEquals(0, Nearest.of(both, 0));
    assertEquals(1, Nearest.of(both, 1));
    Geometry swapped = before(0, -0.5, 1.2);
    assertEquals(1, Nearest.of(swapped, 0));
    assertEquals(0, Nearest.of(swapped, 1));
  }

  @Test
  void whereNothingIsInTheCone_theNearestCentreIsMeant() {
    assertEquals(1, Nearest.of(before(Math.PI / 2, 1.2, -0.5, 0.8), 0));
    assertEquals(2, Nearest.of(before(Math.PI / 2, 1.2, -0.8, 0.5), 0));
    assertEquals(0, Nearest.of(before(Math.PI / 2, 0.4, -0.8, 0.5), 0));
  }

  /** Of two that are as near the first one, in the cone and beside it. */
  @Test
  void ofEqualOnes_theFirstIsMeant() {
    assertEquals(0, Nearest.of(before(0, 0.7, 0.7), 0));
    assertEquals(0, Nearest.of(before(Math.PI / 2, 0.7, 0.7), 0));
  }

  @Test
  void withoutObstacles_theNumberIsNought() {
    assertEquals(0, Nearest.of(before(0), 0));
  }
}
