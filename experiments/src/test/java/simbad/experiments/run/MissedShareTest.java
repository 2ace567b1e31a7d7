package simbad.experiments.run;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;
import simbad.sonar.shape.DetectionShadow;
import simbad.sonar.shape.ThresholdTable;

class MissedShareTest {
  /** Four places at (+-0.5, +-0.5) m, 0.71 m from the centre. */
  private static final DetectionMap MAP =
      new DetectionMap(new ShareGrid(2, 1, List.of(1.0, 0.25, 0.0, 0.5)), 0.5625);

  private static DetectionShadow circle(double radiusM) {
    return new DetectionShadow(ThresholdTable.uniform(72, radiusM));
  }

  @Test
  void missedShare_isTheMeanOverPlacesInTheShadow() {
    assertEquals(0.4375, MAP.missedShare(circle(1)), 1e-12);
  }

  @Test
  void missedShare_withoutAPlaceInTheShadow_isZero() {
    assertEquals(0, MAP.missedShare(circle(0.5)));
  }
}
