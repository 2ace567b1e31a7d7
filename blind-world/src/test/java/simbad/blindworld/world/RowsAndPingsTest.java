package simbad.blindworld.world;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;

/** Rows and their tracks, poses, speeds along them, and what a ping says of itself. */
class RowsAndPingsTest {

  private static final double NONE = Double.POSITIVE_INFINITY;
  private static final double NEAR = 1e-12;

  private static Row row(String run, String sensor, double tS, double xM, double headingRad) {
    return new Row(run, sensor, tS, new Pose(xM, 0, headingRad));
  }

  /** Two transducers in one run and one in another, not in the order of time. */
  private static Recording mixed() {
    return new Recording(
        List.of(
            row("a", "s", 1, 0, 0),
            row("a", "t", 1, 0, 0),
            row("b", "s", 0, 0, 0),
            row("a", "s", 0.5, 1, 0.5),
            row("a", "t", 4, 0, 0),
            row("a", "s", 1.2, 0.5, -0.5)));
  }

  @Test
  void tracks_areByRunAndTransducer_inTheOrderOfTime() {
    assertEquals(
        List.of(
            new Track("a", "s", List.of(3, 0, 5)),
            new Track("a", "t", List.of(1, 4)),
            new Track("b", "s", List.of(2))),
        mixed().tracks());
    assertEquals(List.of("s", "t"), mixed().sensors());
    assertEquals(6, mixed().size());
    assertEquals(1.2, mixed().tS(5));
    assertEquals(new Pose(1, 0, 0.5), mixed().pose(3));
  }

  /** Steps of 0.5, 0.2 and 3 s; the longest track goes from 1 to 4 s. */
  @Test
  void times_areThoseOfTheTracks() {
    assertEquals(0.5, mixed().periodS(), NEAR);
    assertEquals(3, mixed().longestS());
    Recording single = new Recording(List.of(row("a", "s", 7, 0, 0)));
    assertEquals(0, single.periodS());
    assertEquals(0, single.longestS());
    assertEquals(0, new Recording(List.of()).longestS());
  }

  /** A ping takes the speed of the step that begins with it; the last, of the one that ends. */
  @Test
  void motions_areDifferencesAlongATrack() {
    List<Ping.Motion> motions = Motions.of(mixed());
    // From 1 m at 0.5 s to 0 at 1 s, turning from 0.5 to 0 rad; then 0.5 m and -0.5 rad in 0.2 s.
    assertEquals(2, motions.get(3).speedMPerS(), NEAR);
    assertEquals(-1, motions.get(3).turnRadPerS(), NEAR);
    assertEquals(2.5, motions.get(0).speedMPerS(), NEAR);
    assertEquals(2.5, motions.get(5).speedMPerS(), NEAR);
    assertEquals(-2.5, motions.get(5).turnRadPerS(), NEAR);
    assertEquals(Ping.Motion.NONE, motions.get(2));
    // The shorter way round, and no division by no time.
    List<Ping.Motion> over =
        Motions.of(
            new Recording(
                List.of(row("a", "s", 0, 0, 3), row("a", "s", 1, 0, -3), row("a", "s", 1, 1, -3))));
    assertEquals(2 * Math.PI - 6, over.get(0).turnRadPerS(), NEAR);
    assertEquals(1e6, over.get(2).speedMPerS(), 1e-3);
  }

  @Test
  void poses_turnAndMove() {
    Pose pose = new Pose(1, 2, 3);
    assertEquals(new Pose(1, 2, 3.5), pose.turned(0.5));
    assertEquals(new Pose(7, 8, 3), pose.at(7, 8));
    assertEquals(5, pose.distanceM(new Pose(4, -2, 0)), NEAR);
    // From 3 rad to -3 rad it is 0.283 rad on.
    Pose between = pose.towards(new Pose(5, 0, -3), 0.25);
    assertEquals(2, between.xM(), NEAR);
    assertEquals(1.5, between.zM(), NEAR);
    assertEquals(3 + (2 * Math.PI - 6) / 4, between.headingRad(), NEAR);
  }

  private static Sight sight(int body, double distanceM) {
    return new Sight(body, 9, 0, distanceM, 0, 1);
  }

  @Test
  void ping_knowsTheTwoNearestThatAreHeard() {
    List<Sight> sights = List.of(sight(0, 3), sight(1, 1), sight(2, 2), sight(3, 0.5));
    Ping ping = new Ping(mixed(), new FixedChance(0.5), 4);
    assertEquals(1, ping.nearest(sights, new boolean[] {true, true, true, false}));
    assertEquals(2, ping.secondM());
    assertEquals(3, ping.nearest(sights, new boolean[] {true, false, false, false}));
    assertEquals(NONE, ping.secondM());
    assertEquals(NONE, ping.nearest(sights, new boolean[4]));
    assertEquals(0.5, ping.nearest(sights, new boolean[] {false, true, false, true}));
    assertEquals(1, ping.secondM());
  }

  @Test
  void ping_remembersTheOneBeforeOfItsTrack() {
    FixedChance chance = new FixedChance(0.5);
    Ping ping = new Ping(mixed(), chance, 2);
    List<Sight> sights = List.of(sight(0, 3), sight(1, 1));
    ping.begin(3, 0, new Pose(7, 8, 9), new Ping.Motion(1, 2));
    assertEquals(3, ping.row());
    assertEquals(0, ping.indexInTrack());
    assertEquals(0.5, ping.tS());
    assertEquals(new Pose(7, 8, 9), ping.pose());
    assertEquals(new Ping.Motion(1, 2), ping.motion());
    assertEquals(chance, ping.random());
    assertEquals(NONE, ping.lastReadingM());
    ping.nearest(sights, new boolean[] {true, false});
    assertFalse(ping.heardBefore(0));
    ping.end(2.5);
    ping.begin(0, 1, new Pose(0, 0, 0), Ping.Motion.NONE);
    assertEquals(1, ping.indexInTrack());
    assertEquals(2.5, ping.lastReadingM());
    assertTrue(ping.heardBefore(0));
    assertFalse(ping.heardBefore(1));
    ping.nearest(sights, new boolean[] {false, true});
    assertTrue(ping.heardBefore(0), "what is heard now changes nothing of before");
    ping.end(1);
    ping.begin(1, 0, new Pose(0, 0, 0), Ping.Motion.NONE);
    assertEquals(NONE, ping.lastReadingM());
    assertFalse(ping.heardBefore(1), "another track");
  }

  /** What changes nothing leaves everything as it is. */
  @Test
  void changeOfNothing_leavesAll() {
    Change nothing = new Change() {};
    List<Pose> poses = List.of(new Pose(1, 2, 3));
    assertEquals(poses, nothing.poses(mixed(), poses, new FixedChance(0.5)));
    assertFalse(nothing.restless());
    assertEquals(List.of(), nothing.bodies(List.of()));
    assertEquals(new Beam(1, 2), nothing.beam("s", new Beam(1, 2)));
    Hearing hearing = nothing.hearing(mixed(), mixed().tracks().get(0), 1);
    double[] same = {
      hearing.thresholdM(1, sight(0, 1), AnyPing.FIRST),
      hearing.echoM(2, AnyPing.FIRST),
      hearing.rangeM(3, AnyPing.FIRST),
      hearing.steppedM(4, 9, AnyPing.FIRST),
      hearing.reportedM(5, AnyPing.FIRST),
    };
    assertArrayEquals(new double[] {1, 2, 3, 4, 5}, same);
  }
}
