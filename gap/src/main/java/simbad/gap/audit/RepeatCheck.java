package simbad.gap.audit;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.NavigableMap;
import java.util.Optional;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import simbad.gap.audit.AuditFinding.File;
import simbad.sonar.frame.Angles;
import simbad.sonar.frame.Pose;

/**
 * Values that come again to the last digit at places where no obstacle has this distance, in a log
 * without times: a sensor that is stuck, or the last value for no echo. Which row came before is
 * not known there, so that only the values tell. An echo of whatever stands there scatters as all
 * echoes do.
 */
final class RepeatCheck {
  /** To either side, in steps: an echo that scatters could have had these values as well. */
  private static final int NEIGHBOURS = 5;

  /** More often no two readings of different things agree to the last digit. */
  private static final double AGREE = 0.05;

  /** With fewer pairs of readings of one place their scatter is taken from the line of all. */
  private static final int LEAST_PAIRS = 10;

  private static final int LEAST_PLACES = 3;

  /** Of the readings of a near limit, beside strays that were cut off there as well. */
  private static final double NEARLY_ALL = 0.9;

  private static final double SAME_RAD = Math.toRadians(2);
  private static final int LEAST_VALUES = 5;

  /** To either side, in steps: here it is counted how many values were read rightly. */
  private static final int WIDE = 50;

  /** Files have tenths of a millimetre. */
  private static final double FINEST_M = 1e-4;

  private static final String LEAVE_OUT = "these rows are left out of all that follows";

  private final AuditView view;
  private final Rest rest;
  private final double stepM;
  private final double greatestM;
  private final NavigableMap<Double, List<Integer>> displaced = new TreeMap<>();

  /** Values of readings that what stands there explains. */
  private final TreeSet<Double> right = new TreeSet<>();

  RepeatCheck(AuditView view, Rest rest) {
    this.view = view;
    this.rest = rest;
    stepM = finestM();
    greatestM = view.echoes().mapToDouble(view::rangeM).max().orElse(0);
    view.echoes().filter(i -> !view.row(i).isTimed()).forEach(this::sort);
    displaced.keySet().removeIf(this::isCode);
    displaced.entrySet().removeIf(one -> isNearLimit(one.getKey(), one.getValue()));
  }

  /** The least way from one value to another, as files are written. */
  private double finestM() {
    double[] values = view.echoes().mapToDouble(view::rangeM).sorted().distinct().toArray();
    return IntStream.range(1, values.length)
        .mapToDouble(i -> values[i] - values[i - 1])
        .filter(gap -> gap >= FINEST_M)
        .min()
        .orElse(FINEST_M);
  }

  private void sort(int i) {
    boolean isOther =
        !rest.isKnown(i) && (view.isInCone(i, view.asM(i)) || view.isAround(i, view.asM(i)));
    if (rest.isRight(i) || isOther) {
      right.add(view.rangeM(i));
    } else {
      displaced.computeIfAbsent(view.rangeM(i), v -> new ArrayList<>()).add(i);
    }
  }

  /**
   * Whether a value is the least that a sensor reports, since nothing is read below it and what
   * stands there is nearer: that is an effect with a name, near-clamp, and no fault of the log.
   */
  private boolean isNearLimit(double value, List<Integer> at) {
    long nearer = at.stream().filter(i -> view.expectedM(i) < value).count();
    return nearer >= NEARLY_ALL * at.size()
        && view.echoes().mapToDouble(view::rangeM).allMatch(range -> range >= value);
  }

  private boolean isCode(double value) {
    return Code.meaning(value, view.sensor(), greatestM).isPresent();
  }

  List<AuditFinding> find() {
    List<AuditFinding> found = new ArrayList<>();
    TreeMap<Double, List<Integer>> held = new TreeMap<>();
    boolean many = manyHeld();
    double agree = agreement();
    displaced.forEach(
        (value, at) -> {
          boolean wasRead = right.contains(value);
          boolean pile =
              places(at) >= LEAST_PLACES && movesAlong(at) && chance(value, at, agree) < level();
          if (wasRead && (many || pile)) {
            held.put(value, at);
          } else if (pile) {
            found.add(stuck(value, at));
          }
        });
    held(held).ifPresent(found::add);
    return found;
  }

  private double level() {
    return Tail.LEVEL / displaced.size();
  }

  private long places(List<Integer> at) {
    return at.stream().map(this::pose).distinct().count();
  }

