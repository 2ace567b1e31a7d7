package simbad.sonar.ping;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.IntStream;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.ReadingRow;

/**
 * Pings with what was read, in the order in which each sensor sent them.
 *
 * <p>The pings of one run and sensor form a sequence: they stand side by side, ordered by time, and
 * the order of rows decides where times are equal. A row without a time is a sequence of its own:
 * what it may remember is not known, and its place is by its pose and reading. Otherwise the order
 * of rows changes nothing. Immutable, safe for use by several threads.
 */
public final class PingLog {
  private static final double SAME_PLACE_M = 0.001;

  /** Sums over rows without a time are taken in one order, whichever line comes first. */
  private static final Comparator<ReadingRow> UNTIMED =
      Comparator.<ReadingRow>comparingDouble(one -> one.pose().position().xM())
          .thenComparingDouble(one -> one.pose().position().zM())
          .thenComparingDouble(one -> one.pose().heading().radians())
          .thenComparing(one -> one.circumstances().placement().orElse(""))
          .thenComparingDouble(one -> one.reading() instanceof Echo heard ? heard.rangeM() : -1);

  private final int[] row;
  private final int[] sequenceStart;
  private final int[] run;
  private final int[] sensor;
  private final boolean[] timed;
  private final List<Optional<String>> placement = new ArrayList<>();
  private final double[] timeS;
  private final double[] xM;
  private final double[] zM;
  private final double[] headingRad;
  private final double[] directionX;
  private final double[] directionZ;
  private final boolean[] echo;
  private final double[] rangeM;
  private final double[] runStartS;
  private final double[] temperatureC;
  private final double firstS;
  private final List<String> runs;
  private final List<String> sensors;

  /**
   * Sorts rows into sequences.
   *
   * @param rows in any order
   */
  public PingLog(List<ReadingRow> rows) {
    Map<String, Integer> runIndex = numbered(rows.stream().map(ReadingRow::run).toList());
    Map<String, Integer> sensorIndex = numbered(rows.stream().map(ReadingRow::sensor).toList());
    runs = List.copyOf(runIndex.keySet());
    sensors = List.copyOf(sensorIndex.keySet());
    int[] rowRun = rows.stream().mapToInt(one -> runIndex.getOrDefault(one.run(), 0)).toArray();
    int[] rowSensor =
        rows.stream().mapToInt(one -> sensorIndex.getOrDefault(one.sensor(), 0)).toArray();
    row = order(rows, rowRun, rowSensor);
    int size = row.length;
    sequenceStart = new int[size];
    run = new int[size];
    sensor = new int[size];
    timed = new boolean[size];
    timeS = new double[size];
    xM = new double[size];
    zM = new double[size];
    headingRad = new double[size];
    directionX = new double[size];
    directionZ = new double[size];
    echo = new boolean[size];
    rangeM = new double[size];
    runStartS = new double[size];
    temperatureC = new double[size];
    Map<String, Double> starts = runStarts(rows);
    firstS = starts.values().stream().mapToDouble(s -> s).min().orElse(0);
    for (int i = 0; i < size; i++) {
      run[i] = rowRun[row[i]];
      sensor[i] = rowSensor[row[i]];
      fill(i, rows.get(row[i]), starts);
    }
  }

  private void fill(int i, ReadingRow from, Map<String, Double> starts) {
    timed[i] = from.isTimed();
    placement.add(from.circumstances().placement());
    boolean follows = timed[i] && i > 0 && run[i - 1] == run[i] && sensor[i - 1] == sensor[i];
    sequenceStart[i] = follows ? sequenceStart[i - 1] : i;
    timeS[i] = from.timeS();
    temperatureC[i] = from.circumstances().temperatureC().orElse(Double.NaN);
    xM[i] = from.pose().position().xM();
    zM[i] = from.pose().position().zM();
    headingRad[i] = from.pose().heading().radians();
    directionX[i] = Math.cos(headingRad[i]);
    directionZ[i] = -Math.sin(headingRad[i]);
    runStartS[i] = starts.getOrDefault(from.run(), 0.0);
    if (from.reading() instanceof Echo heard) {
      echo[i] = true;
      rangeM[i] = heard.rangeM();
    }
  }

  /** Each label with its place in their alphabet: which line comes first says nothing. */
  private static Map<String, Integer> numbered(List<String> all) {
    Map<String, Integer> numbers = new LinkedHashMap<>();
    for (String label : new TreeSet<>(all)) {
      numbers.put(label, numbers.size());
    }
    return numbers;
  }

