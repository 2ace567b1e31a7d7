package simbad.gap.audit;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.IntStream;
import simbad.gap.audit.AuditFinding.File;
import simbad.gap.fit.Robust;

/**
 * Readings that are exactly the one before, though since then the sensor went where no obstacle has
 * this distance any more.
 */
final class HeldCheck {
  /** More often no two readings of different things agree to the last digit. */
  private static final double AGREE = 0.05;

  /** Of a value that came again, how often it may come again by chance. */
  private static final double AGAIN = 0.5;

  private static final int LEAST_VALUES = 3;

  /** The third reading before is held no more, but of the same scatter. */
  private static final int LATER = 3;

  private static final double MORE = 2;

  /** Of all readings: one value and hardly any other. */
  private static final double NEARLY_ALL = 0.9;

  private static final String LEAVE_OUT =
      "leave these rows out, and look at the sensor and its wiring";

  private final AuditView view;
  private final double stepM;
  private final List<Series> all = new ArrayList<>();
  private int chances;

  /** Rows of one value, one after the other. */
  private static final class Series {
    private final int from;
    private final boolean isReal;
    private final double offM;
    private final List<Integer> held = new ArrayList<>();
    private int length = 1;

    Series(int from, boolean isReal, double offM) {
      this.from = from;
      this.isReal = isReal;
      this.offM = offM;
    }
  }

  HeldCheck(AuditView view) {
    this.view = view;
    stepM = view.stepM();
    Series series = new Series(-1, false, 0);
    for (int i = 0; i < view.size(); i++) {
      boolean again = view.follows(i) && view.isEcho(i) && view.isEcho(i - 1);
      boolean equal = again && view.rangeM(i) == view.rangeM(i - 1);
      if (again && mustDiffer(i, series)) {
        chances += series.isReal ? 1 : 0;
        if (equal) {
          series.held.add(i);
        }
      }
      if (equal) {
        series.length++;
      } else {
        series = begin(i);
      }
    }
  }

  private Series begin(int i) {
    double range = view.asM(i);
    boolean real = view.isEcho(i) && view.isInCone(i, range);
    Series series = new Series(i, real, real ? offM(i, range) : 0);
    all.add(series);
    return series;
  }

  private double offM(int i, double range) {
    int obstacle = view.obstacleAt(i, range);
    return obstacle < 0 ? Double.POSITIVE_INFINITY : view.offM(i, obstacle, range);
  }

  /** Whether no obstacle, wherever the sensor looks, has the distance that was read before. */
  private boolean mustDiffer(int i, Series series) {
    double before = view.asM(i - 1);
    boolean clamped = view.expectedM(i) < before;
    double slack = series.offM + 2 * stepM + view.scatterM();
    return !clamped && offM(i, before) > slack;
  }

  List<AuditFinding> find() {
    return held().or(this::stuck).or(this::repeated).map(List::of).orElse(List.of());
  }

  private Optional<AuditFinding> held() {
    List<Series> real = all.stream().filter(one -> one.isReal && !one.held.isEmpty()).toList();
    int rows = real.stream().mapToInt(one -> one.held.size()).sum();
    Map<Double, Integer> byValue = new TreeMap<>();
    real.forEach(one -> byValue.merge(view.rangeM(one.from), one.held.size(), Integer::sum));
    int most = byValue.values().stream().mapToInt(Integer::intValue).max().orElse(0);
    long sequences = real.stream().mapToInt(one -> view.begin(one.from)).distinct().count();
    // Without the commonest value, which may be one that is stuck or the least that is reported.
    boolean shows =
        real.size() > sequences
            && byValue.size() >= LEAST_VALUES
            && Tail.atLeast(rows - most, chances - most, AGREE) < Tail.LEVEL;
    return shows
        ? Optional.of(
            finding(
                AuditCheck.HELD,
                Say.readings(rows)
                    + " that repeat the one before to the last digit where the sensor had moved on:"
                    + " the last value is held",
                "leave range_m empty where there was no echo, instead of the value before",
                real))
        : Optional.empty();
  }

  /**
   * Whether readings repeat the one before to the last digit more often than the one three before:
   * at one place scatter of few values does both alike.
   */
  private Optional<AuditFinding> repeated() {
    int[] pairs =
        view.echoes()
            .filter(i -> follow(i, LATER) && IntStream.range(i - LATER, i).allMatch(view::isEcho))
            .toArray();
    int[] next = equal(1, pairs);
    double later = (double) equal(LATER, pairs).length / Math.max(1, pairs.length);
    double chance = Math.max(AGREE, MORE * later);
    return chance < 1 && Tail.atLeast(next.length, pairs.length, chance) < Tail.LEVEL
        ? Optional.of(
            new AuditFinding(
                AuditCheck.HELD,
                File.READINGS,
                Say.readings(next.length)
                    + " that repeat the one before to the last digit, far more than repeat the third"
                    + " before: the last value is held",
                view.inFile(IntStream.of(next)),
                "leave range_m empty where there was no echo, instead of the value before",
                "",
                Severity.WARN))
        : Optional.empty();
  }

