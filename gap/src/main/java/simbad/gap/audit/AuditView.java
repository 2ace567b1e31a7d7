package simbad.gap.audit;

import java.util.Arrays;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import simbad.gap.fit.Placements;
import simbad.gap.fit.Robust;
import simbad.sonar.model.NominalModel;
import simbad.sonar.model.SightLine;
import simbad.sonar.model.TransducerPose;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.ReadingRow;
import simbad.sonar.shape.Outline;

/**
 * Rows beside what the scene says of them. They stand in an order of their own (run, sensor, time,
 * pose, reading), so that the order of the file changes nothing. Immutable.
 */
final class AuditView {
  /** From which chance on the scene expects an echo. */
  static final double EXPECTED = 0.5;

  /** Sound from -20 to 50 degrees, beside the 343 m/s of 20: no range is nearer than this known. */
  static final double AIR = 0.07;

  /** So far a sensor or an obstacle may stand from where it is believed, in metres. */
  static final double PLACE_M = Placements.MOST_OFF_M;

  /** Scatter beyond this many standard deviations is none: one reading in a thousand million. */
  static final double DEVIATIONS = 6;

  private final SensingSetup setup;
  private final List<Outline> outlines;
  private final List<ReadingRow> rows;
  private final int[] order;
  private final int[] begin;
  private final double[] rangeM;
  private final double[] expectedM;
  private final double[] inConeM;
  private final double[] aroundM;
  private final Set<Double> everywhere;
  private final double slope;
  private final double offsetM;

  AuditView(SensingSetup setup, List<ReadingRow> rows) {
    this.setup = setup;
    this.rows = rows;
    slope = 1;
    offsetM = 0;
    outlines = setup.scene().obstacles().stream().map(Obstacle::worldOutline).toList();
    order =
        IntStream.range(0, rows.size())
            .boxed()
            .sorted(Comparator.comparing(rows::get, BY_CONTENT))
            .mapToInt(Integer::intValue)
            .toArray();
    begin = begins();
    rangeM = IntStream.of(order).mapToDouble(i -> range(rows.get(i))).toArray();
    expectedM = new double[order.length];
    inConeM = new double[order.length * outlines.size()];
    aroundM = new double[inConeM.length];
    look();
    everywhere = everywhere();
  }

  private AuditView(AuditView other, RobustLine line) {
    setup = other.setup;
    rows = other.rows;
    outlines = other.outlines;
    order = other.order;
    begin = other.begin;
    rangeM = other.rangeM;
    expectedM = other.expectedM;
    inConeM = other.inConeM;
    aroundM = other.aroundM;
    everywhere = other.everywhere;
    slope = line.slope();
    offsetM = line.offset();
  }

  /** The same rows, when it is known which line their ranges follow. */
  AuditView along(RobustLine line) {
    return new AuditView(this, line);
  }

  private static final Comparator<ReadingRow> BY_CONTENT =
      Comparator.comparing(ReadingRow::run)
          .thenComparing(ReadingRow::sensor)
          .thenComparingDouble(ReadingRow::timeS)
          .thenComparingDouble(row -> row.pose().position().xM())
          .thenComparingDouble(row -> row.pose().position().zM())
          .thenComparingDouble(row -> row.pose().heading().radians())
          .thenComparingDouble(AuditView::range);

  /** NaN for a no-echo. */
  private static double range(ReadingRow row) {
    return row.reading() instanceof Echo echo ? echo.rangeM() : Double.NaN;
  }

  private void look() {
    NominalModel model = new NominalModel(setup.sensor(), setup.scene());
    TransducerPose from = new TransducerPose();
    SightLine line = new SightLine();
    for (int i = 0; i < order.length; i++) {
      ReadingRow row = row(i);
      double x = row.pose().position().xM();
      double z = row.pose().position().zM();
      from.aim(x, z, row.pose().heading().radians());
      expectedM[i] = Double.NaN;
      for (int o = 0; o < outlines.size(); o++) {
        model.trace(o, from, line);
        double p =
            model.echoProbability(line.nearestM(), line.centreDistanceM(), line.thresholdM());
        int at = i * outlines.size() + o;
        inConeM[at] = line.nearestM();
        aroundM[at] = outlines.get(o).distanceM(x, z);
        if (p >= EXPECTED && !(line.nearestM() >= expectedM[i])) {
          expectedM[i] = line.nearestM();
        }
      }
    }
  }

  private Set<Double> everywhere() {
    Map<Double, double[]> ends = new HashMap<>();
    for (int i = 0; i < size(); i++) {
      double at = expectedM[i];
      if (isEcho(i) && isExpected(i)) {
        double[] end = ends.computeIfAbsent(rangeM[i], v -> new double[] {at, at});
        end[0] = Math.min(end[0], at);
        end[1] = Math.max(end[1], at);
      }
    }
    return ends.entrySet().stream()
        .filter(one -> !isOf(one.getValue()[0], one.getValue()[1]))
        .map(Map.Entry::getKey)
        .collect(Collectors.toUnmodifiableSet());
  }

