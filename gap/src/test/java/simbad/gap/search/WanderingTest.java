package simbad.gap.search;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import simbad.definition.Parameter;
import simbad.gap.calibrate.Calibration;
import simbad.gap.calibrate.level.Leeway;
import simbad.gap.fit.CalibratedLog;
import simbad.gap.fit.Hypothesis;
import simbad.gap.fixture.LevelWorlds;
import simbad.gap.fixture.Worlds;
import simbad.sonar.effect.Form;
import simbad.sonar.frame.Pose;
import simbad.sonar.ping.Geometry;
import simbad.sonar.ping.LevelChange;
import simbad.sonar.ping.LevelEars;
import simbad.sonar.ping.PingLog;
import simbad.sonar.sensing.ReadingRow;

/** Levels that wander along one thing, and what is said of it. */
class WanderingTest {
  private static final int PINGS = 600;
  private static final double DURATION_S = 0.05 * PINGS;
  private static final Calibration CALIBRATION =
      Calibration.of(LevelWorlds.POST, new PingLog(LevelWorlds.log(800, 81)));

  /** Fainter or stronger by some decibels where something holds. */
  private record Loud(double decibels, Where where) implements LevelChange {
    @Override
    public double addedDb(LevelEars ears, Geometry geometry, int line) {
      return where.holds(geometry, line) ? decibels : 0;
    }
  }

  private interface Where {
    boolean holds(Geometry geometry, int line);
  }

  private static List<Wandering.Curve> curves(
      List<ReadingRow> poses, Hypothesis truth, double durationS) {
    CalibratedLog given =
        CALIBRATION.given(
            LevelWorlds.POST, new PingLog(Worlds.read(LevelWorlds.POST, poses, truth, 83)));
    Leeway open = CALIBRATION.leeway().orElseThrow();
    return new Wandering(open, given, Hypothesis.NONE, durationS).curves();
  }

  private static String likeliest(double decibels, Where where) {
    Form form =
        new Form(Optional.empty(), "loud", List.<Parameter>of(), v -> new Loud(decibels, where));
    return curves(LevelWorlds.poses(PINGS, 82), LevelWorlds.truth().and(form), DURATION_S).stream()
        .max(Comparator.comparingDouble(Wandering.Curve::nats))
        .orElseThrow()
        .what();
  }

  /** Along bearing, side, distance and time, by 2, 5 and 12 dB each. */
  @Test
  void curves_areOfEachWayAndSpread() {
    List<ReadingRow> poses = LevelWorlds.poses(PINGS, 82);
    List<Wandering.Curve> all = curves(poses, LevelWorlds.truth(), DURATION_S);
    assertEquals(12, all.size());
    List<String> places = List.of("at bearings of", "the ", "at distances of", "s after the start");
    for (int i = 0; i < 12; i++) {
      String what = all.get(i).what();
      assertTrue(what.contains(places.get(i / 3)), what);
    }
    assertEquals(9, curves(poses, LevelWorlds.truth(), 0).size(), "nothing can be said of time");
  }

  @Test
  void curve_saysWhereAndHowMuch() {
    String side = likeliest(-9, (g, line) -> g.offAxisRad(line) > 0);
    assertTrue(side.startsWith("echoes are weaker than the set-up says, by up to "), side);
    assertTrue(side.endsWith("degrees to the left"), side);
    String right = likeliest(-9, (g, line) -> g.offAxisRad(line) < 0);
    assertTrue(right.endsWith("degrees to the right"), right);
    String bearing =
        likeliest(9, (g, line) -> Math.abs(Math.toDegrees(g.bearingRad(line)) - 200) < 40);
    assertTrue(bearing.startsWith("echoes are stronger than the set-up says, by up to "), bearing);
    assertTrue(bearing.matches(".* at bearings of about (1[6-9]|2[0-4])0 degrees"), bearing);
    String time = likeliest(-9, (g, line) -> g.sinceStartS(line) > 0.6 * DURATION_S);
    assertTrue(time.matches(".* at about (1[89]|2.|30) s after the start"), time);
  }

  /** Where nothing is in the cone every curve only costs what choosing it does. */
  @Test
  void whereNothingIsHeard_aCurveCostsItsChoice() {
    List<ReadingRow> away = new ArrayList<>();
    for (ReadingRow row : LevelWorlds.poses(50, 82)) {
      double heading = row.pose().heading().radians() + Math.PI;
      Pose pose = Pose.of(row.pose().position().xM(), row.pose().position().zM(), heading);
      away.add(new ReadingRow(row.run(), row.sensor(), row.timeS(), pose, row.reading()));
    }
    CalibratedLog given = CALIBRATION.given(LevelWorlds.POST, new PingLog(away));
    double still = Arrays.stream(given.logLikelihood(Hypothesis.NONE)).sum();
    Leeway open = CALIBRATION.leeway().orElseThrow();
    for (double durationS : new double[] {0, 2.5}) {
      double choice = Math.log(durationS > 0 ? 12 : 9);
      for (Wandering.Curve curve :
          new Wandering(open, given, Hypothesis.NONE, durationS).curves()) {
        assertEquals(still - choice, curve.nats(), 1e-6, curve.what());
      }
    }
  }
}
