package simbad.gap.audit;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.IntStream;
import simbad.gap.audit.AuditFinding.File;
import simbad.gap.fit.Robust;

/**
 * Whether ranges are a multiple of what the scene says they must be. A line with an offset is laid
 * through the medians of all readings at a pose over the distance of what is expected to echo
 * there; its slope must exclude all that the air can do.
 */
final class UnitCheck {
  /** Beyond this, either way, a slope is no air: twice what temperature does to sound. */
  private static final double MOST = 1 + 2 * AuditView.AIR;

  private static final int LEAST_POINTS = 4;
  private static final int MOST_POINTS = 250;

  /** Of the points: with fewer on the line something else decides what is read. */
  private static final double LEAST_SHARE = 0.7;

  private final AuditView view;
  private final double[][] points;
  private final RobustLine fitted;

  UnitCheck(AuditView view) {
    this.view = view;
    points = points();
    fitted = RobustLine.through(points[0], points[1], view.noiseM(), Tail.LEVEL);
  }

  /** The line of ranges over distances, whatever it is. */
  RobustLine fitted() {
    return fitted;
  }

  /** The line of ranges over distances, where it is plainly not that of the scene. */
  Optional<RobustLine> line() {
    if (points[0].length < LEAST_POINTS) {
      return Optional.empty();
    }
    RobustLine line = fitted;
    boolean plain =
        line.share() >= LEAST_SHARE
            && line.slope() > 0
            && (line.slope() - line.halfWidth() > MOST
                || line.slope() + line.halfWidth() < 1 / MOST)
            && line.halfWidth() <= line.slope() * AuditView.AIR;
    return plain && isFactor(line) && bothHalves(points, line)
        ? Optional.of(line)
        : Optional.empty();
  }

  /** A factor that has no name begins at nought, as well as things are placed; a bend does not. */
  private static boolean isFactor(RobustLine line) {
    return Factor.of(line.slope()).isPresent()
        || Math.abs(line.offset()) <= AuditView.PLACE_M * Math.max(1, line.slope());
  }

  /** A scale is one near and far; a limit, a knee or a bump is not. */
  private static boolean bothHalves(double[][] points, RobustLine line) {
    int size = points[0].length;
    if (size < 2 * LEAST_POINTS) {
      return Factor.of(line.slope()).isPresent();
    }
    return isAlong(points, 0, size / 2, line) && isAlong(points, size - size / 2, size, line);
  }

  private static boolean isAlong(double[][] points, int from, int to, RobustLine line) {
    double slope =
        Robust.medianSlope(
            Arrays.copyOfRange(points[0], from, to), Arrays.copyOfRange(points[1], from, to), 0);
    double times = slope / line.slope();
    return times < MOST && times > 1 / MOST;
  }

  /** Distances and medians of what was read there, of as many poses as are worth the time. */
  private double[][] points() {
    Map<Double, List<Double>> byDistance = new TreeMap<>();
    view.echoes()
        .filter(view::isExpected)
        .filter(i -> view.rangeM(i) > 0 && !view.isEverywhere(i))
        .forEach(
            i ->
                byDistance
                    .computeIfAbsent(view.expectedM(i), d -> new ArrayList<>())
                    .add(view.rangeM(i)));
    List<Map.Entry<Double, List<Double>>> all = new ArrayList<>(byDistance.entrySet());
    int size = Math.min(MOST_POINTS, all.size());
    double[][] points = new double[2][size];
    for (int k = 0; k < size; k++) {
      var one = all.get((int) ((long) k * all.size() / size));
      points[0][k] = one.getKey();
      points[1][k] =
          Robust.median(one.getValue().stream().mapToDouble(Double::doubleValue).toArray());
    }
    return points;
  }

  AuditFinding finding(RobustLine line) {
    Optional<Factor> known = Factor.of(line.slope());
    double undo = known.map(Factor::undo).orElse(1 / line.slope());
    String what =
        "ranges are "
            + Say.number(line.slope())
            + " times what the scene says"
            + known.map(factor -> ": " + factor.words()).orElse("");
    return new AuditFinding(
        AuditCheck.UNIT,
        File.READINGS,
        what,
        view.inFile(IntStream.range(0, view.size()).filter(view::isEcho)),
        "multiply them by " + Say.number(undo) + ", or mend the constant that computes them",
        "--scale " + Say.number(undo),
        Factor.isBeyondSound(line.slope()) ? Severity.REFUSE : Severity.WARN);
  }
}
