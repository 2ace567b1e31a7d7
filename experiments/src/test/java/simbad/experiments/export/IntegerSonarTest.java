package simbad.experiments.export;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.obstacles.Catalogue;
import simbad.obstacles.ObstacleType;
import simbad.sonar.scene.SonarSpec;

/** The rule in whole numbers beside the one implementation of the rule. */
class IntegerSonarTest {
  private static final SonarSpec SRF04 = Catalogue.srf04();

  private static IntegerSonar sonar(ObstacleType type) {
    return new SonarHeader(type, SRF04, "post").inIntegers();
  }

  private static ObstacleType type(String name) {
    return Catalogue.find(name).orElseThrow();
  }

  /** Rounding moves an edge by a millimetre at most: few poses of the map lie so near to one. */
  @ParameterizedTest
  @ValueSource(strings = {"angle", "square", "round"})
  void readsWhatTheRuleReads(String name) {
    ObstacleType type = type(name);
    IntegerSonar sonar = sonar(type);
    RuleInMetres rule = new RuleInMetres(type, SRF04);
    int differ = 0;
    int echoes = 0;
    for (int[] pose : HeaderPoses.all(2.9, 7)) {
      int read = sonar.readMm(pose[0], pose[1], pose[2]);
      double expected = rule.readM(pose);
      if (expected >= 0 && read >= 0) {
        echoes++;
        assertEquals(1000 * expected, read, 2, Arrays.toString(pose));
      } else if (expected >= 0 || read >= 0) {
        differ++;
      }
    }
    assertTrue(echoes > 300, "echoes " + echoes);
    assertTrue(differ <= 0.001 * echoes + 6, differ + " of " + echoes + " differ");
  }

  @Test
  void beyondItsPlacesNothingIsHeard() {
    IntegerSonar sonar = sonar(type("round"));

    assertEquals(IntegerSonar.NO_ECHO, sonar.readMm(0, 8192, 9000));
    assertEquals(IntegerSonar.NO_ECHO, sonar.readMm(Short.MAX_VALUE, 0, 18_000));
  }

  /** On the axis of a post of one inch, 1 m off, the surface is half an inch nearer. */
  @Test
  void readsTheDistanceToTheSurface() {
    assertEquals(987, sonar(type("round")).readMm(0, 1000, 9000), 1);
    assertEquals(IntegerSonar.NO_ECHO, sonar(type("round")).readMm(0, 1000, -9000));
  }

  @Test
  void whatNoHeaderHoldsIsRefusedByName() {
    SonarSpec wide = SRF04.withCone(Math.toRadians(95));
    SonarSpec far = SRF04.withRange(0.03, 9);
    ObstacleType round = type("round");

    assertTrue(refusal(round, wide).contains("cone_half_angle_deg = 95"));
    assertTrue(refusal(round, far).contains("max_range_m = 9.0, expected at most 8.191"));
    assertThrows(IllegalArgumentException.class, () -> new SonarHeader(round, SRF04, "2nd"));
    assertThrows(IllegalArgumentException.class, () -> new SonarHeader(round, SRF04, "a-b"));
  }

  private static String refusal(ObstacleType type, SonarSpec sensor) {
    return String.valueOf(
        assertThrows(IllegalArgumentException.class, () -> new SonarHeader(type, sensor, "post"))
            .getMessage());
  }
}
