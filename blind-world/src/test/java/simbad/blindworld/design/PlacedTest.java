package simbad.blindworld.design;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import simbad.blindworld.world.Chance;
import simbad.blindworld.world.Obstacle;
import simbad.blindworld.world.Point;
import simbad.blindworld.world.Pose;
import simbad.blindworld.world.Recording;
import simbad.blindworld.world.Scene;
import simbad.blindworld.world.Shadow;
import simbad.blindworld.world.TestWorlds;

/** Ladders and spots at which a hand puts the sonar, over many designs. */
class PlacedTest {

  private static final double RADIUS_M = TestWorlds.post("o", 0, 0, 1.5).radiusM();

  private static Scene scene() {
    Obstacle near = TestWorlds.post("o", 0, 0, 1.5);
    Obstacle far = new Obstacle("p", new Point(0.9, 0), 0, near.outline(), Shadow.uniform(1.2));
    return new Scene(5, TestWorlds.sureSensor(15), List.of(near, far));
  }

  private static Recording recording(long seed, int rows) {
    Chance random = new Chance(seed);
    Design design = Design.placed(random);
    assertEquals("placed", design.kind());
    return design.record(scene(), rows, random);
  }

  private static double away(Pose pose, double xM) {
    return Math.hypot(pose.xM() - xM, pose.zM());
  }

  /** 5 to 20 readings at each place but the last of each part. */
  @Test
  void eachPlace_isReadSeveralTimes() {
    Set<Integer> times = new HashSet<>();
    for (int seed = 0; seed < 60; seed++) {
      Recording recording = recording(seed, 600);
      assertTrue(recording.size() > 500 && recording.size() <= 600, recording.size() + " rows");
      List<List<Integer>> placements = recording.placements();
      int usual = placements.get(0).size();
      times.add(usual);
      int fewer = 0;
      for (List<Integer> placement : placements) {
        assertEquals(placement.size() - 1, placement.get(placement.size() - 1) - placement.get(0));
        fewer += placement.size() < usual ? 1 : 0;
      }
      assertTrue(fewer <= 2, fewer + " places with fewer readings");
    }
    assertEquals(5, times.stream().min(Integer::compare).orElseThrow());
    assertEquals(20, times.stream().max(Integer::compare).orElseThrow());
  }

  /** Even steps of 5 to 20 cm on one line through the obstacle's middle, which it looks at. */
  @Test
  void ladder_goesAwayOnALine() {
    int steps = 0;
    for (int seed = 0; seed < 40; seed++) {
      Recording recording = recording(seed, 600);
      double step = Double.NaN;
      List<List<Integer>> placements = recording.placements();
      for (int k = 1; k < placements.size(); k++) {
        int row = placements.get(k).get(0);
        int last = placements.get(k - 1).get(0);
        String run = recording.rows().get(row).run();
        if (run.startsWith("ladder") && run.equals(recording.rows().get(last).run())) {
          double here = recording.pose(row).distanceM(recording.pose(last));
          assertEquals(recording.pose(last).headingRad(), recording.pose(row).headingRad(), 1e-9);
          // One that would stand too near to the other obstacle is left out.
          step = Double.isNaN(step) ? here : Math.min(step, here);
          assertTrue(here > 0.0498 && Math.abs(Math.IEEEremainder(here, 0.05)) < 4e-4, here + " m");
          steps++;
        }
      }
      assertTrue(step < 0.2002, step + " m");
    }
    assertTrue(steps > 400, steps + " steps");
  }

  /** 27 cm off each obstacle's surface, so that nobody who is 25 cm off stands in one. */
  @Test
  void places_areFree() {
    double nearest = 9;
    for (int seed = 0; seed < 40; seed++) {
      Recording recording = recording(seed, 400);
      for (int row = 0; row < recording.size(); row++) {
        Pose pose = recording.pose(row);
        nearest = Math.min(nearest, Math.min(away(pose, 0), away(pose, 0.9)));
      }
    }
    assertTrue(nearest > RADIUS_M + 0.27 - 1e-4 && nearest < RADIUS_M + 0.31, nearest + " m");
  }

  /** The hand needs 10 to 59 s from place to place. */
  @Test
  void times_leaveTimeForMoving() {
    for (int seed = 0; seed < 20; seed++) {
      Chance random = new Chance(seed);
      Design design = Design.placed(random);
      Recording recording = design.record(scene(), 300, random);
      List<List<Integer>> placements = recording.placements();
      List<Integer> first = placements.get(0);
      assertEquals(design.periodS(), recording.tS(first.get(1)) - recording.tS(first.get(0)), 1e-9);
      double move =
          recording.tS(placements.get(1).get(0)) - recording.tS(first.get(first.size() - 1));
      assertTrue(move > 10 && move < 60 * 4, move + " s");
    }
  }
}
