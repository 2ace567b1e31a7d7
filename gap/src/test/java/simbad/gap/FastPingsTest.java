package simbad.gap;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.definition.Effect;
import simbad.gap.diagnosis.DataSet;
import simbad.gap.diagnosis.Diagnosis;
import simbad.gap.diagnosis.EffectFinding;
import simbad.gap.diagnosis.Verdict;
import simbad.gap.fixture.Ladders;
import simbad.sonar.frame.Pose;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.ReadingRow;

/**
 * A board at nineteen distances, with a few milliseconds from an echo to the next ping: where the
 * board is well square to the sensor, the echo of the ping before comes back a second time, and is
 * heard from 0.3 m on. The law is that of real readings of an HC-SR04 before a metal plate.
 */
class FastPingsTest {
  private static final double SOUND_M_S = 343;
  private static final double DEAF_M = 0.3;
  private static final int READ = 24;

  /** A program and a sensor take this time off the pause; so it was with the real one. */
  private static final double OFF_S = 0.00075;

  /** What is read in the place of an echo. */
  private interface Strays {
    double readM(double distanceM, double echoM, double beforeM, Random random);
  }

  /** One distance after the other, each with its own strays. */
  private interface Places {
    Strays at(double distanceM, Random random);
  }

  private static List<ReadingRow> log(double pauseS, long seed, Places places) {
    Random random = new Random(seed);
    List<ReadingRow> rows = new ArrayList<>();
    double time = 0;
    for (int i = 0; i < 19; i++) {
      double distance = 0.15 + 0.08 * i;
      double real = distance + 0.002 * random.nextGaussian();
      Strays strays = places.at(distance, random);
      double before = 0;
      for (int k = 0; k < READ; k++) {
        double echo = real + 0.002 * random.nextGaussian();
        double read = k == 0 ? echo : strays.readM(real, echo, before, random);
        Pose pose = Pose.of(0, distance, Math.PI / 2);
        rows.add(new ReadingRow("ladder", "s", time, pose, new Echo(Math.rint(1e4 * read) / 1e4)));
        time += 2 * read / SOUND_M_S + pauseS;
        before = read;
      }
      time += 1;
    }
    return rows;
  }

  private static Places bounces(double pauseS) {
    double shift = SOUND_M_S / 2 * (pauseS - OFF_S);
    return (distance, drawn) -> {
      boolean isSquare = drawn.nextDouble() < 0.4;
      return (real, echo, before, random) -> {
        double late = 2 * real - before - shift + 0.004 * random.nextGaussian();
        boolean isHeard = isSquare && late > DEAF_M && late < echo && random.nextDouble() < 0.7;
        return isHeard ? late : echo;
      };
    };
  }

  /** At some places something else is read now and then, always the same. */
  private static Strays clutter(double distance, Random drawn) {
    boolean isThere = drawn.nextDouble() < 0.25;
    double at = distance * (0.4 + 0.5 * drawn.nextDouble());
    return (real, echo, before, random) ->
        isThere && random.nextBoolean() ? at + 0.004 * random.nextGaussian() : echo;
  }

  private static Diagnosis diagnose(List<ReadingRow> rows) {
    return new Diagnoser(1, Set.of()).diagnose(new DataSet("fast", Ladders.BOARD, rows, List.of()));
  }

  @ParameterizedTest
  @ValueSource(doubles = {0.002, 0.003, 0.005})
  void secondBounce_isOfThePingBefore(double pauseS) {
    Diagnosis diagnosis = diagnose(log(pauseS, 4, bounces(pauseS)));
    assertTrue(diagnosis.explanation().contains(Effect.PREVIOUS_PING), diagnosis.reason());
    EffectFinding found =
        diagnosis.effects().stream()
            .filter(f -> f.effect() == Effect.PREVIOUS_PING)
            .findFirst()
            .orElseThrow();
    double shift =
        found.parameters().stream()
            .filter(p -> p.name().equals("shift_m"))
            .findFirst()
            .orElseThrow()
            .value();
    assertEquals(SOUND_M_S / 2 * (pauseS - OFF_S), shift, 0.08, found.toString());
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3})
  void somethingElseNowAndThen_isNotOfThePingBefore(long seed) {
    Diagnosis diagnosis = diagnose(log(0.005, seed, FastPingsTest::clutter));
    assertFalse(diagnosis.explanation().contains(Effect.PREVIOUS_PING), diagnosis.reason());
  }

  @Test
  void fastPingsThatReadRightly_areNone() {
    Diagnosis diagnosis = diagnose(log(0.005, 2, (d, drawn) -> (real, echo, before, r) -> echo));
    assertEquals(Verdict.NONE, diagnosis.verdict(), diagnosis.reason());
  }
}
