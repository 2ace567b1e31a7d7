package simbad.blindworld.design;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.Test;
import simbad.blindworld.world.Chance;
import simbad.blindworld.world.Obstacle;
import simbad.blindworld.world.Point;
import simbad.blindworld.world.Pose;
import simbad.blindworld.world.Recording;
import simbad.blindworld.world.Row;
import simbad.blindworld.world.Scene;
import simbad.blindworld.world.Sensor;
import simbad.blindworld.world.Shadow;
import simbad.blindworld.world.Track;

/** Recordings of a bench and of a drive, over many designs. Rows are rounded as in a file. */
class RecordedDesignsTest {

  private static final double HALF_ANGLE_RAD = 0.3;
  private static final double RADIUS_M = 0.1;
  private static final Point CENTRE = new Point(0.4, -0.3);

  /** A tenth of a millimetre in both directions. */
  private static final double ROUNDED_M = 1e-4;

  private static final double ROUNDED_RAD = Math.toRadians(1e-3);

  private static Scene scene() {
    Sensor sensor = new Sensor("s", HALF_ANGLE_RAD, 0.02, 4, 0.15, 343, 0.01, 0, 0, 1e-6, 0.1);
    List<Point> outline =
        List.of(new Point(RADIUS_M, 0), new Point(0, RADIUS_M), new Point(-RADIUS_M, 0));
    return new Scene(
        5, sensor, List.of(new Obstacle("o", CENTRE, 0.5, outline, Shadow.uniform(1.5))));
  }

  private static double away(Pose pose) {
    return Math.hypot(pose.xM() - CENTRE.xM(), pose.zM() - CENTRE.zM());
  }

  /** By how much a pose looks beside the obstacle's middle. */
  private static double aside(Pose pose) {
    double towards = Math.atan2(pose.zM() - CENTRE.zM(), CENTRE.xM() - pose.xM());
    return Math.IEEEremainder(pose.headingRad() - towards, 2 * Math.PI);
  }

  private static void assertWithin(double least, double most, double value) {
    assertTrue(value >= least && value <= most, least + " " + value + " " + most);
  }

  @Test
  void row_isRoundedAsInAFile() {
    Row row = Rows.row("r", "s", 1.23456, new Pose(0.123456, -0.98766, Math.toRadians(370.12345)));
    assertEquals("r", row.run());
    assertEquals("s", row.sensor());
    assertEquals(1.235, row.tS(), 1e-12);
    assertEquals(0.1235, row.pose().xM(), 1e-12);
    assertEquals(-0.9877, row.pose().zM(), 1e-12);
    assertEquals(10.123, Math.toDegrees(row.pose().headingRad()), 1e-9);
  }

  private static Map<String, List<Row>> bench(long seed, int rows) {
    Chance random = new Chance(seed);
    Design design = Design.draw("bench", random);
    assertEquals("bench", design.kind());
    Recording recording = design.record(scene(), rows, random);
    assertEquals(rows, recording.size());
    assertEquals(1, recording.sensors().size());
    Map<String, List<Row>> runs = new LinkedHashMap<>();
    for (Row row : recording.rows()) {
      runs.computeIfAbsent(row.run(), name -> new ArrayList<>()).add(row);
    }
    for (List<Row> run : runs.values()) {
      for (int k = 0; k < run.size(); k++) {
        assertEquals(k * design.periodS(), run.get(k).tS(), 6e-4);
        assertTrue(away(run.get(k).pose()) > RADIUS_M + 0.05 - ROUNDED_M);
      }
    }
    return runs;
  }

  private static boolean isKind(String name, String word, String letter) {
    return name.equals(word) || name.equals(letter);
  }

  /** Shares of 0.15 to 0.6 sweeps, 0.05 to 0.2 scans and up to a quarter on the turntable. */
  @Test
  void bench_hasItsShares() {
    Set<Double> periods = new HashSet<>();
    for (int seed = 0; seed < 40; seed++) {
      Map<String, List<Row>> runs = bench(seed, 400);
      int rest = 400;
      for (Map.Entry<String, List<Row>> run : runs.entrySet()) {
        int size = run.getValue().size();
        rest -= size;
        if (isKind(run.getKey(), "sweep", "A")) {
          assertWithin(0.15 * 400 - 1, 0.6 * 400, size);
        } else if (isKind(run.getKey(), "scan", "B")) {
          assertWithin(0.05 * 400 - 1, 0.2 * 400, size);
        } else if (isKind(run.getKey(), "turntable", "C")) {
          assertWithin(0, 0.25 * 400, size);
        } else {
          assertTrue(isKind(run.getKey(), "random", "D"), run.getKey());
        }
      }
      assertEquals(0, rest);
      periods.add(Design.draw("bench", new Chance(seed)).periodS());
    }
    assertEquals(Set.of(0.05, 0.1, 0.2, 0.25, 0.3, 0.5), periods);
  }

