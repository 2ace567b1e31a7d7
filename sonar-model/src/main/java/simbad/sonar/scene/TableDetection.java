package simbad.sonar.scene;

import java.util.Optional;
import simbad.sonar.shape.ThresholdTable;

/**
 * Thresholds that depend on the bearing.
 *
 * @param table by bearing
 */
public record TableDetection(ThresholdTable table) implements Detection {
  @Override
  public double thresholdM(double bearingRad) {
    return table.thresholdM(bearingRad);
  }

  @Override
  public double greatestM() {
    return table.greatestM();
  }

  @Override
  public Optional<ThresholdTable> findTable() {
    return Optional.of(table);
  }
}
