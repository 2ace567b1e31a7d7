package simbad.gap.locate;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.OptionalDouble;
import java.util.stream.DoubleStream;
import simbad.gap.diagnosis.Interval;
import simbad.gap.fit.Placements;
import simbad.gap.fit.Robust;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.SensingSetup;

/**
 * Of a log that was taken place by place: how far each placement is off, and which one is off alone
 * - where a tape was misread, or something was bumped.
 *
 * <p>One is off alone where it is more than six standard deviations from the median of all:
 * deviations of the others from each other (by their median absolute deviation), and no less than
 * what scatter, steps and places known so well give, and where the placements beside it, in the
 * order of their poses, are not off to the same side: a whole stretch that is off is no misread
 * tape. Of fewer than six placements none is called off. False alarms: of 4000 ladders with 10 to
 * 30 placements by a tape of 2 mm 14, of 5 mm 30; with 6 to 9 placements 42 and 129.
 */
public final class PlacementOffsets {
  private static final double DEVIATIONS = 6;
  private static final int LEAST = 6;

  /** Echoes of one placement: fewer may be of something else. */
  private static final int LEAST_ROWS = 3;

  /**
   * Of the mean of the middle half of normal values: its variance over that of their mean, 1.2, and
   * 1.35 of three, of which it is the median.
   */
  private static final double MIDDLE_VARIANCE = 1.35;

  private static final double NORMAL_95 = 1.96;

  private final SensingSetup setup;
  private final List<Mean> means;
  private final double withinM;

  private PlacementOffsets(SensingSetup setup, List<Mean> means, double withinM) {
    this.setup = setup;
    this.means = means;
    this.withinM = withinM;
  }

  /** What one placement reads in the mean; all of them stand in the order of their poses. */
  private record Mean(
      String label, List<Integer> pings, double expectedM, double beforeM, double afterM) {}

  /**
   * Compares a log with two models.
   *
   * @param setup as the simulator believes it
   * @param log what was read
   * @param beforeM of each ping the reading less the echo that the simulator expects, metres; empty
   *     where no echo was read or none expected
   * @param afterM the same of the diagnosed model
   * @return by distance; none where the log was not taken place by place
   */
  public static List<PlacementOffset> of(
      SensingSetup setup, PingLog log, List<OptionalDouble> beforeM, List<OptionalDouble> afterM) {
    Placements placements = new Placements(log);
    if (!placements.areRepeated()) {
      return List.of();
    }
    List<List<Integer>> pings = new ArrayList<>();
    for (int i = 0; i < placements.count(); i++) {
      pings.add(new ArrayList<>());
    }
    for (int ping = 0; ping < log.size(); ping++) {
      if (beforeM.get(ping).isPresent() && afterM.get(ping).isPresent()) {
        pings.get(placements.of(ping)).add(ping);
      }
    }
    List<Mean> means = new ArrayList<>();
    DoubleStream.Builder within = DoubleStream.builder();
    for (int i = 0; i < pings.size(); i++) {
      List<Integer> own = pings.get(i);
      if (!own.isEmpty()) {
        double[] after = own.stream().mapToDouble(ping -> afterM.get(ping).orElseThrow()).toArray();
        double middle = middle(after);
        if (own.size() > 1) {
          Arrays.stream(after).map(one -> Math.abs(one - middle)).forEach(within);
        }
        means.add(mean(log, own, i, beforeM, middle));
      }
    }
    double seen = Robust.NORMAL_OVER_MAD * Robust.median(within.build().toArray());
    double believed = setup.sensor().rangeNoiseM();
    return new PlacementOffsets(setup, means, seen > 0 ? seen : believed).all();
  }

  /**
   * The mean of the middle half: a few readings of something else say nothing of where it stood,
   * and where readings come in steps a median would lie on one.
   */
  private static double middle(double... values) {
    double[] sorted = values.clone();
    Arrays.sort(sorted);
    int left = sorted.length > 2 ? Math.max(1, sorted.length / 4) : 0;
    return Arrays.stream(sorted, left, sorted.length - left).average().orElse(Double.NaN);
  }

  private static Mean mean(
      PingLog log, List<Integer> pings, int number, List<OptionalDouble> beforeM, double afterM) {
    double[] before = pings.stream().mapToDouble(ping -> beforeM.get(ping).orElseThrow()).toArray();
    double[] expected =
        pings.stream()
            .mapToDouble(ping -> log.rangeM(ping) - beforeM.get(ping).orElseThrow())
            .toArray();
    String label = log.placement(pings.get(0)).orElse(Integer.toString(number + 1));
    return new Mean(label, pings, Robust.median(expected), middle(before), afterM);
  }

  private List<PlacementOffset> all() {
    double middle = Robust.median(means.stream().mapToDouble(Mean::afterM).toArray());
    double between =
        Robust.NORMAL_OVER_MAD
            * Robust.median(
                means.stream().mapToDouble(mean -> Math.abs(mean.afterM - middle)).toArray());
    int[] side =
        means.stream().mapToInt(mean -> offSide(mean, mean.afterM - middle, between)).toArray();
    List<PlacementOffset> offsets = new ArrayList<>();
    for (int i = 0; i < side.length; i++) {
      boolean withNext = i + 1 < side.length && side[i + 1] == side[i];
      boolean withBefore = i > 0 && side[i - 1] == side[i];
      offsets.add(offset(means.get(i), side[i] != 0 && !withNext && !withBefore));
    }
    offsets.sort(Comparator.comparingDouble(PlacementOffset::distanceM));
    return offsets;
  }

  /** Whether a placement is too far from the others, and to which side: -1, 0 or 1. */
  private int offSide(Mean mean, double awayM, double betweenM) {
    double placed = Math.hypot(deviationM(mean), setup.details().poseSigmaM());
    boolean isOff =
        means.size() >= LEAST
            && mean.pings.size() >= LEAST_ROWS
            && Math.abs(awayM) > DEVIATIONS * Math.max(betweenM, placed);
    return isOff ? (int) Math.signum(awayM) : 0;
  }

  private PlacementOffset offset(Mean mean, boolean isOff) {
    double half = NORMAL_95 * deviationM(mean);
    return new PlacementOffset(
        mean.label,
        mean.expectedM,
        mean.pings,
        mean.beforeM,
        mean.afterM,
        new Interval(mean.afterM - half, mean.afterM + half),
        isOff);
  }

  /** A step that all readings of a placement share is not averaged away. */
  private double deviationM(Mean mean) {
    double scatter = withinM * Math.sqrt(MIDDLE_VARIANCE / mean.pings.size());
    return Math.hypot(scatter, setup.sensor().resolutionM() / Math.sqrt(12));
  }
}
