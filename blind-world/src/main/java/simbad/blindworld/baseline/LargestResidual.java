package simbad.blindworld.baseline;

import java.util.Comparator;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import simbad.blindworld.world.Forecast;
import simbad.blindworld.world.Recording;
import simbad.blindworld.world.Scene;
import simbad.blindworld.world.Setup;
import simbad.blindworld.world.World;

/**
 * The rule that a serious diagnosis has to beat: when the gap from the nominal forecast is beyond
 * what nominal readings themselves show, the largest sort of residual names one effect.
 */
final class LargestResidual {

  private static final int REPEATS = 100;
  private static final int NULLS = 20;
  private static final double LIMIT = 4;
  private static final long SEED = 5;

  private final Scene scene;

  LargestResidual(Scene scene) {
    this.scene = scene;
  }

  private enum Sort {
    MISSED,
    PHANTOM,
    RANGE
  }

  private World.Listening nominal(Recording recording) {
    return new World(scene, Setup.nominal(scene.sensor()), List.of()).at(recording);
  }

  /** What the scene lets expect of rows. */
  Forecast forecast(Recording recording) {
    return Forecast.of(nominal(recording), scene.noEchoM(), REPEATS, SEED);
  }

  /** The name of an effect, or nothing when the gap is within chance. */
  Optional<String> name(Recording recording, double[] readingsM) {
    Forecast forecast = forecast(recording);
    World.Listening nominal = nominal(recording);
    double sum = 0;
    double squares = 0;
    for (int i = 0; i < NULLS; i++) {
      double gap = forecast.gapCm(nominal.read(SEED + 1 + i), scene.noEchoM());
      sum += gap;
      squares += gap * gap;
    }
    double mean = sum / NULLS;
    double sd = Math.sqrt(Math.max(0, squares / NULLS - mean * mean));
    boolean beyond = forecast.gapCm(readingsM, scene.noEchoM()) > mean + LIMIT * sd + 0.02;
    return beyond ? Optional.of(largest(forecast, readingsM)) : Optional.empty();
  }

  private String largest(Forecast forecast, double[] readingsM) {
    Map<Sort, Double> losses = new EnumMap<>(Sort.class);
    Line line = new Line();
    for (int row = 0; row < readingsM.length; row++) {
      double median = forecast.row(row)[Forecast.LEVELS / 2];
      boolean expected = median < scene.noEchoM();
      boolean heard = readingsM[row] < Double.POSITIVE_INFINITY;
      Sort sort = expected == heard ? Sort.RANGE : expected ? Sort.MISSED : Sort.PHANTOM;
      double counted = heard ? readingsM[row] : scene.noEchoM();
      losses.merge(sort, forecast.lossCm(row, counted), Double::sum);
      if (expected && heard) {
        line.add(median, counted - median);
      }
    }
    Sort worst =
        losses.entrySet().stream()
            .max(Comparator.comparing(Map.Entry::getValue))
            .orElseThrow()
            .getKey();
    return switch (worst) {
      case MISSED -> "dropout";
      case PHANTOM -> "crosstalk";
      case RANGE -> line.name();
    };
  }

  /** Range residuals by distance, as sums. */
  private static final class Line {

    private int n;
    private double sumDd;
    private double sumR;
    private double sumDr;
    private double sumRr;

    void add(double d, double r) {
      n++;
      sumDd += d * d;
      sumR += r;
      sumDr += d * r;
      sumRr += r * r;
    }

    /** What leaves least: one shift, one factor, or neither. */
    String name() {
      double byShift = n == 0 ? 0 : sumR * sumR / n;
      double byFactor = sumDd == 0 ? 0 : sumDr * sumDr / sumDd;
      if (Math.max(byShift, byFactor) < 0.5 * sumRr) {
        return "range-noise";
      }
      return byShift > byFactor ? "range-offset" : "sound-speed";
    }
  }
}
