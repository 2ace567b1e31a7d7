package simbad.sonar.level;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simbad.sonar.fixture.Refusal;

class LevelLawTest {
  private static final Curve NO_THRESHOLD = Curve.constant(0);

  private static LevelLaw law(double exponent, double absorption, Curve receiver) {
    return new LevelLaw(
        40,
        exponent,
        absorption,
        Beam.everywhere(),
        receiver,
        1,
        Curve.constant(0),
        Curve.constant(0.004),
        0.034);
  }

  /** By hand: twice as far is 6, 9, 12 dB less for a wall, a post, a small target. */
  @ParameterizedTest
  @CsvSource({"1, 6.0206", "1.5, 9.0309", "2, 12.0412"})
  void spreading_byHand(double exponent, double perDoublingDb) {
    LevelLaw law = law(exponent, 0, NO_THRESHOLD);
    assertEquals(40 - 7, law.excessDb(-7, 0, 1), 1e-9);
    assertEquals(40 - 7 - perDoublingDb, law.excessDb(-7, 0, 2), 1e-4);
    assertEquals(40 - 7 - 2 * perDoublingDb, law.excessDb(-7, 0, 4), 1e-4);
    assertEquals(40 - 7 + perDoublingDb, law.excessDb(-7, 0, 0.5), 1e-4);
  }

  /** By hand: 1.3 dB per metre, out and back, are 2.6 dB at 1 m and 7.8 dB at 3 m. */
  @ParameterizedTest
  @CsvSource({"1, 2.6", "2, 5.2", "3, 7.8"})
  void absorption_byHand(double distanceM, double lostDb) {
    assertEquals(lostDb, law(0, 1.3, NO_THRESHOLD).lossDb(distanceM), 1e-9);
  }

  /** By hand: 20 dB at the sensor, falling by 1 dB in 10 cm to 0 at 2 m. */
  @ParameterizedTest
  @CsvSource({"0.5, 15", "1.99, 0.1", "2, 0", "5, 0"})
  void receiver_byHand(double distanceM, double thresholdDb) {
    assertEquals(thresholdDb, law(0, 0, Curve.of(0, 20, 2, 0)).lossDb(distanceM), 1e-9);
  }

  /** All terms together: 40 - 12 - 4 - 20 * 1.5 log10(2) - 2 * 1.3 * 2 - 3. */
  @Test
  void excess_isTheSumOfItsTerms() {
    LevelLaw law =
        law(1.5, 1.3, Curve.of(0, 5, 4, 1)).withBeam(new CurveBeam(Curve.of(0, 0, 10, -8)));
    double expected = 40 - 12 - 4 - 30 * Math.log10(2) - 5.2 - 3;
    assertEquals(expected, law.excessDb(-12, Math.toRadians(5), 2), 1e-9);
  }

  /** What is nearer than a millimetre counts as a millimetre: nothing is endless. */
  @Test
  void loss_atTheCentre_isFinite() {
    LevelLaw law = law(1.5, 1.3, NO_THRESHOLD);
    assertEquals(-90, law.lossDb(0), 0.01);
    assertEquals(law.lossDb(0), law.lossDb(0.001));
  }

  /** Against a walk in steps of 0.1 mm, for receivers of any shape. */
  @Test
  void losses_anyReceiver_areFoundWhereAWalkFindsThem() {
    Random random = new Random(5);
    for (int i = 0; i < 200; i++) {
      LevelLaw law = law(random.nextDouble(0.5, 2), random.nextDouble(2), receiver(random));
      double strengthDb = random.nextDouble(-60, 0);
      double first = 0;
      double last = 0;
      double greatest = Double.NEGATIVE_INFINITY;
      boolean lost = false;
      for (double r = 0.001; r <= 3; r += 1e-4) {
        boolean heard = law.excessDb(strengthDb, 0, r) >= 0;
        lost |= !heard;
        first = lost ? first : r;
        last = heard ? r : last;
        greatest = Math.max(greatest, law.lossDb(r));
      }
      assertEquals(first, law.firstLossM(strengthDb, 3), 1.1e-4, "first, case " + i);
      assertEquals(last, law.reachM(strengthDb, 0, 3), 1.1e-4, "last, case " + i);
      assertEquals(greatest, law.greatestStrengthDb(3) + 40, 0.01, "greatest, case " + i);
    }
  }

  private static Curve receiver(Random random) {
    double[] points = new double[2 * random.nextInt(1, 8)];
    double x = 0;
    for (int i = 0; i < points.length; i += 2) {
      x += random.nextDouble(0.01, 1);
      points[i] = x;
      points[i + 1] = random.nextDouble(0, 40);
    }
    return Curve.of(points);
  }

  /** The cells that a sensor skims by are nowhere below what is really left. */
  @Test
  void greatestLeft_isABound() {
    Random random = new Random(6);
    for (int i = 0; i < 50; i++) {
      LevelLaw law = law(1.5, 1, receiver(random));
      double[] left = law.greatestLeft(0.05, 60);
      for (double r = 0.001; r < 3; r += 0.003) {
        double here = Decibels.energy(-law.lossDb(r));
        assertTrue(left[(int) (r / 0.05)] >= here * (1 - 1e-12), "case " + i + " at " + r);
      }
    }
  }

  /** Weaker by 3 dB, and everything else as it was; likewise the other changes. */
  @Test
  void changes_changeTheirTermOnly() {
    LevelLaw law = law(1.5, 1.3, Curve.of(0, 5, 4, 1));
    double before = law.excessDb(-12, 0.1, 2);
    assertEquals(before - 3, law.withLevelDb(37).excessDb(-12, 0.1, 2), 1e-9);
    assertEquals(before - 0.8, law.withAbsorptionDbPerM(1.5).excessDb(-12, 0.1, 2), 1e-9);
    assertEquals(
        before - 9, law.withReceiverThresholdDb(Curve.constant(12)).excessDb(-12, 0.1, 2), 1e-9);
    Beam narrow = new CurveBeam(Curve.constant(-6));
    assertEquals(before - 6, law.withBeam(narrow).excessDb(-12, 0.1, 2), 1e-9);
    assertEquals(law, law.withLevelDb(37).withLevelDb(40));
  }

  /** A table before the default law says one distance for each strength, as a bench needs it. */
  @Test
  void defaults_loseEveryTargetOnceAndForAll() {
    LevelLaw law = LevelFigures.NONE.law(0.48, 0.004);
    double before = Double.NEGATIVE_INFINITY;
    for (double r = 0.001; r < 8; r += 0.001) {
      double loss = law.lossDb(r);
      assertTrue(loss > before, "loss at " + r);
      before = loss;
    }
  }

  @Test
  void impossibleFigures_areRefused() {
    Refusal.check(() -> law(-1, 0, NO_THRESHOLD), "spreadingExponent = -1.0");
    Refusal.check(() -> law(1, Double.NaN, NO_THRESHOLD), "absorptionDbPerM = NaN");
    Refusal.check(
        () -> law(1, 1, NO_THRESHOLD).withLevelDb(Double.NaN), "levelDb = NaN is not finite");
    LevelLaw law = law(1, 1, NO_THRESHOLD);
    Refusal.check(
        () ->
            new LevelLaw(
                0, 1, 1, law.beam(), NO_THRESHOLD, -1, NO_THRESHOLD, Curve.constant(-0.001), 0),
        "excessSdDb = -1.0");
    Refusal.check(
        () ->
            new LevelLaw(
                0, 1, 1, law.beam(), NO_THRESHOLD, 1, NO_THRESHOLD, Curve.constant(-0.1), 0),
        "noiseM = -0.1");
  }
}
