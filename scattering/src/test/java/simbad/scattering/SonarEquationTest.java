package simbad.scattering;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.junit.jupiter.api.Test;
import simbad.sonar.level.Air;

class SonarEquationTest {
  private static final Receiver PLAIN = new Receiver(10, 0, 0.001);

  private static double balance(double r, double targetDb, Air air) {
    return 10 + targetDb - 30 * Math.log10(r) - 2 * air.absorptionDbPerM(40_000) * r;
  }

  /** Without desensitisation the threshold is where the levels balance. */
  @Property(seed = "11")
  void threshold_isTheBalance(@ForAll @DoubleRange(min = -30, max = 8) double targetDb) {
    double r = SonarEquation.of(PLAIN, Air.ROOM, Cases.SRF04).thresholdM(targetDb);
    // Straight between steps of 1 mm, where the true curve bends by less than 1e-3 dB at 3 cm.
    assertEquals(0, balance(r, targetDb, Air.ROOM), r > 0.1 ? 2e-4 : 2e-3);
  }

  @Test
  void threshold_staysBetweenBlankingAndTimeOut() {
    SonarEquation equation = SonarEquation.of(PLAIN, Air.ROOM, new RangeLimits(0.1, 4));
    assertEquals(4, equation.thresholdM(100), 1e-9);
    assertEquals(0, equation.thresholdM(-100));
  }

  /** Dry cold air takes less: the same target is heard further away. */
  @Test
  void absorption_shortensThresholds() {
    double room = SonarEquation.of(PLAIN, Air.ROOM, Cases.SRF04).thresholdM(5);
    double dry = SonarEquation.of(PLAIN, new Air(0, 10), Cases.SRF04).thresholdM(5);
    assertTrue(dry > 1.1 * room, dry + " over " + room);
  }

  /**
   * A weak target is lost near by, where the comparator is still deaf, although it could be heard
   * again further out: the bench notes the first loss. A strong one is not touched.
   */
  @Test
  void desensitisation_cutsWeakTargetsShort() {
    SonarEquation deaf = SonarEquation.of(new Receiver(10, 100, 0.0015), Air.ROOM, Cases.SRF04);
    SonarEquation plain = SonarEquation.of(PLAIN, Air.ROOM, Cases.SRF04);
    assertTrue(plain.thresholdM(-6) > 0.8);
    assertTrue(deaf.thresholdM(-6) < 0.2);
    assertEquals(plain.thresholdM(12), deaf.thresholdM(12), 0.01);
  }

  @Test
  void impossibleFigures_areRefused() {
    assertThrows(IllegalArgumentException.class, () -> new RangeLimits(0, 4));
    assertThrows(IllegalArgumentException.class, () -> new RangeLimits(0.1, Double.NaN));
    assertThrows(IllegalArgumentException.class, () -> new Receiver(Double.NaN, 1, 1));
    assertThrows(IllegalArgumentException.class, () -> new Receiver(0, -1, 1));
    assertThrows(IllegalArgumentException.class, () -> new Receiver(0, 1, 0));
    assertThrows(IllegalArgumentException.class, () -> new FittedReceiver(PLAIN, Double.NaN));
  }
}