  /** Out by even steps of 1 to 5 cm from 8 cm before the surface, and in again. */
  @Test
  void sweep_goesOutAndIn() {
    for (int seed = 0; seed < 40; seed++) {
      List<Row> run = bench(seed, 8000).entrySet().iterator().next().getValue();
      double from = RADIUS_M + 0.08;
      assertEquals(from, away(run.get(0).pose()), ROUNDED_M);
      double step = away(run.get(1).pose()) - away(run.get(0).pose());
      assertWithin(0.01 - 2 * ROUNDED_M, 0.05 + 2 * ROUNDED_M, step);
      assertEquals(Math.rint(step / 0.005), step / 0.005, 0.05);
      double exact = 0.005 * Math.rint(step / 0.005);
      int out = 0;
      while (away(run.get(out + 1).pose()) > away(run.get(out).pose()) + exact / 2) {
        out++;
      }
      double off = aside(run.get(0).pose());
      assertWithin(-Math.toRadians(2.1), Math.toRadians(2.1), off);
      // Until 1.05 to 1.9 times the threshold, 1.5 m, and 10 cm more.
      assertWithin(1.05 * 1.5 + 0.1 - exact - 2e-4, 1.9 * 1.5 + 0.1, away(run.get(out).pose()));
      double bearing =
          Math.atan2(run.get(0).pose().xM() - CENTRE.xM(), run.get(0).pose().zM() - CENTRE.zM())
              - 0.5;
      double steps = Math.toDegrees(bearing) / 5;
      assertEquals(Math.rint(steps), steps, 0.01, "at bearings of 5 degrees");
      for (int k = 0; k <= out; k++) {
        Pose pose = run.get(k).pose();
        assertEquals(from + k * exact, away(pose), ROUNDED_M);
        assertEquals(off, aside(pose), 2e-3);
        assertEquals(pose, run.get(2 * out + 1 - k).pose(), "in again");
      }
    }
  }

  /** 81 headings over 1.4 half-angles to either side, on the spot. */
  @Test
  void scan_turnsOnTheSpot() {
    int found = 0;
    for (int seed = 0; seed < 40; seed++) {
      for (Map.Entry<String, List<Row>> one : bench(seed, 2000).entrySet()) {
        if (isKind(one.getKey(), "scan", "B") && one.getValue().size() >= 81) {
          List<Row> run = one.getValue();
          found++;
          for (int k = 0; k <= 80; k++) {
            Pose pose = run.get(k).pose();
            assertEquals(run.get(0).pose().xM(), pose.xM());
            assertEquals(run.get(0).pose().zM(), pose.zM());
            assertEquals(1.4 * HALF_ANGLE_RAD * (k - 40) / 40, aside(pose), 1e-3);
          }
          assertWithin(
              RADIUS_M + 0.08 + 0.15, RADIUS_M + 0.08 + 0.95 * 1.5, away(run.get(0).pose()));
        }
      }
    }
    assertTrue(found > 10, found + " scans");
  }

  /** Three degrees at a time at one distance, looking at the middle. */
  @Test
  void turntable_turnsTheObstacle() {
    int found = 0;
    for (int seed = 0; seed < 40; seed++) {
      for (Map.Entry<String, List<Row>> one : bench(seed, 2000).entrySet()) {
        if (isKind(one.getKey(), "turntable", "C") && one.getValue().size() >= 120) {
          List<Row> run = one.getValue();
          found++;
          double r = away(run.get(0).pose());
          assertWithin(RADIUS_M + 0.1 + 0.15, RADIUS_M + 0.1 + 0.9 * 1.5, r);
          for (int k = 0; k < 120; k++) {
            Pose pose = run.get(k).pose();
            assertEquals(r, away(pose), 2 * ROUNDED_M);
            assertEquals(0, aside(pose), 1e-3);
            double bearing = Math.atan2(pose.xM() - CENTRE.xM(), pose.zM() - CENTRE.zM()) - 0.5;
            assertEquals(0, Math.IEEEremainder(bearing - Math.toRadians(3 * k), 2 * Math.PI), 1e-3);
          }
        }
      }
    }
    assertTrue(found > 5, found + " turntables");
  }

