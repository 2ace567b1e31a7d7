package simbad.gap.explain;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import simbad.gap.fit.Evidence;
import simbad.gap.fit.Hypothesis;
import simbad.sonar.effect.Geometry;
import simbad.sonar.effect.PingLog;
import simbad.sonar.scene.SonarSpec;

/**
 * How far readings of one placement hang together, by an analysis of variance: where a tape put the
 * target a little off, all of them are off. Medians and median deviations throughout, so that
 * readings that are no echo of the target tell nothing.
 */
final class PlacementScatter {
  /** Of a normal distribution: its standard deviation over its median absolute deviation. */
  private static final double NORMAL = 1.4826;

  /** Of a median of normal readings: its variance over that of their mean. */
  private static final double MEDIAN_VARIANCE = Math.PI / 2;

  /** Distances that differ by less than this share of the whole span give no slope. */
  private static final double APART = 0.1;

  /** Scatter within placements is more than believed from so many times on. */
  private static final double MORE = 1.2;

  private final List<double[]> placed = new ArrayList<>();
  private double rows;
  private double squares;
  private double believedM;
  private double withinM;

  private PlacementScatter() {}

  /**
   * Returns by how much more sums over readings vary than those of independent ones: 1 + (n - 1) r,
   * with n readings to a placement and r the share of the variance that is between placements (Kish
   * 1965, the design effect). 1 where nothing was put in place repeatedly.
   */
  static double clumping(Evidence evidence, Placements placements) {
    if (!placements.areRepeated()) {
      return 1;
    }
    PlacementScatter scatter = new PlacementScatter();
    scatter.read(evidence, placements);
    return scatter.placed.size() < 3 ? 1 : scatter.designEffect();
  }

  /** Tells whether readings of one placement scatter more than the sensor is believed to. */
  static boolean isNoisier(Evidence evidence, Placements placements) {
    PlacementScatter scatter = new PlacementScatter();
    scatter.read(evidence, placements);
    double free = scatter.rows - scatter.placed.size();
    return free > 0 && Math.sqrt(scatter.squares / free) > MORE * scatter.believedM;
  }

  private void read(Evidence evidence, Placements placements) {
    PingLog log = evidence.log();
    Geometry geometry = evidence.geometry(evidence.model(Hypothesis.NONE));
    List<double[]> within = new ArrayList<>();
    for (int placement = 0; placement < placements.count(); placement++) {
      int own = placement;
      int[] heard =
          IntStream.range(0, log.size())
              .filter(i -> placements.of(i) == own && log.echo(i))
              .filter(i -> Double.isFinite(nearestM(geometry, i)))
              .toArray();
      if (heard.length > 1) {
        double[] ranges = Arrays.stream(heard).mapToDouble(log::rangeM).toArray();
        double middle = median(ranges);
        placed.add(new double[] {nearestM(geometry, heard[0]), middle, heard.length});
        squares += Arrays.stream(ranges).map(r -> (r - middle) * (r - middle)).sum();
        within.add(Arrays.stream(ranges).map(range -> Math.abs(range - middle)).toArray());
        rows += heard.length;
      }
    }
    SonarSpec sensor = evidence.setup().sensor();
    double step = sensor.resolutionM();
    believedM = Math.hypot(sensor.rangeNoiseM(), step / Math.sqrt(12));
    double seen = NORMAL * median(within.stream().flatMapToDouble(Arrays::stream).toArray());
    withinM = Math.max(believedM, seen);
  }

  private double designEffect() {
    double slope = median(slopes());
    double[] off = placed.stream().mapToDouble(one -> one[1] - slope * one[0]).toArray();
    double middle = median(off);
    double betweenM =
        NORMAL * median(Arrays.stream(off).map(value -> Math.abs(value - middle)).toArray());
    double each = rows / placed.size();
    double between = Math.max(0, betweenM * betweenM - MEDIAN_VARIANCE * withinM * withinM / each);
    double all = between + withinM * withinM;
    return all > 0 ? 1 + (each - 1) * between / all : 1;
  }

  /** Of all pairs of placements that are far enough apart (Theil 1950, Sen 1968). */
  private double[] slopes() {
    double least = placed.stream().mapToDouble(one -> one[0]).min().orElse(0);
    double most = placed.stream().mapToDouble(one -> one[0]).max().orElse(0);
    DoubleStream.Builder slopes = DoubleStream.builder();
    for (int i = 0; i < placed.size(); i++) {
      for (int j = 0; j < i; j++) {
        double way = placed.get(i)[0] - placed.get(j)[0];
        if (Math.abs(way) > APART * (most - least)) {
          slopes.add((placed.get(i)[1] - placed.get(j)[1]) / way);
        }
      }
    }
    double[] all = slopes.build().toArray();
    return all.length == 0 ? new double[] {1} : all;
  }

  private static double nearestM(Geometry geometry, int ping) {
    int first = ping * geometry.obstacles();
    return IntStream.range(first, first + geometry.obstacles())
        .mapToDouble(geometry::nearestM)
        .min()
        .orElse(Double.POSITIVE_INFINITY);
  }

  private static double median(double... values) {
    double[] sorted = Arrays.stream(values).sorted().toArray();
    int half = sorted.length / 2;
    if (sorted.length == 0) {
      return 0;
    }
    return sorted.length % 2 == 1 ? sorted[half] : (sorted[half - 1] + sorted[half]) / 2;
  }
}
