package simbad.scattering;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import simbad.sonar.level.Air;
import simbad.sonar.shape.ThresholdTable;

class FittedReceiverTest {
  /**
   * The reach of the model: fitted to what the thesis says in words of the round and the square
   * tube, it predicts the angle's 72 measured thresholds, of which it has seen none.
   */
  @Test
  void angle_leftOut_isPredicted() {
    FittedReceiver calibration =
        FittedReceiver.fit(Cases.thesis().inWords(), Air.ROOM, Cases.SRF04);
    assertEquals(FittedReceiver.WITHOUT_ANGLE.receiver(), calibration.receiver());
    ThresholdTable predicted = Cases.predicted(Cases.angle(), calibration).table();
    double correlation = logCorrelation(predicted.valuesM(), Cases.angleTable().valuesM());
    double error = medianRatioError(predicted.valuesM(), Cases.angleTable().valuesM());
    String found = calibration + ": correlation " + correlation + ", median ratio error " + error;
    assertTrue(correlation >= 0.85, found);
    assertTrue(error <= 0.30, found);
  }

  @Test
  void shippedCalibration_isTheFitToAllThatIsKnown() {
    List<KnownThresholds> known = Cases.thesis().with(Cases.angle(), Cases.angleTable());
    assertEquals(FittedReceiver.SRF04, FittedReceiver.fit(known, Air.ROOM, Cases.SRF04));
  }

  @Test
  void fit_ofNothing_isRefused() {
    assertThrows(
        IllegalArgumentException.class, () -> FittedReceiver.fit(List.of(), Air.ROOM, Cases.SRF04));
  }

  static double logCorrelation(double[] a, double[] b) {
    double meanA = Arrays.stream(a).map(Math::log).average().orElseThrow();
    double meanB = Arrays.stream(b).map(Math::log).average().orElseThrow();
    double aa = 0;
    double bb = 0;
    double ab = 0;
    for (int i = 0; i < a.length; i++) {
      double da = Math.log(a[i]) - meanA;
      double db = Math.log(b[i]) - meanB;
      aa += da * da;
      bb += db * db;
      ab += da * db;
    }
    return ab / Math.sqrt(aa * bb);
  }

  /** Median of max(a/b, b/a) - 1. */
  static double medianRatioError(double[] a, double[] b) {
    double[] sorted =
        IntStream.range(0, a.length)
            .mapToDouble(i -> Math.max(a[i] / b[i], b[i] / a[i]) - 1)
            .sorted()
            .toArray();
    return (sorted[(sorted.length - 1) / 2] + sorted[sorted.length / 2]) / 2;
  }
}
