package simbad.gap.score;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.Test;

class WeightsTest {
  /** As probable as 1, 4, 2 and 1 to each other. */
  private static final Weights<String> WEIGHTS =
      new Weights<>(
          List.of(Set.of(), Set.of("a", "b"), Set.of("b", "c"), Set.of("b", "c", "d")),
          new double[] {0, Math.log(4), Math.log(2), 0});

  @Test
  void shares_goWithTheLikelihoods() {
    assertEquals(1, WEIGHTS.best());
    assertEquals(Math.log(2), WEIGHTS.behind(2), 1e-12);
    assertEquals(1.0 / 8, WEIGHTS.of(Set::isEmpty), 1e-12);
    Map<String, Double> effects = WEIGHTS.ofEffects(effect -> Set.of());
    assertEquals(4.0 / 8, effects.getOrDefault("a", 0.0), 1e-12);
    assertEquals(7.0 / 8, effects.getOrDefault("b", 0.0), 1e-12);
    assertEquals(1.0 / 8, effects.getOrDefault("d", 0.0), 1e-12);
  }

  /** What cannot be told from an effect has half of its share. */
  @Test
  void twins_shareAlike() {
    Map<String, Double> effects =
        WEIGHTS.ofEffects(effect -> effect.equals("a") ? Set.of("z") : Set.of());
    assertEquals(2.0 / 8, effects.getOrDefault("a", 0.0), 1e-12);
    assertEquals(2.0 / 8, effects.getOrDefault("z", 0.0), 1e-12);
  }

  @Test
  void without_hasAllElseAndMore() {
    assertArrayEquals(new int[] {2, 3}, WEIGHTS.without("a", Set.of("a", "b")).toArray());
    assertArrayEquals(new int[0], WEIGHTS.without("b", Set.of("a", "b")).toArray());
    assertEquals(Set.of("c"), WEIGHTS.beyond(2, Set.of("a", "b")));
  }

  @Test
  void logs_areNumbers() {
    assertThrows(
        IllegalArgumentException.class,
        () -> new Weights<>(List.of(Set.of("a")), new double[] {Double.NaN}));
  }
}