  /** Anywhere from 8 cm before the surface, beside by up to 2.6 half-angles. */
  @Test
  void anywhere_isBesideToo() {
    double most = 0;
    double furthest = 0;
    for (int seed = 0; seed < 40; seed++) {
      for (Map.Entry<String, List<Row>> one : bench(seed, 500).entrySet()) {
        if (isKind(one.getKey(), "random", "D")) {
          for (Row row : one.getValue()) {
            assertWithin(
                RADIUS_M + 0.08 - ROUNDED_M, RADIUS_M + 0.08 + 1.5 * 2.1, away(row.pose()));
            assertWithin(
                -2.6 * HALF_ANGLE_RAD - 1e-3, 2.6 * HALF_ANGLE_RAD + 1e-3, aside(row.pose()));
            most = Math.max(most, Math.abs(aside(row.pose())));
            furthest = Math.max(furthest, away(row.pose()));
          }
        }
      }
    }
    assertWithin(2.2 * HALF_ANGLE_RAD, 2.6 * HALF_ANGLE_RAD + 1e-3, most);
    assertWithin(2.5, 3.4, furthest);
  }

  /** Poses round one obstacle that would be in or at another one are left out. */
  @Test
  void bench_keepsOffEveryObstacle() {
    Obstacle one = scene().obstacles().get(0);
    Point place = new Point(CENTRE.xM() + 0.5, CENTRE.zM());
    Obstacle other = new Obstacle("p", place, 0, one.outline(), Shadow.uniform(1.2));
    Scene two = new Scene(5, scene().sensor(), List.of(one, other));
    double nearest = 9;
    Set<Boolean> sides = new HashSet<>();
    for (int seed = 0; seed < 40; seed++) {
      Chance random = new Chance(seed);
      Recording recording = Design.draw("bench", random).record(two, 500, random);
      assertEquals(500, recording.size());
      for (Row row : recording.rows()) {
        Pose pose = row.pose();
        double away = Math.hypot(pose.xM() - place.xM(), pose.zM() - place.zM());
        nearest = Math.min(nearest, Math.min(away, away(pose)));
        sides.add(away < away(pose));
      }
    }
    assertWithin(RADIUS_M + 0.05 - ROUNDED_M, RADIUS_M + 0.06, nearest);
    assertEquals(Set.of(true, false), sides);
  }

  private record Driven(Design design, Recording recording, int transducers) {}

  private static Driven drive(long seed) {
    Chance random = new Chance(seed);
    Design design = Design.draw("run", random);
    assertEquals("run", design.kind());
    Recording recording = design.record(scene(), 1200, random);
    return new Driven(design, recording, recording.sensors().size());
  }

  /** Three to seven runs of one to six transducers, of some 1200 rows. */
  @Test
  void drive_hasRunsAndTransducers() {
    Set<Integer> counts = new HashSet<>();
    Set<Integer> runs = new HashSet<>();
    for (int seed = 0; seed < 60; seed++) {
      Driven driven = drive(seed);
      counts.add(driven.transducers);
      long named = driven.recording.rows().stream().map(Row::run).distinct().count();
      runs.add((int) named);
      assertEquals(named * driven.transducers, driven.recording.tracks().size());
      assertWithin(0.8 * 1200, 1.2 * 1200, driven.recording.size());
      for (Track track : driven.recording.tracks()) {
        List<Integer> rows = track.rows();
        double first = driven.recording.tS(rows.get(0));
        for (int k = 0; k < rows.size(); k++) {
          double tS = driven.recording.tS(rows.get(k));
          assertEquals(first + k * driven.design.periodS(), tS, 2e-3);
        }
        assertWithin(0, driven.design.periodS(), first);
      }
    }
    assertEquals(Set.of(1, 2, 3, 4, 5, 6), counts);
    assertEquals(Set.of(3, 4, 5, 6, 7), runs);
  }