  SensingSetup setup() {
    return setup;
  }

  SonarSpec sensor() {
    return setup.sensor();
  }

  List<Outline> outlines() {
    return outlines;
  }

  int size() {
    return order.length;
  }

  ReadingRow row(int i) {
    return rows.get(order[i]);
  }

  /** The rows as the file has them. */
  List<ReadingRow> rows() {
    return rows;
  }

  /** Where a row stands in the file. */
  int inFile(int i) {
    return order[i];
  }

  /** Where rows stand in the file, ascending. */
  List<Integer> inFile(IntStream of) {
    return of.map(i -> order[i]).sorted().boxed().toList();
  }

  private int[] begins() {
    int[] begins = new int[order.length];
    for (int i = 1; i < order.length; i++) {
      boolean follows =
          row(i).isTimed()
              && row(i).run().equals(row(i - 1).run())
              && row(i).sensor().equals(row(i - 1).sensor());
      begins[i] = follows ? begins[i - 1] : i;
    }
    return begins;
  }

  /** Whether a row belongs to the run and sensor of the one before; without a time to none. */
  boolean follows(int i) {
    return i < order.length && begin[i] < i;
  }

  /** The first row of a row's run and sensor. */
  int begin(int i) {
    return begin[i];
  }

  boolean isEcho(int i) {
    return !Double.isNaN(rangeM[i]);
  }

  /** Metres as they stand in the file; NaN for a no-echo. */
  double rangeM(int i) {
    return rangeM[i];
  }

  /**
   * Whether a row's value was read at distances too different to be all of one: it says nothing of
   * how ranges go with distances, even where most rows have it.
   */
  boolean isEverywhere(int i) {
    return everywhere.contains(rangeM[i]);
  }

  /** Metres of the scene. */
  double asM(int i) {
    return (rangeM[i] - offsetM) / slope;
  }

  IntStream echoes() {
    return IntStream.range(0, size()).filter(this::isEcho);
  }

  /**
   * The step in which ranges come: the median way from one value to the next, or the sensor's step
   * where that is longer, metres.
   */
  double stepM() {
    double[] values = echoes().mapToDouble(this::rangeM).sorted().distinct().toArray();
    double[] gaps = new double[Math.max(0, values.length - 1)];
    Arrays.setAll(gaps, i -> values[i + 1] - values[i]);
    double median = Robust.median(gaps);
    return Math.max(sensor().resolutionM(), gaps.length == 0 ? 0 : median);
  }

  /** The nearest obstacle that the scene expects to echo, metres; NaN where it expects none. */
  double expectedM(int i) {
    return expectedM[i];
  }

  boolean isExpected(int i) {
    return !Double.isNaN(expectedM[i]);
  }

  /**
   * Whether a range is that of something in the cone, heard or not, as well as ranges are known.
   */
  boolean isInCone(int i, double range) {
    return isAmong(inConeM, i, range);
  }

  /** The same of something in whatever direction. */
  boolean isAround(int i, double range) {
    return isAmong(aroundM, i, range);
  }

  private boolean isAmong(double[] distances, int i, double range) {
    for (int at = i * outlines.size(); at < (i + 1) * outlines.size(); at++) {
      if (isOf(distances[at], range)) {
        return true;
      }
    }
    return false;
  }

  /** The nearest obstacle, wherever the sensor looks, metres; infinity where there is none. */
  double nearestM(int i) {
    return Arrays.stream(aroundM, i * outlines.size(), (i + 1) * outlines.size())
        .min()
        .orElse(Double.POSITIVE_INFINITY);
  }

  /** Whether a range may be of something at a distance; of infinity, which is nowhere, none is. */
  boolean isOf(double distance, double range) {
    return distance < Double.POSITIVE_INFINITY
        && Math.abs(range - distance) <= toleranceM(distance);
  }

  /** The obstacle, wherever the sensor looks, whose distance is nearest to a range; -1 for none. */
  int obstacleAt(int i, double range) {
    int best = -1;
    for (int o = 0; o < outlines.size(); o++) {
      if (best < 0 || offM(i, o, range) < offM(i, best, range)) {
        best = o;
      }
    }
    return best;
  }

  /** How far a range is from an obstacle's distance, wherever the sensor looks. */
  double offM(int i, int obstacle, double range) {
    return Math.abs(range - aroundM[i * outlines.size() + obstacle]);
  }

  /** How far a reading of a distance may be from it before the scene is wrong. */
  double toleranceM(double distanceM) {
    return scatterM() + PLACE_M + AIR * distanceM;
  }

  /** Standard deviation of a reading: noise and the rounding to steps. */
  double noiseM() {
    double step = sensor().resolutionM();
    return Math.sqrt(sensor().rangeNoiseM() * sensor().rangeNoiseM() + step * step / 12);
  }

  /** How far a reading may be from the mean of its like: noise and one step. */
  double scatterM() {
    return sensor().resolutionM() + DEVIATIONS * sensor().rangeNoiseM();
  }
}
