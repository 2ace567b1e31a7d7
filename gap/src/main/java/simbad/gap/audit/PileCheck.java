package simbad.gap.audit;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.NavigableMap;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.IntStream;
import simbad.gap.audit.AuditFinding.File;
import simbad.gap.fit.Robust;

/**
 * Values that stand where the scene expects others, and more often than their neighbours: a number
 * for no echo, or something that always answers from the same distance.
 */
final class PileCheck {
  /** To either side, in steps; so many values could have come as well. */
  private static final int NEIGHBOURS = 5;

  private static final int LEAST = 3;

  /** Of a value that is known to mean no echo. */
  private static final double LEVEL_OF_CODE = 0.01;

  private final AuditView view;
  private final double stepM;
  private final double greatestM;

  /** Of what the scene expects. */
  private final double middleM;

  private final NavigableMap<Double, List<Integer>> displaced = new TreeMap<>();

  PileCheck(AuditView view) {
    this.view = view;
    stepM = view.stepM();
    greatestM = view.echoes().mapToDouble(view::rangeM).max().orElse(0);
    middleM =
        Robust.median(
            IntStream.range(0, view.size())
                .filter(view::isExpected)
                .mapToDouble(view::expectedM)
                .toArray());
    view.echoes()
        .filter(i -> !view.isInCone(i, view.asM(i)) && !view.isAround(i, view.asM(i)))
        .forEach(i -> displaced.computeIfAbsent(view.rangeM(i), v -> new ArrayList<>()).add(i));
  }

  /**
   * Finds the piles.
   *
   * @param told rows of the file of which something else was found
   */
  List<AuditFinding> find(Set<Integer> told) {
    displaced.values().forEach(at -> at.removeIf(i -> told.contains(view.inFile(i))));
    displaced.values().removeIf(List::isEmpty);
    List<AuditFinding> found = new ArrayList<>();
    for (Map.Entry<Double, List<Integer>> one : displaced.entrySet()) {
      double value = one.getKey();
      List<Integer> at = one.getValue();
      Optional<String> code = Code.meaning(value, view.sensor(), greatestM);
      if (code.isPresent() && isCode(value, at)) {
        found.add(code(value, code.get(), at));
      } else if (varies(at) && chance(value, seriesOf(at)) < Tail.LEVEL / displaced.size()) {
        found.add(pile(value, at));
      }
    }
    return found;
  }

  /**
   * At the ends of what a sensor reads no echo is to be expected, so that hardly any doubt is left;
   * but what is cut off at 0 is near.
   */
  private boolean isCode(double value, List<Integer> at) {
    if (value > 0 && value < Code.NEAR_THE_MOST * view.sensor().maxRangeM()) {
      return varies(at) && chance(value, seriesOf(at)) < Tail.LEVEL;
    }
    long far = at.stream().filter(i -> !(view.expectedM(i) < middleM)).count();
    return at.size() >= LEAST
        && chance(value, at.size()) < LEVEL_OF_CODE
        && (value > 0 || 2 * far > at.size());
  }

  /** From one distance again and again whatever is there answers with one value. */
  private boolean varies(List<Integer> at) {
    double[] nearest = at.stream().mapToDouble(view::nearestM).sorted().toArray();
    double spread = nearest[3 * nearest.length / 4] - nearest[nearest.length / 4];
    return spread > view.toleranceM(nearest[nearest.length / 2]);
  }

  /** That so many of those here and near by are here, if all values are as probable. */
  private double chance(double value, int here) {
    double reach = NEIGHBOURS * stepM * (1 + 1e-9);
    int near =
        displaced.subMap(value - reach, true, value + reach, true).entrySet().stream()
            .filter(one -> one.getKey() != value)
            .mapToInt(one -> one.getValue().size())
            .sum();
    double below = Math.min(NEIGHBOURS, Math.floor(value / Math.max(stepM, 1e-9) + 1e-9));
    return Tail.atLeast(here, here + near, 1 / (below + 1 + NEIGHBOURS));
  }

  /** Rows in a row are one: a sensor that stands hears the same again. */
  private int seriesOf(List<Integer> rows) {
    int series = 0;
    for (int k = 0; k < rows.size(); k++) {
      series += k == 0 || !isOne(rows.get(k - 1), rows.get(k)) ? 1 : 0;
    }
    return series;
  }

  /** Without times nobody knows what was in a row; but what was read at one place. */
  private boolean isOne(int before, int row) {
    return view.row(row).isTimed()
        ? row == before + 1
        : view.row(row).pose().equals(view.row(before).pose());
  }

  private AuditFinding code(double value, String meaning, List<Integer> at) {
    return new AuditFinding(
        AuditCheck.NO_ECHO_CODE,
        File.READINGS,
        Say.readings(at.size())
            + " of exactly "
            + Say.exact(value)
            + " m ("
            + meaning
            + ") where the scene expects no such distance: a number that stands for no echo",
        rows(at),
        "leave range_m empty where there was no echo",
        "--no-echo " + Say.exact(value),
        Severity.WARN);
  }

  private AuditFinding pile(double value, List<Integer> at) {
    long beyond = at.stream().filter(i -> view.expectedM(i) < value).count();
    boolean isLimit = 2 * beyond > at.size();
    return new AuditFinding(
        AuditCheck.PILE,
        File.READINGS,
        Say.readings(at.size())
            + " of exactly "
            + Say.exact(value)
            + " m where the scene expects "
            + (isLimit
                ? "less: perhaps the nearest that the sensor reports"
                : "other distances or none: the floor, the robot's own body, or a number for no"
                    + " echo"),
        rows(at),
        "",
        "",
        Severity.NOTE);
  }

  private List<Integer> rows(List<Integer> at) {
    return view.inFile(at.stream().mapToInt(Integer::intValue));
  }
}