  private static int[] order(List<ReadingRow> rows, int[] run, int[] sensor) {
    return IntStream.range(0, rows.size())
        .boxed()
        .sorted(
            Comparator.<Integer>comparingInt(i -> run[i])
                .thenComparingInt(i -> sensor[i])
                .thenComparingDouble(i -> rows.get(i).timeS())
                .thenComparing(i -> rows.get(i).isTimed())
                .thenComparing(rows::get, (a, b) -> a.isTimed() ? 0 : UNTIMED.compare(a, b)))
        .mapToInt(Integer::intValue)
        .toArray();
  }

  private static Map<String, Double> runStarts(List<ReadingRow> rows) {
    Map<String, Double> starts = new TreeMap<>();
    rows.forEach(one -> starts.merge(one.run(), one.timeS(), Math::min));
    return starts;
  }

  /** Returns the number of pings. */
  public int size() {
    return row.length;
  }

  /** Returns the place of a ping in the rows that the log was made of. */
  public int row(int ping) {
    return row[ping];
  }

  /** Returns the first ping of the sequence that a ping belongs to. */
  public int sequenceStart(int ping) {
    return sequenceStart[ping];
  }

  /** Returns the index of a ping's run in {@link #runs()}. */
  public int run(int ping) {
    return run[ping];
  }

  /** Returns the index of a ping's sensor in {@link #sensors()}. */
  public int sensor(int ping) {
    return sensor[ping];
  }

  /** Returns the labels of the runs in their alphabet. */
  public List<String> runs() {
    return runs;
  }

  /** Returns the labels of the sensors in their alphabet. */
  public List<String> sensors() {
    return sensors;
  }

  /** Returns the word for what was put in place for a ping; empty where the log has none. */
  public Optional<String> placement(int ping) {
    return placement.get(ping);
  }

  /** Tells whether a ping's time is known. */
  public boolean isTimed(int ping) {
    return timed[ping];
  }

  /** Returns a ping's time in seconds; 0 where it is not known. */
  public double timeS(int ping) {
    return timeS[ping];
  }

  /** Returns the time of the first ping of a ping's run in seconds, over all its sensors. */
  public double runStartS(int ping) {
    return runStartS[ping];
  }

  /** Returns the time of the first ping of all in seconds; 0 where no time is known. */
  public double firstS() {
    return firstS;
  }

  /** Returns how long after it the last ping with a time was, seconds; 0 where none has one. */
  public double lastsS() {
    double last = 0;
    for (int ping = 0; ping < size(); ping++) {
      last = timed[ping] ? Math.max(last, timeS[ping] - firstS) : last;
    }
    return last;
  }

  /** Returns the temperature of the air at a ping, degrees Celsius; not a number where unknown. */
  public double temperatureC(int ping) {
    return temperatureC[ping];
  }

  /** Returns the believed x of the sensor in metres. */
  public double xM(int ping) {
    return xM[ping];
  }

  /** Returns the believed z of the sensor in metres. */
  public double zM(int ping) {
    return zM[ping];
  }

  /** Returns the believed heading of the sensor in radians. */
  public double headingRad(int ping) {
    return headingRad[ping];
  }

  /** Returns the x component of the believed heading, of length 1 with the z component. */
  double directionX(int ping) {
    return directionX[ping];
  }

  /** Returns the z component of the believed heading. */
  double directionZ(int ping) {
    return directionZ[ping];
  }

  /** Returns whether an echo was read. */
  public boolean echo(int ping) {
    return echo[ping];
  }

  /** Returns the range that was read in metres; of no meaning where no echo was. */
  public double rangeM(int ping) {
    return rangeM[ping];
  }

  /** Returns the number of pings that read an echo. */
  public int echoes() {
    int count = 0;
    for (boolean heard : echo) {
      count += heard ? 1 : 0;
    }
    return count;
  }

  /**
   * Returns how fast the sensor's believed place moved since the ping before, metres per second; at
   * the start of a sequence up to the next ping. 0 where there is no other ping or no time between.
   */
  public double speedMPerS(int ping) {
    int from = ping > sequenceStart[ping] ? ping - 1 : ping;
    int to = from + 1;
    if (to >= size() || sequenceStart[to] != sequenceStart[ping] || timeS[to] <= timeS[from]) {
      return 0;
    }
    return Math.hypot(xM[to] - xM[from], zM[to] - zM[from]) / (timeS[to] - timeS[from]);
  }

  /** Returns whether all pings were sent from one place, as far as poses are written. */
  public boolean isOfOnePlace() {
    return IntStream.range(0, size())
        .allMatch(ping -> Math.hypot(xM[ping] - xM[0], zM[ping] - zM[0]) < SAME_PLACE_M);
  }
}
