package simbad.gap.diagnosis;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import simbad.motion.forecast.PinballLoss;
import simbad.sonar.model.Part;
import simbad.sonar.model.ReadingDistribution;
import simbad.sonar.model.Report;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.NoEcho;

class ForecastGapTest {
  private static ReadingDistribution of(Part... parts) {
    return new ReadingDistribution(List.of(parts), 0, Report.AS_MEASURED);
  }

  @Test
  void levels_areTwentieths() {
    assertEquals(0.05, PinballLoss.level(0));
    assertEquals(0.15, PinballLoss.level(2));
    assertEquals(0.95, PinballLoss.level(18));
  }

  /** What is certain and comes has no gap; what comes 1 m beside it has one of 1 m: 2 x 0.5 x 1. */
  @Test
  void certainty_hasTheGapOfItsDistance() {
    double[] at2 = ForecastGap.quantilesM(of(new Part(2, 0, 0, 1)), 4);
    assertEquals(0, ForecastGap.gapM(at2, new Echo(2), 4), 1e-12);
    assertEquals(1, ForecastGap.gapM(at2, new Echo(3), 4), 1e-12);
    assertEquals(1, ForecastGap.gapM(at2, new Echo(1), 4), 1e-12);
    assertEquals(2, ForecastGap.gapM(at2, NoEcho.NO_ECHO, 4), 1e-12);
  }

  /** An echo at 1 m with probability 0.3: quantiles up to 0.30 lie there, the others at no-echo. */
  @Test
  void chance_isSpreadOverTheQuantiles() {
    double[] quantiles = ForecastGap.quantilesM(of(new Part(1, 0, 0, 0.3)), 4);
    assertEquals(6, Arrays.stream(quantiles).filter(q -> Math.abs(q - 1) < 1e-9).count());
    assertEquals(13, Arrays.stream(quantiles).filter(q -> q == 4).count());
    double missed = 2 * 3 * (0.05 + 0.10 + 0.15 + 0.20 + 0.25 + 0.30) / 19;
    assertEquals(missed, ForecastGap.gapM(quantiles, NoEcho.NO_ECHO, 4), 1e-9);
  }

  @Test
  void quantilesRise() {
    double[] quantiles =
        ForecastGap.quantilesM(of(new Part(1, 0.1, 0, 0.5), new Part(3, 1, 0, 0.3)), 4);
    double[] sorted = quantiles.clone();
    Arrays.sort(sorted);
    assertArrayEquals(sorted, quantiles);
  }
}
