package simbad.gap.fit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import simbad.definition.Effect;
import simbad.gap.fixture.Worlds;
import simbad.sonar.effect.Definitions;
import simbad.sonar.effect.Form;

/** A search that starts far from the truth does not find it: some start is near it. */
class StartsTest {
  private static Arguments of(Effect effect, String form, double[] truth, int value, double near) {
    return Arguments.of(effect, form, truth, value, near);
  }

  private static double[] values(double... values) {
    return values;
  }

  static List<Arguments> worlds() {
    return List.of(
        of(Effect.MULTIPATH, "added", values(0.4, 0.3, 0.1), 1, 0.03),
        of(Effect.MULTIPATH, "factor", values(0.4, 1.5, 0.05), 1, 0.05),
        of(Effect.MULTIPATH, "both", values(0.3, 0.3, 0.2, 1.6, 0.05), 1, 0.04),
        of(Effect.PREVIOUS_PING, "shift", values(0.4, 0.35, 0.005), 1, 0.03),
        of(Effect.PREVIOUS_PING, "factor", values(0.4, 0.6, 0.005), 1, 0.03),
        of(Effect.PREVIOUS_PING, "line", values(0.4, 0.7, 0.1, 0.005), 1, 0.04),
        of(Effect.PREVIOUS_PING, "line", values(0.4, 0.7, 0.1, 0.005), 2, 0.04),
        of(Effect.COARSE_RESOLUTION, "start", values(0.07), 0, 1e-9),
        of(Effect.COARSE_RESOLUTION, "centre", values(0.08), 0, 1e-3),
        of(Effect.NEAR_CLAMP, "clamp", values(0.4), 0, 0.006),
        of(Effect.DEAD_ZONE, "sharp", values(0.45), 0, 0.06),
        of(Effect.EARLY_TIMEOUT, "sharp", values(0.9), 0, 0.06),
        of(Effect.FLOOR_ECHO, "fixed", values(1.2, 0.01, 0.9), 0, 0.02),
        of(Effect.CROSSTALK, "any", values(0.3, 0.5, 2), 0, 0.12),
        of(Effect.CROSSTALK, "any", values(0.3, 0.5, 2), 1, 0.1),
        of(Effect.CROSSTALK, "any", values(0.3, 0.5, 2), 2, 0.2));
  }

  @ParameterizedTest
  @MethodSource("worlds")
  void someStart_isNearTheTruth(
      Effect effect, String name, double[] truth, int value, double near) {
    Hypothesis world = Worlds.effect(effect, name, truth);
    Form form = world.forms().get(0);
    LogClues clues =
        new LogClues(
            Worlds.given(Worlds.read(Worlds.poses(600, 0.2, 1.4, 7), world, 12)), Hypothesis.NONE);
    List<double[]> starts = Definitions.of(effect).starts(form, clues);
    double nearest =
        starts.stream()
            .mapToDouble(start -> Math.abs(start[value] - truth[value]))
            .min()
            .orElseThrow();
    assertTrue(nearest <= near, nearest + " from " + truth[value]);
    for (double[] start : starts) {
      for (int i = 0; i < start.length; i++) {
        String what = form + " " + Arrays.toString(start);
        assertEquals(form.parameters().get(i).clamp(start[i]), start[i], what);
      }
    }
  }

  @Test
  void hypothesis_withoutAnEffect_keepsTheOthersValues() {
    Hypothesis gain = Worlds.effect(Effect.GAIN, "factor", 0.9);
    Form offset = Worlds.effect(Effect.RANGE_OFFSET, "constant", 0.1).forms().get(0);
    Hypothesis both = gain.and(offset, 0.1);
    assertEquals(gain, both.without(Effect.RANGE_OFFSET));
    assertEquals(Hypothesis.NONE.and(offset, 0.1), both.without(Effect.GAIN));
    assertEquals(both, both.without(Effect.LATENCY));
    assertFalse(both.hasTable());
    assertEquals("gain/factor[0.9] + range-offset/constant[0.1]", both.toString());
    double[] table = new double[72];
    Arrays.fill(table, 1);
    Hypothesis shadow = Worlds.effect(Effect.ORIENTATION_SHADOW, "table:post#0", table);
    assertTrue(shadow.hasTable() && both.and(shadow.forms().get(0), table).hasTable());
  }
}
