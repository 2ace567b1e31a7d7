package simbad.gap.design;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import simbad.definition.Effect;
import simbad.gap.diagnosis.Undetectable;
import simbad.gap.fit.CalibratedLog;
import simbad.gap.fit.Hypothesis;
import simbad.gap.fixture.Worlds;
import simbad.sonar.effect.Definitions;
import simbad.sonar.sensing.ReadingRow;

class UndetectablesTest {
  private static final double NATS = 8;

  private static List<ReadingRow> read(int count, double fromM, double toM) {
    return Worlds.read(Worlds.poses(count, fromM, toM, 1), Hypothesis.NONE, 2);
  }

  private static Map<Effect, Undetectable> of(List<ReadingRow> rows, Hypothesis explained) {
    return Undetectables.of(Worlds.given(rows), explained, NATS).stream()
        .collect(Collectors.toMap(Undetectable::effect, Function.identity()));
  }

  @Test
  void farReadings_showNoDeadZone_butOneThatReachesThem() {
    Map<Effect, Undetectable> far = of(read(400, 1.0, 1.6), Hypothesis.NONE);
    Undetectable zone = Objects.requireNonNull(far.get(Effect.DEAD_ZONE));
    assertEquals("end_m", zone.parameter());
    // The nearest surface that the sensor met is 0.95 m away.
    assertEquals(0.97, zone.leastSize().orElseThrow(), 0.05);
    assertFalse(far.containsKey(Effect.RANGE_OFFSET), far::toString);
  }

  @Test
  void nearReadings_showADeadZone() {
    Map<Effect, Undetectable> near = of(read(400, 0.1, 1.6), Hypothesis.NONE);
    assertFalse(near.containsKey(Effect.DEAD_ZONE), near::toString);
  }

  @Test
  void leastSize_isWhereTheLikelihoodFallsByTheNats() {
    List<ReadingRow> rows = read(60, 0.3, 1.6);
    CalibratedLog given = Worlds.given(rows);
    Undetectable dropout = Objects.requireNonNull(of(rows, Hypothesis.NONE).get(Effect.DROPOUT));
    double size = dropout.leastSize().orElseThrow();
    assertTrue(size > 0.05, dropout::toString);
    double fall =
        Arrays.stream(given.logLikelihood(Hypothesis.NONE)).sum()
            - Arrays.stream(given.logLikelihood(Worlds.effect(Effect.DROPOUT, "single", size)))
                .sum();
    assertEquals(NATS, fall, 0.5);
  }

  @Test
  void whatIsExplained_isNotListed() {
    Hypothesis zone = Worlds.effect(Effect.DEAD_ZONE, "sharp", 0.5);
    assertFalse(of(read(100, 1.0, 1.6), zone).containsKey(Effect.DEAD_ZONE));
  }

  @Test
  void noReadings_showNothing() {
    Map<Effect, Undetectable> all = of(List.of(), Hypothesis.NONE);
    // An object has no place where nothing ever looked: it has no probe, so it is not judged.
    assertTrue(all.size() >= Definitions.effects().size() - 1, all::toString);
    assertTrue(all.values().stream().allMatch(each -> each.leastSize().isEmpty()));
  }
}
