package simbad.gap.calibrate.level;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;
import simbad.gap.fixture.LevelWorlds;
import simbad.sonar.catalogue.LevelForms;
import simbad.sonar.level.Curve;
import simbad.sonar.level.LevelLaw;

/** What distance takes from an echo, beside the formula of the law. */
class LossTest {
  private static final double EXACT = 1e-9;

  /** A receiver that is deafer by 3 dB for each metre. */
  private static final LevelLaw LAW =
      LevelWorlds.POST.sensor().levelLaw().withReceiverThresholdDb(Curve.of(0, 1, 10, 31));

  private static final double[] NONE = new double[Loss.SIZE];

  /** 20 dB for each tenfold, absorption there and back. */
  @Test
  void weightsAreThoseOfSpreadingAndAbsorption() {
    Loss far = Loss.at(10, LAW);

    assertEquals(20, far.weights()[0], EXACT);
    assertEquals(20, far.weights()[1], EXACT);
    assertEquals(31, far.offsetDb(), EXACT);
    assertEquals(0, Loss.at(1, LAW).weights()[0], EXACT);
    assertEquals(2, Loss.at(1, LAW).weights()[1], EXACT);
  }

  @Test
  void theReceiverDepartsBetweenItsDistances() {
    int at = LevelForms.RECEIVER_M.indexOf(0.4);

    assertEquals(1, Loss.at(0.4, LAW).weights()[2 + at], EXACT);
    assertEquals(0, Loss.at(0.4, LAW).weights()[3 + at], EXACT);
    // Half way by the logarithm.
    Loss between = Loss.at(Math.sqrt(0.4 * 0.6), LAW);
    assertEquals(0.5, between.weights()[2 + at], EXACT);
    assertEquals(0.5, between.weights()[3 + at], EXACT);
  }

  @Test
  void theValuesOfALawGiveItsLoss() {
    for (double distance : new double[] {0.0001, 0.3, 1, 2.7, 6}) {
      assertEquals(LAW.lossDb(distance), Loss.at(distance, LAW).decibels(Loss.values(LAW)), EXACT);
    }
  }

  /** Nearer than a millimetre is a millimetre: 60 dB less than at a metre. */
  @Test
  void nothingIsNearerThanAMillimetre() {
    assertEquals(-60, Loss.at(0, LAW).weights()[0], EXACT);
    assertEquals(0.002, Loss.at(1e-5, LAW).weights()[1], EXACT);
  }

  @Test
  void aConstantDependsOnNoValue() {
    double[] values = Loss.values(LAW);

    assertEquals(5, Loss.constant(5).decibels(values), EXACT);
    assertEquals(7, Loss.constant(5).plus(2).decibels(values), EXACT);
    assertEquals(2, Loss.constant(5).minus(Loss.constant(3)).decibels(NONE), EXACT);
  }

  /** From 2 m to 1 m: 20 log10(2), 2 m there and back, 3 dB of the receiver. */
  @Test
  void aDifferenceIsThatOfWeightsAndOffsets() {
    Loss apart = Loss.at(2, LAW).minus(Loss.at(1, LAW));

    assertEquals(20 * Math.log10(2), apart.weights()[0], EXACT);
    assertEquals(2, apart.weights()[1], EXACT);
    assertEquals(3, apart.offsetDb(), EXACT);
  }

  @Test
  void betweenTwoIsTheirShare() {
    Loss between = Loss.at(1, LAW).towards(Loss.at(10, LAW), 0.25);

    assertEquals(5, between.weights()[0], EXACT);
    assertEquals(2 + 0.25 * 18, between.weights()[1], EXACT);
    assertEquals(4 + 0.25 * 27, between.offsetDb(), EXACT);
  }

  /** (1 + 2 + 6) / 3, and each distance counts alike. */
  @Test
  void theMeanCountsEachAlike() {
    Loss mean = Loss.mean(List.of(Loss.constant(1), Loss.constant(2), Loss.constant(6)));

    assertEquals(3, mean.decibels(NONE), EXACT);
    Loss ofDistances = Loss.mean(List.of(Loss.at(1, LAW), Loss.at(2, LAW), Loss.at(6, LAW)));
    assertEquals(2 * 3, ofDistances.weights()[1], EXACT);
    assertEquals(4, Loss.mean(List.of(Loss.constant(4))).offsetDb(), EXACT);
  }
}
