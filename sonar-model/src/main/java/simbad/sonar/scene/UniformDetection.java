package simbad.sonar.scene;

import java.util.Optional;
import simbad.sonar.shape.ThresholdTable;

/**
 * One threshold all round.
 *
 * @param rangeM distance from the centre in metres, in [0, 100] as in a table
 */
public record UniformDetection(double rangeM) implements Detection {
  /** Checks the range. */
  public UniformDetection {
    if (!ThresholdTable.isThreshold(rangeM)) {
      throw new IllegalArgumentException(
          "rangeM = " + rangeM + " is not in [0, " + ThresholdTable.GREATEST_THRESHOLD_M + "] m");
    }
  }

  @Override
  public double thresholdM(double bearingRad) {
    return rangeM;
  }

  @Override
  public double greatestM() {
    return rangeM;
  }

  @Override
  public Optional<ThresholdTable> findTable() {
    return Optional.empty();
  }
}
