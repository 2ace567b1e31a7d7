package simbad.sonar.effect;

import static org.junit.jupiter.api.Assertions.assertDoesNotThrow;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.Scale;
import org.junit.jupiter.api.Test;
import simbad.definition.Parameter;
import simbad.sonar.frame.Placement;
import simbad.sonar.frame.Point;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.scene.UniformDetection;
import simbad.sonar.shape.Outline;

class ParameterTest {
  @Test
  void endsOfTheSearch_areBounds_theNeutralEndIsNot() {
    Parameter gain = Parameter.of("factor", 1, 0.2, 3, 0.7);
    assertTrue(gain.isAtBound(0.2));
    assertTrue(gain.isAtBound(0.2 + 0.001 * 2.8), "as near as makes no difference");
    assertFalse(gain.isAtBound(0.21));
    assertTrue(gain.isAtBound(3));
    Parameter loss = Parameter.of("loss_per_m", 0, 0, 1.5, 0.1);
    assertFalse(loss.isAtBound(0), "neutral");
    assertTrue(loss.isAtBound(1.5));
  }

  @Test
  void whatIsAsGoodAsAnInfiniteNeutralValue_isNoBound() {
    Parameter start = Parameter.of("start_m", Double.POSITIVE_INFINITY, 0.1, 4, 2);
    assertFalse(start.isAtBound(4));
    assertTrue(start.isAtBound(0.1));
  }

  @Test
  void overManyDecades_aThousandthIsFarFromTheLowEnd() {
    Parameter settling = Parameter.of("settling_s", Double.POSITIVE_INFINITY, 2, 1e4, 60);
    assertTrue(settling.isAtBound(2.05));
    assertFalse(settling.isAtBound(5.6));
  }

  @Test
  void closedEnds_areNoBounds() {
    Parameter share = Parameter.of("share", 0, 0, 1, 0.2).asClosed();
    assertFalse(share.isAtBound(1), "all pings: nothing lies beyond");
    assertEquals(0.7, share.clamp(0.7));
  }

  @Test
  void triesThatDependOnTheSensor_areMovedIntoTheInterval() {
    assertEquals(List.of(0.5, 2.0), Parameter.of("a", 0, 0, 2, 0.5, 3, 4).tries());
  }

  @Test
  void intervalOfNothing_isRefused() {
    assertThrows(
        IllegalArgumentException.class, () -> new Parameter("a", 0, 1, 1, List.of(), false));
    assertThrows(
        IllegalArgumentException.class, () -> new Parameter("a", 0, 0, 1, List.of(2.0), false));
  }

  /** Any sensor that a file may hold: slow ones, short ones, ones that hear all round. */
  @Property(tries = 300)
  void everySensorHasAllForms(
      @ForAll @DoubleRange(min = 0.01, max = 3.14) double half,
      @ForAll @Scale(4) @DoubleRange(min = 1e-3, max = 200) double mostM,
      @ForAll @Scale(4) @DoubleRange(min = 1e-3, max = 1e5) double sound,
      @ForAll @Scale(4) @DoubleRange(min = 1e-4, max = 1e6) double periodS,
      @ForAll @DoubleRange(min = 0, max = 50) double thresholdM) {
    SonarSpec sensor = new SonarSpec("s", half, 0, mostM, 0, sound, 0.01, 0, 0, 0, periodS);
    Outline outline = Outline.of(List.of(new Point(0, 0), new Point(0.1, 0), new Point(0, 0.1)));
    Obstacle one =
        new Obstacle("one", new Placement(0, 0, 0), outline, new UniformDetection(thresholdM));
    Obstacle two =
        new Obstacle("two", new Placement(1, 0, 0), outline, new UniformDetection(thresholdM));
    SensingSetup setup = new SensingSetup(sensor, new Scene(List.of(one, two)), mostM);
    List<Form> forms = assertDoesNotThrow(() -> Forms.all(setup, List.of("left", "right")));
    assertEquals(Definitions.effects().size(), forms.stream().map(Form::effect).distinct().count());
  }
}
