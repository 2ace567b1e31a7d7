package simbad.gap.score;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.stream.DoubleStream;
import simbad.gap.fit.CalibratedLog;
import simbad.gap.fit.Hypothesis;
import simbad.gap.fit.NearestRange;
import simbad.gap.fit.Placements;
import simbad.gap.fit.Robust;
import simbad.sonar.model.NominalModel;
import simbad.sonar.ping.Geometry;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.SetupDetails;
import simbad.sonar.scene.SonarSpec;

/**
 * How far readings of one placement hang together, by an analysis of variance: where a tape put the
 * target a little off, all of them are off. Medians and median deviations throughout, so that
 * readings that are no echo of the target tell nothing.
 */
public final class PlacementScatter {
  /** Of a median of normal readings: its variance over that of their mean. */
  private static final double MEDIAN_VARIANCE = Math.PI / 2;

  /** Distances that differ by less than this share of the whole span give no slope. */
  private static final double APART = 0.1;

  /** Scatter within placements is more than believed from so many times on. */
  private static final double MORE = 1.2;

  /** A standard normal variable is less in 99 of 100. */
  private static final double NORMAL_99 = 2.326;

  /** Variance of a standard deviation of normal values over that of their median deviation. */
  private static final double MAD_EFFICIENCY = 0.37;

  /** In deviations within placements: one normal reading in 16,000 is further from the middle. */
  private static final double MOST = 4;

  private final List<double[]> placed = new ArrayList<>();
  private double rows;
  private double squares;
  private int strays;
  private double believedM;
  private double withinM;

  private PlacementScatter() {}

  /**
   * Returns by how much more sums over readings vary than those of independent ones: 1 + (n - 1) r,
   * with n readings to a placement and r the share of the variance that is between placements (Kish
   * 1965, the design effect). 1 where nothing was put in place repeatedly.
   */
  public static double clumping(CalibratedLog given, Placements placements) {
    return clumping(given, placements, 0);
  }

  /**
   * Returns the same where placements scatter at least as much as the set-up says of its places and
   * headings: few of them may lie on a line by chance. A heading counts by how far the nearest
   * point in the cone comes nearer or goes away as the sensor turns: by nothing before a wide
   * board, by much where a corner leaves the cone.
   */
  public static double statedClumping(CalibratedLog given, Placements placements) {
    SetupDetails details = given.setup().details();
    double turned = details.headingSigmaRad() > 0 ? turnedM(given, placements) : 0;
    return clumping(given, placements, Math.hypot(details.poseSigmaM(), turned));
  }

  /** By how much ranges change if each placement's heading is off by its standard deviation. */
  private static double turnedM(CalibratedLog given, Placements placements) {
    PingLog log = given.log();
    double sigma = given.setup().details().headingSigmaRad();
    NominalModel model = new NominalModel(given.setup().sensor(), given.setup().scene());
    double squares = 0;
    int count = 0;
    for (int[] pings : placements.pings()) {
      double straight = NearestRange.turnedM(model, log, pings[0], 0);
      for (double way : new double[] {-sigma, sigma}) {
        double change = NearestRange.turnedM(model, log, pings[0], way) - straight;
        // What leaves the cone altogether is a missed echo, no other range.
        if (Double.isFinite(change)) {
          squares += change * change;
          count++;
        }
      }
    }
    return count == 0 ? 0 : Math.sqrt(squares / count);
  }

  private static double clumping(CalibratedLog given, Placements placements, double leastM) {
    if (!placements.areRepeated()) {
      return 1;
    }
    PlacementScatter scatter = new PlacementScatter();
    scatter.read(given, placements);
    return scatter.placed.size() < 3 ? 1 : scatter.designEffect(leastM);
  }