  /** Where transducers ping together they stand on one circle and look evenly spread. */
  @Test
  void transducers_standAroundTheRobot() {
    int forward = 0;
    for (int seed = 0; seed < 60; seed++) {
      Driven driven = drive(seed);
      List<Row> rows = driven.recording.rows();
      int n = driven.transducers;
      boolean together = n > 1 && rows.get(0).tS() == rows.get(n - 1).tS();
      for (int ping = 0; together && ping < rows.size() / n; ping += 7) {
        List<Row> now = rows.subList(ping * n, ping * n + n);
        double spread = headings(now.get(0), now.get(1));
        assertWithin(Math.toRadians(15) - 1e-4, Math.toRadians(61), spread);
        double chord = chord(now.get(0), now.get(1));
        double radius = chord / (2 * Math.sin(spread / 2));
        assertWithin(0, 0.0905, radius);
        forward += radius > 0.015 ? 1 : 0;
        for (int s = 1; s < n; s++) {
          assertEquals(spread, headings(now.get(s - 1), now.get(s)), 4 * ROUNDED_RAD);
          assertEquals(chord, chord(now.get(s - 1), now.get(s)), 4 * ROUNDED_M);
        }
      }
    }
    assertTrue(forward > 0, "some stand before the middle");
  }

  private static double headings(Row one, Row other) {
    double turn = other.pose().headingRad() - one.pose().headingRad();
    return Math.IEEEremainder(turn, 2 * Math.PI);
  }

  private static double chord(Row one, Row other) {
    return one.pose().distanceM(other.pose());
  }

  /**
   * A robot turns by 1.4 rad/s at most, goes 0.6 m/s and 12 cm in a ping at most, each up to 1.3
   * and 1.6 times as fast, and stays 9 cm off the obstacle.
   */
  @Test
  void robot_keepsItsLimits() {
    double nearest = 9;
    double mostTurn = 0;
    for (int seed = 0; seed < 60; seed++) {
      Driven driven = drive(seed);
      double period = driven.design.periodS();
      for (Track track : driven.recording.tracks()) {
        Pose last = driven.recording.pose(track.rows().get(0));
        for (int row : track.rows()) {
          Pose pose = driven.recording.pose(row);
          double turn =
              Math.abs(Math.IEEEremainder(pose.headingRad() - last.headingRad(), 2 * Math.PI));
          assertWithin(0, 1.4 * period + 2 * ROUNDED_RAD, turn);
          mostTurn = Math.max(mostTurn, turn / period);
          // A transducer before the middle swings round besides; being pushed out, it slides.
          double most = Math.min(0.6 * period, 0.12) * 1.3 * 1.6;
          double away = away(pose);
          if (away > RADIUS_M + 0.35) {
            assertWithin(0, most + 0.09 * turn + 0.01, pose.distanceM(last));
          }
          assertTrue(away > RADIUS_M + 0.09 - 3e-3, away + " m");
          nearest = Math.min(nearest, away);
          last = pose;
        }
      }
    }
    assertWithin(RADIUS_M + 0.087, RADIUS_M + 0.1, nearest);
    assertWithin(1.39, 1.41, mostTurn);
  }

  /** It drives forward: the step is along the heading, as far as rounding lets see. */
  @Test
  void robot_drivesAlongItsHeading() {
    int steps = 0;
    for (int seed = 0; seed < 200; seed++) {
      Driven driven = drive(seed);
      if (driven.transducers % 2 == 1) {
        Track track = driven.recording.tracks().get(driven.transducers / 2);
        Double beside = null;
        for (int k = 1; k < track.rows().size(); k++) {
          Pose last = driven.recording.pose(track.rows().get(k - 1));
          Pose pose = driven.recording.pose(track.rows().get(k));
          boolean straight = Math.abs(pose.headingRad() - last.headingRad()) < 1e-5;
          if (straight && pose.distanceM(last) > 0.01 && away(pose) > 0.5) {
            double way = Math.atan2(last.zM() - pose.zM(), pose.xM() - last.xM());
            double aim = Math.IEEEremainder(pose.headingRad() - way, 2 * Math.PI);
            beside = beside == null ? aim : beside;
            // The middle transducer looks beside the way by one and the same angle.
            assertEquals(beside, aim, 0.03);
            assertWithin(-Math.PI / 2 - 0.02, Math.PI / 2 + 0.02, aim);
            steps++;
          }
        }
      }
    }
    assertTrue(steps > 100, steps + " steps");
  }
}
