package simbad.gap.audit;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import simbad.gap.audit.AuditFinding.File;
import simbad.sonar.frame.Point;
import simbad.sonar.shape.Outline;

/** Poses in which no sensor can have been. */
final class PoseCheck {
  private static final int LEAST_ROWS = 10;

  private final AuditView view;
  private final List<AuditFinding> found = new ArrayList<>();

  private PoseCheck(AuditView view) {
    this.view = view;
  }

  static List<AuditFinding> of(AuditView view) {
    PoseCheck check = new PoseCheck(view);
    check.inside();
    check.still();
    return check.found;
  }

  private void inside() {
    int[] inside = IntStream.range(0, view.size()).filter(this::isInside).toArray();
    if (inside.length > 0) {
      add(
          AuditCheck.INSIDE,
          Say.rows(inside.length) + " with the sensor inside an obstacle's outline",
          inside,
          "look at x_m and z_m, and at where the scene has its obstacles",
          2 * inside.length > view.size() ? Severity.REFUSE : Severity.WARN);
    }
  }

  private boolean isInside(int i) {
    Point place = view.row(i).pose().position();
    return view.outlines().stream().anyMatch(outline -> holds(outline, place));
  }

  /** Crossings of a ray with the outline: odd inside (Shimrat 1962). */
  private static boolean holds(Outline outline, Point place) {
    boolean inside = false;
    int from = outline.size() - 1;
    for (int to = 0; to < outline.size(); to++) {
      double z0 = outline.zM(from);
      double z1 = outline.zM(to);
      if (z0 > place.zM() != z1 > place.zM()) {
        double share = (place.zM() - z0) / (z1 - z0);
        double x = outline.xM(from) + share * (outline.xM(to) - outline.xM(from));
        inside ^= place.xM() < x;
      }
      from = to;
    }
    return inside;
  }

  private void still() {
    long poses =
        IntStream.range(0, view.size()).mapToObj(i -> view.row(i).pose()).distinct().count();
    double[] ranges = view.echoes().mapToDouble(view::rangeM).sorted().toArray();
    if (poses != 1 || ranges.length < LEAST_ROWS) {
      return;
    }
    double middle = ranges[3 * ranges.length / 4] - ranges[ranges.length / 4];
    boolean moves = middle > view.scatterM();
    add(
        AuditCheck.STILL,
        "one pose in all rows"
            + (moves ? ", though readings differ by " + Say.number(middle) + " m" : ""),
        new int[0],
        moves
            ? "write where the sensor was for each reading"
            : "readings from one pose can hardly tell effects apart",
        moves ? Severity.WARN : Severity.NOTE);
  }

  private void add(
      AuditCheck check, String what, int[] rows, String suggestion, Severity severity) {
    found.add(
        new AuditFinding(
            check, File.READINGS, what, view.inFile(IntStream.of(rows)), suggestion, "", severity));
  }
}
