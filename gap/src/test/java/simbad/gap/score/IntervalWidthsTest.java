package simbad.gap.score;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.Objects;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.sonar.scene.SensorLaw;

class IntervalWidthsTest {
  @Test
  void eachLawHasItsOwn() {
    IntervalWidths widths = new IntervalWidths(1.25, 1.5, 2);
    assertEquals(1.25, widths.under(SensorLaw.Model.THRESHOLD), 0);
    assertEquals(1.5, widths.under(SensorLaw.Model.LEVEL), 0);
    assertThrows(IllegalArgumentException.class, () -> new IntervalWidths(0, 1, 1));
    assertThrows(IllegalArgumentException.class, () -> new IntervalWidths(1, Double.NaN, 1));
    assertThrows(IllegalArgumentException.class, () -> new IntervalWidths(1, 1, -1));
  }

  /**
   * Whatever is fitted: a likelihood never says too much scatter of a model that is right. Under
   * the level law the model itself is off: its decibels and its walk are those of one reference
   * log.
   */
  @Test
  void fittedOnes_areWider_byLittleButUnderTheLevelLaw() {
    IntervalWidths own = IntervalWidths.own();
    for (double each : new double[] {own.threshold(), own.motion()}) {
      assertTrue(each >= 1 && each < 4, own::toString);
    }
    assertTrue(own.level() >= 1 && own.level() < 10, own::toString);
  }

  @ParameterizedTest
  @ValueSource(strings = {"format", "threshold", "level", "motion"})
  void aFieldThatIsMissing_isNamed(String field) {
    ObjectNode root = new ObjectMapper().createObjectNode();
    root.put("format", IntervalWidths.FORMAT);
    root.put("threshold", 1.25).put("level", 1.5).put("motion", 2);
    assertEquals(new IntervalWidths(1.25, 1.5, 2), IntervalWidths.of(root));
    root.remove(field);
    String message =
        Objects.toString(
            assertThrows(IllegalArgumentException.class, () -> IntervalWidths.of(root))
                .getMessage());
    assertTrue(message.startsWith(field + ":"), message);
  }
}
