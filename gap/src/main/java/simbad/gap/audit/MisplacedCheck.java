package simbad.gap.audit;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import simbad.gap.audit.AuditFinding.File;
import simbad.gap.fit.Robust;
import simbad.sonar.frame.Angles;
import simbad.sonar.frame.Pose;
import simbad.sonar.sensing.ReadingRow;

/**
 * Along a tape, a placement all of whose readings are off the line of the others by one amount,
 * while the placements beside it are not: a tape that was misread, or a target that was bumped.
 */
final class MisplacedCheck {
  /** A hand and a tape are off by less. */
  private static final double LEAST_M = AuditView.PLACE_M;

  /** In standard deviations of what placements are off by, from the median of all. */
  private static final double DEVIATIONS = 6;

  private static final int LEAST_PLACEMENTS = 6;

  private static final double MOST_SHARE = 0.1;

  /** Echoes of one placement: of two nobody knows which one is wrong. */
  private static final int LEAST_ROWS = 3;

  /** Of the echoes of a placement, so many agree. */
  private static final double AGREE = 2.0 / 3;

  /** So far off the tape a sensor may stand or look. */
  private static final double ASIDE_M = 0.05;

  private static final double ASIDE_RAD = Math.toRadians(3);

  private final AuditView view;
  private final Rest rest;

  MisplacedCheck(AuditView view, Rest rest) {
    this.view = view;
    this.rest = rest;
  }

  /** A placement, and what its echoes are off by in the middle. */
  private record Place(String label, double expectedM, List<Integer> rows, double offM) {}

  List<AuditFinding> find() {
    List<Place> places = isOneLine() ? places() : List.of();
    if (places.size() < LEAST_PLACEMENTS) {
      return List.of();
    }
    double middle = Robust.median(places.stream().mapToDouble(Place::offM).toArray());
    double between =
        Robust.NORMAL_OVER_MAD
            * Robust.median(
                places.stream().mapToDouble(place -> Math.abs(place.offM - middle)).toArray());
    double pose = view.setup().details().poseSigmaM();
    double limit = Math.max(LEAST_M, DEVIATIONS * Math.max(between, pose));
    int[] side =
        places.stream().mapToInt(place -> side(place, place.offM - middle, limit)).toArray();
    List<AuditFinding> found = new ArrayList<>();
    for (int i = 0; i < side.length; i++) {
      boolean withNext = i + 1 < side.length && side[i + 1] != 0;
      boolean withBefore = i > 0 && side[i - 1] != 0;
      if (side[i] != 0 && !withNext && !withBefore) {
        found.add(finding(places.get(i), places.get(i).offM - middle));
      }
    }
    // What is off here and there is no slip of a hand.
    return found.size() <= Math.max(1, MOST_SHARE * places.size()) ? found : List.of();
  }

  /** To which side a placement is off by more than a limit: -1, 0 or 1. */
  private int side(Place place, double awayM, double limitM) {
    long agreeing =
        place.rows.stream()
            .filter(row -> Math.abs(rest.offM(row) - place.offM) < LEAST_M / 2)
            .count();
    return Math.abs(awayM) > limitM && agreeing >= AGREE * place.rows.size()
        ? (int) Math.signum(awayM)
        : 0;
  }

  /** Whether the sensor stands on one line and looks along it, as on a tape. */
  private boolean isOneLine() {
    Pose first = view.row(0).pose();
    double cos = Math.cos(first.heading().radians());
    double sin = Math.sin(first.heading().radians());
    return IntStream.range(0, view.size())
        .mapToObj(i -> view.row(i).pose())
        .allMatch(
            pose -> {
              double x = pose.position().xM() - first.position().xM();
              double z = pose.position().zM() - first.position().zM();
              double turned = Angles.signed(pose.heading().radians() - first.heading().radians());
              return Math.abs(x * sin + z * cos) < ASIDE_M && Math.abs(turned) < ASIDE_RAD;
            });
  }

  /** By distance; those with enough echoes. */
  private List<Place> places() {
    Map<String, List<Integer>> rows =
        view.echoes()
            .filter(rest::isKnown)
            .boxed()
            .collect(Collectors.groupingBy(this::key, TreeMap::new, Collectors.toList()));
    return rows.values().stream()
        .filter(own -> own.size() >= LEAST_ROWS)
        .map(this::place)
        .sorted(Comparator.comparingDouble(Place::expectedM).thenComparing(Place::label))
        .toList();
  }

  private Place place(List<Integer> rows) {
    double[] off = rows.stream().mapToDouble(rest::offM).toArray();
    double[] expected = rows.stream().mapToDouble(view::expectedM).toArray();
    String label = view.row(rows.get(0)).circumstances().placement().orElse("");
    return new Place(label, Robust.median(expected), rows, Robust.median(off));
  }

  /** Readings of one placement, or of one run at equal poses. */
  private String key(int row) {
    ReadingRow of = view.row(row);
    return of.circumstances().placement().orElse(of.run() + "\n" + of.pose());
  }

  private AuditFinding finding(Place place, double awayM) {
    String name = place.label.isEmpty() ? "the placement" : "placement " + place.label;
    return new AuditFinding(
        AuditCheck.MISPLACED,
        File.READINGS,
        String.format(
            Locale.ROOT,
            "all readings of %s, at %s m, are %.1f cm too %s, and those beside it are not",
            name,
            Say.number(place.expectedM),
            100 * Math.abs(awayM),
            awayM > 0 ? "long" : "short"),
        view.inFile(place.rows.stream().mapToInt(Integer::intValue)),
        "measure again there; these rows are left out of all that follows",
        "",
        Severity.WARN);
  }
}
