package simbad.sonar.change;

import java.util.List;
import java.util.Optional;
import simbad.sonar.check.Checks;
import simbad.sonar.ping.Geometry;
import simbad.sonar.ping.ObstacleChange;
import simbad.sonar.ping.ThresholdChange;

/**
 * The threshold is off by a factor that varies smoothly with the bearing in the obstacle's frame: 1
 * + c + the sum of a_k cos(k b) + b_k sin(k b), never below 0.
 *
 * @param only label of the one obstacle whose threshold it is; empty for all
 * @param series c, a_1, b_1, a_2, b_2, ...; all 0 is neutral
 */
public record BearingFactor(Optional<String> only, List<Double> series)
    implements ThresholdChange, ObstacleChange {
  /** Copies the series and checks that its waves are whole. */
  public BearingFactor {
    series = List.copyOf(series);
    series.forEach(value -> Checks.finite("series", value));
    if (series.size() % 2 == 0) {
      throw new IllegalArgumentException(
          "series has " + series.size() + " values; a constant and pairs take an odd number");
    }
  }

  @Override
  public double factor(Geometry geometry, int line) {
    if (only.isPresent() && !only.get().equals(geometry.label(line))) {
      return 1;
    }
    double cos = geometry.bearingCos(line);
    double sin = geometry.bearingSin(line);
    double factor = 1 + series.get(0);
    double waveCos = 1;
    double waveSin = 0;
    for (int i = 1; i < series.size(); i += 2) {
      // The addition theorem, from k - 1 to k.
      double next = waveCos * cos - waveSin * sin;
      waveSin = waveSin * cos + waveCos * sin;
      waveCos = next;
      factor += series.get(i) * waveCos + series.get(i + 1) * waveSin;
    }
    return Math.max(0, factor);
  }
}