  private boolean follow(int i, int times) {
    return i >= times
        && IntStream.range(i - times + 1, i + 1)
            .allMatch(at -> view.follows(at) && view.row(at).pose().equals(view.row(i).pose()))
        && view.row(i - times).pose().equals(view.row(i).pose());
  }

  private int[] equal(int before, int... rows) {
    return IntStream.of(rows).filter(i -> view.rangeM(i) == view.rangeM(i - before)).toArray();
  }

  private Optional<AuditFinding> stuck() {
    Optional<AuditFinding> always = always();
    if (always.isPresent()) {
      return always;
    }
    List<Series> stuck = all.stream().filter(this::isStuck).toList();
    int rows = stuck.stream().mapToInt(one -> one.length).sum();
    return stuck.isEmpty()
        ? Optional.empty()
        : Optional.of(
            finding(
                AuditCheck.STUCK,
                Say.readings(rows)
                    + " in a row of "
                    + Say.exact(view.rangeM(stuck.get(0).from))
                    + " m, whatever the sensor looks at: it is stuck",
                LEAVE_OUT,
                stuck));
  }

  /** Whether there is hardly any other value. */
  private Optional<AuditFinding> always() {
    double middle = Robust.median(view.echoes().mapToDouble(view::rangeM).toArray());
    int[] same = view.echoes().filter(i -> view.rangeM(i) == middle).toArray();
    int[] wrong =
        IntStream.of(same)
            .filter(i -> !view.isInCone(i, view.asM(i)) && !view.isAround(i, view.asM(i)))
            .toArray();
    int echoes = view.echoes().toArray().length;
    boolean shows =
        same.length >= NEARLY_ALL * echoes && Math.pow(AGAIN, wrong.length) < Tail.LEVEL;
    // A floor answers from one distance too, but not where something stands before it.
    return shows && rightAfter(wrong[0], middle) < LEAST_VALUES
        ? Optional.of(
            new AuditFinding(
                AuditCheck.STUCK,
                File.READINGS,
                Say.readings(same.length)
                    + " of "
                    + Say.exact(middle)
                    + " m and hardly any other: it is stuck",
                view.inFile(IntStream.of(same)),
                LEAVE_OUT,
                "",
                // Of a whole log that is one number no reading can be believed.
                Severity.REFUSE))
        : Optional.empty();
  }

  /** How many other values there are from a row on that are right. */
  private long rightAfter(int row, double value) {
    return view.echoes()
        .filter(i -> i > row && view.rangeM(i) != value)
        .filter(i -> view.isInCone(i, view.asM(i)))
        .count();
  }

  private boolean isStuck(Series series) {
    double chance = Math.pow(AGAIN, series.held.size()) * view.size();
    return chance < Tail.LEVEL
        && (isNearlyAll(series) || (series.isReal && timesOf(series) == 1))
        && !isCode(series);
  }

  /** Of its run and sensor: then it need not begin with a true reading. */
  private boolean isNearlyAll(Series series) {
    int begin = view.begin(series.from);
    int end = series.from + series.length;
    while (end < view.size() && view.begin(end) == begin) {
      end++;
    }
    return series.length >= NEARLY_ALL * (end - begin);
  }

  private boolean isCode(Series series) {
    double greatest = view.echoes().mapToDouble(view::rangeM).max().orElse(0);
    return Code.meaning(view.rangeM(series.from), view.sensor(), greatest).isPresent();
  }

  /** How many series of a sensor's value have rows where it cannot be right. */
  private long timesOf(Series series) {
    double value = view.rangeM(series.from);
    return all.stream()
        .filter(one -> !one.held.isEmpty() && view.rangeM(one.from) == value)
        .filter(one -> view.begin(one.from) == view.begin(series.from))
        .count();
  }

  private AuditFinding finding(AuditCheck check, String what, String suggestion, List<Series> of) {
    IntStream rows = of.stream().flatMap(one -> one.held.stream()).mapToInt(Integer::intValue);
    return new AuditFinding(
        check, File.READINGS, what, view.inFile(rows), suggestion, "", Severity.WARN);
  }
}