  /**
   * Returns by how much placements are off, standard deviation in metres: what scatters between
   * them beyond what readings of one do. 0 where nothing was put in place repeatedly.
   */
  public static double betweenM(CalibratedLog given, Placements placements) {
    if (!placements.areRepeated()) {
      return 0;
    }
    PlacementScatter scatter = new PlacementScatter();
    scatter.read(given, placements);
    return scatter.placed.size() < 3 ? 0 : Math.sqrt(scatter.between());
  }

  /**
   * Tells whether placements are off by more than the set-up says of its places; true where it says
   * that these are exact. Of as many placements as there are one log in a hundred seems to be by
   * chance.
   */
  public static boolean isFurtherOff(CalibratedLog given, Placements placements) {
    double stated = given.setup().details().poseSigmaM();
    double count = Math.max(1, placements.count());
    double most = stated * (1 + NORMAL_99 / Math.sqrt(2 * MAD_EFFICIENCY * count));
    return stated == 0 || betweenM(given, placements) > most;
  }

  /** Tells whether readings of one placement scatter more than the sensor is believed to. */
  public static boolean isNoisier(CalibratedLog given, Placements placements) {
    PlacementScatter scatter = new PlacementScatter();
    scatter.read(given, placements);
    double free = scatter.rows - scatter.strays - scatter.placed.size();
    return free > 0 && Math.sqrt(scatter.squares / free) > MORE * scatter.believedM;
  }

  private void read(CalibratedLog given, Placements placements) {
    PingLog log = given.log();
    Geometry geometry = given.geometry(given.model(Hypothesis.NONE));
    DoubleStream.Builder within = DoubleStream.builder();
    for (int[] pings : placements.pings()) {
      int[] heard =
          Arrays.stream(pings)
              .filter(i -> log.echo(i) && Double.isFinite(NearestRange.inConeM(geometry, i)))
              .toArray();
      if (heard.length > 1) {
        double[] ranges = Arrays.stream(heard).mapToDouble(log::rangeM).toArray();
        double middle = Robust.median(ranges);
        placed.add(new double[] {NearestRange.inConeM(geometry, heard[0]), middle});
        Arrays.stream(ranges).map(range -> Math.abs(range - middle)).forEach(within);
        rows += heard.length;
      }
    }
    SonarSpec sensor = given.setup().sensor();
    double step = sensor.resolutionM();
    believedM = Math.hypot(sensor.rangeNoiseM(), step / Math.sqrt(12));
    double[] deviations = within.build().toArray();
    withinM = Math.max(believedM, placed.isEmpty() ? 0 : scale(deviations));
    // What is further off is an echo of something else.
    double[] own = Arrays.stream(deviations).filter(one -> one <= MOST * withinM).toArray();
    strays = deviations.length - own.length;
    squares = Arrays.stream(own).map(one -> one * one).sum();
  }

  private static double scale(double... deviations) {
    return Robust.NORMAL_OVER_MAD * Robust.median(deviations);
  }

  private double designEffect(double leastM) {
    double each = rows / placed.size();
    double between = Math.max(leastM * leastM, between());
    double all = between + withinM * withinM;
    return all > 0 ? 1 + (each - 1) * between / all : 1;
  }

  /** The variance between placements; 0 where chance within them gives as much. */
  private double between() {
    double[] distances = placed.stream().mapToDouble(one -> one[0]).toArray();
    double[] readings = placed.stream().mapToDouble(one -> one[1]).toArray();
    DoubleSummaryStatistics span = Arrays.stream(distances).summaryStatistics();
    double line = Robust.medianSlope(distances, readings, APART * (span.getMax() - span.getMin()));
    double slope = Double.isNaN(line) ? 1 : line;
    double[] off = placed.stream().mapToDouble(one -> one[1] - slope * one[0]).toArray();
    double middle = Robust.median(off);
    double betweenM = scale(Arrays.stream(off).map(value -> Math.abs(value - middle)).toArray());
    double each = rows / placed.size();
    return Math.max(0, betweenM * betweenM - MEDIAN_VARIANCE * withinM * withinM / each);
  }
}
