package simbad.gap.design;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import simbad.definition.Effect;
import simbad.gap.fixture.Worlds;
import simbad.sonar.change.OrientationShadow;
import simbad.sonar.effect.Definitions;
import simbad.sonar.effect.Probe;
import simbad.sonar.ping.PingLog;
import simbad.sonar.shape.ThresholdTable;

class ProbesTest {
  private static final PingLog LOG = new PingLog(Worlds.poses(50, 0.3, 1.4, 1));

  private static Probe probe(Effect effect) {
    return Definitions.of(effect).probes(Worlds.POST, LOG).get(0);
  }

  /** The values that a probe tries at its practical size. */
  private static List<Double> tried(Probe probe) {
    List<Double> values = new ArrayList<>();
    new Showing(probe)
        .showsInPractice(
            added -> {
              values.add(added.values()[probe.index()]);
              return 0;
            },
            1);
    return values;
  }

  @ParameterizedTest
  @MethodSource("simbad.sonar.effect.Definitions#effects")
  void probe_isOfItsEffect(Effect effect) {
    List<Probe> probes = Definitions.of(effect).probes(Worlds.POST, LOG);
    assertTrue(!probes.isEmpty());
    for (Probe probe : probes) {
      assertEquals(effect, probe.form().effect());
      assertTrue(!tried(probe).isEmpty(), "the practical size is within the parameter's bounds");
    }
  }

  /** 3 m/s more or less; half a metre for a time-out that was none. */
  @Test
  void size_isADepartureEitherWay_orTheValueWhereNeutralIsInfinite() {
    assertEquals(List.of(346.0, 340.0), tried(probe(Effect.SOUND_SPEED)));
    // Three quarters of the threshold of 1.5 m.
    assertEquals(List.of(1.125), tried(probe(Effect.EARLY_TIMEOUT)));
  }

  /** By a tenth, up before and behind the post and down at its sides. */
  @Test
  void shadow_swingsTwiceInATurn() {
    Probe probe = probe(Effect.ORIENTATION_SHADOW);
    assertEquals(List.of(0.1), tried(probe));
    List<ThresholdTable> tables = new ArrayList<>();
    new Showing(probe)
        .showsInPractice(
            added -> {
              OrientationShadow shadow = (OrientationShadow) added.changes().get(0);
              tables.add(shadow.table());
              return 0;
            },
            1);
    for (int degrees = 0; degrees < 360; degrees += 15) {
      double swing = 1.5 * (1 + 0.1 * Math.cos(2 * Math.toRadians(degrees)));
      assertEquals(swing, tables.get(0).thresholdM(Math.toRadians(degrees)), 1e-3, "at " + degrees);
    }
  }

  /** The least size that shows is found to a sixty-fourth of a ratio. */
  @Test
  void leastSize_isWhereTheFallReachesTheNats() {
    Showing offset = new Showing(probe(Effect.RANGE_OFFSET));
    double least = offset.leastSize(added -> Math.abs(added.values()[0]) * 100, 7).orElseThrow();
    assertEquals(0.07, least, 0.002);
    assertTrue(offset.leastSize(added -> 0, 7).isEmpty());
  }

  @Test
  void manoeuvres_areWhatTheyAreSaidToBe() {
    List<Manoeuvre> all = Manoeuvres.before(Worlds.POST);
    // 24 bearings slow and fast, 8 ladders, 8 times 4 turns, 4 times 4 rounds.
    assertEquals(48 + 8 + 32 + 16, all.size());
    List<Manoeuvre> rounds = all.subList(88, 104);
    for (Manoeuvre round : rounds) {
      TreeSet<Long> bearings = new TreeSet<>();
      for (int i = 0; i < round.poses().size(); i++) {
        double x = round.poses().get(i).position().xM();
        double z = round.poses().get(i).position().zM();
        bearings.add(Math.round(75 * (Math.atan2(x, z) / (2 * Math.PI) + 1)) % 75);
        assertEquals(radiusM(round, 0), radiusM(round, i), 1e-9);
      }
      assertEquals(75, bearings.size(), "once round in even steps");
      double speed = 2 * Math.PI * radiusM(round, 0) / 75 / round.stepS();
      assertTrue(
          speed <= 0.6 + 1e-9 && (round.stepS() <= 0.05 + 1e-9 || speed > 0.599), "" + speed);
    }
  }

  private static double radiusM(Manoeuvre round, int ping) {
    return Math.hypot(
        round.poses().get(ping).position().xM(), round.poses().get(ping).position().zM());
  }
}