  /**
   * Whether the sensor came nearer to whatever may stand before it, looking the same way: what it
   * hears while it moves past something may have one distance all the time.
   */
  private boolean movesAlong(List<Integer> at) {
    double least = NEIGHBOURS * (stepM + rest.noiseM());
    List<Pose> poses = at.stream().map(this::pose).distinct().toList();
    return poses.stream()
        .anyMatch(one -> poses.stream().anyMatch(other -> aheadM(one, other) > least));
  }

  /** How far one pose is ahead of another that looks the same way; 0 if it does not. */
  private static double aheadM(Pose one, Pose other) {
    double heading = other.heading().radians();
    if (Math.abs(Angles.signed(one.heading().radians() - heading)) > SAME_RAD) {
      return 0;
    }
    double xM = one.position().xM() - other.position().xM();
    double zM = one.position().zM() - other.position().zM();
    return xM * Math.cos(heading) - zM * Math.sin(heading);
  }

  private Pose pose(int i) {
    return view.row(i).pose();
  }

  /** That so many of those here and near by are here, if they scatter as readings do. */
  private double chance(double value, List<Integer> at, double agree) {
    double reach = NEIGHBOURS * stepM * (1 + 1e-9);
    int all =
        displaced.subMap(value - reach, true, value + reach, true).values().stream()
            .mapToInt(List::size)
            .sum();
    return Tail.atLeast(at.size(), all, Math.max(agree, 1.0 / (2 * NEIGHBOURS + 1)));
  }

  /** How often two readings of one place agree to the last digit, at most. */
  private double agreement() {
    Map<Pose, List<Integer>> byPlace =
        view.echoes()
            .filter(i -> right.contains(view.rangeM(i)))
            .boxed()
            .collect(Collectors.groupingBy(this::pose));
    long pairs = 0;
    long equal = 0;
    for (List<Integer> at : byPlace.values()) {
      Map<Double, Long> counts =
          at.stream().collect(Collectors.groupingBy(view::rangeM, Collectors.counting()));
      pairs += (long) at.size() * (at.size() - 1) / 2;
      equal += counts.values().stream().mapToLong(n -> n * (n - 1) / 2).sum();
    }
    // The density of the difference of two normal values at 0, over one step.
    double noise = Math.min(1, stepM / (2 * Math.sqrt(Math.PI) * rest.noiseM()));
    return pairs < LEAST_PAIRS ? noise : (equal + 1.0) / (pairs + 2);
  }

  /**
   * Whether values where they cannot be are far more often those of other places than by chance.
   */
  private boolean manyHeld() {
    int hits = (int) displaced.keySet().stream().filter(right::contains).count();
    double density = displaced.keySet().stream().mapToDouble(this::density).average().orElse(1);
    int values = displaced.size();
    return values >= LEAST_VALUES
        && Tail.atLeast(hits, values, Math.min(1, Math.max(AGREE, 2 * density))) < Tail.LEVEL;
  }

  /** Which share of the values round one was read rightly somewhere. */
  private double density(double value) {
    double reach = WIDE * stepM;
    return right.subSet(value - reach, true, value + reach, true).size() / (2.0 * WIDE + 1);
  }

  private Optional<AuditFinding> held(Map<Double, List<Integer>> held) {
    int rows = held.values().stream().mapToInt(List::size).sum();
    return held.isEmpty()
        ? Optional.empty()
        : Optional.of(
            finding(
                AuditCheck.HELD,
                Say.readings(rows)
                    + " that repeat a value of another place to the last digit ("
                    + most(held)
                    + ") where the scene expects other distances: the last value is held",
                held.values()));
  }

  /** The value that comes again most. */
  private static String most(Map<Double, List<Integer>> held) {
    Map.Entry<Double, List<Integer>> most =
        held.entrySet().stream()
            .max(Comparator.comparingInt(one -> one.getValue().size()))
            .orElseThrow();
    return Say.exact(most.getKey()) + " m " + times(most.getValue().size());
  }

  private static String times(int count) {
    return count == 1 ? "once" : count + " times";
  }

  private AuditFinding stuck(double value, List<Integer> at) {
    return finding(
        AuditCheck.STUCK,
        Say.readings(at.size())
            + " of exactly "
            + Say.exact(value)
            + " m at "
            + places(at)
            + " places where the scene expects other distances; no echo scatters so little: the"
            + " sensor is stuck",
        List.of(at));
  }

  private AuditFinding finding(AuditCheck check, String what, Collection<List<Integer>> rows) {
    IntStream all = rows.stream().flatMap(List::stream).mapToInt(Integer::intValue);
    return new AuditFinding(
        check, File.READINGS, what, view.inFile(all), LEAVE_OUT, "", Severity.WARN);
  }
}
