package simbad.gap.audit;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.hipparchus.distribution.continuous.TDistribution;
import simbad.gap.audit.AuditFinding.File;
import simbad.gap.fit.Robust;
import simbad.sonar.frame.Pose;
import simbad.sonar.sensing.ReadingRow;

/**
 * Placements of a log of repeated readings whose readings are off all together, far more than those
 * of the other placements: the tape, or what stood before the sensor, rather than the sensor.
 */
final class PlacedCheck {
  private static final int LEAST_READINGS = 3;
  private static final int LEAST_PLACEMENTS = 6;

  /** With more of them off it is no matter of single ones. */
  private static final double MOST = 0.2;

  private final AuditView view;
  private final List<Group> groups = new ArrayList<>();

  /** Readings of one placement: how far off, in the middle. */
  private record Group(List<Integer> rows, double offM) {}

  PlacedCheck(AuditView view, Rest rest) {
    this.view = view;
    Map<Object, List<Integer>> byPlace = new LinkedHashMap<>();
    for (int i = 0; i < view.size(); i++) {
      if (rest.isKnown(i)) {
        byPlace.computeIfAbsent(place(view.row(i)), place -> new ArrayList<>()).add(i);
      }
    }
    for (List<Integer> rows : byPlace.values()) {
      if (rows.size() >= LEAST_READINGS) {
        groups.add(new Group(rows, Robust.median(rows.stream().mapToDouble(rest::offM).toArray())));
      }
    }
  }

  /** What a log calls it, else where the sensor stood. */
  private record Spot(String run, String sensor, Pose pose) {}

  private static Object place(ReadingRow row) {
    Optional<String> word = row.circumstances().placement();
    return word.isPresent() ? word.get() : new Spot(row.run(), row.sensor(), row.pose());
  }

  Optional<AuditFinding> find() {
    int n = groups.size();
    if (n < LEAST_PLACEMENTS) {
      return Optional.empty();
    }
    double[] off = groups.stream().mapToDouble(Group::offM).toArray();
    double middle = Robust.median(off);
    double[] size = Arrays.stream(off).map(one -> Math.abs(one - middle)).toArray();
    // Rounding to steps is the same for all of a placement; noise is not.
    double step = view.sensor().resolutionM();
    double noise = view.sensor().rangeNoiseM();
    double least = Math.sqrt(step * step / 12 + noise * noise / LEAST_READINGS);
    double scatter = Math.max(least, Robust.NORMAL_OVER_MAD * Robust.median(size));
    double far = new TDistribution(n - 2).inverseCumulativeProbability(1 - Tail.LEVEL / (2 * n));
    List<Group> wrong =
        groups.stream().filter(one -> Math.abs(one.offM - middle) > far * scatter).toList();
    return wrong.isEmpty() || wrong.size() > MOST * n
        ? Optional.empty()
        : Optional.of(finding(wrong, middle, scatter));
  }

  private AuditFinding finding(List<Group> wrong, double middle, double scatter) {
    Group worst = wrong.get(0);
    for (Group one : wrong) {
      worst = Math.abs(one.offM - middle) > Math.abs(worst.offM - middle) ? one : worst;
    }
    double off = worst.offM - middle;
    int first = worst.rows.get(0);
    String which = view.row(first).circumstances().placement().map(word -> " " + word).orElse("");
    String what =
        String.format(
            Locale.ROOT,
            "%s, %s at a distance of %s m, are %s m too %s all together, where the others are off"
                + " by %s m from each other",
            Say.readings(worst.rows.size()),
            "placement" + which,
            Say.number(view.expectedM(first)),
            Say.number(Math.abs(off)),
            off > 0 ? "long" : "short",
            Say.number(scatter));
    String more = wrong.size() == 1 ? "" : "; " + (wrong.size() - 1) + " more are as plainly off";
    return new AuditFinding(
        AuditCheck.PLACED,
        File.READINGS,
        what + more,
        view.inFile(wrong.stream().flatMap(one -> one.rows().stream()).mapToInt(Integer::intValue)),
        "measure there again: the tape, what stood before the sensor, or something nearer",
        "",
        Severity.NOTE);
  }
}
