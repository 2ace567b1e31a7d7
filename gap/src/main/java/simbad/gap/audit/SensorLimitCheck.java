package simbad.gap.audit;

import java.util.List;
import java.util.Optional;
import java.util.function.DoublePredicate;
import java.util.stream.IntStream;
import simbad.gap.audit.AuditFinding.File;

/** Ranges beyond the longest that the sensor measures. */
final class SensorLimitCheck {
  private final AuditView view;

  SensorLimitCheck(AuditView view) {
    this.view = view;
  }

  /**
   * What is beyond all that a wrong constant could make of a range cannot be a reading, and where
   * most are so, none is to be believed; what is beyond the sensor's reach is one of another sensor
   * than the scene's.
   */
  Optional<AuditFinding> find() {
    double most =
        Math.min(ConstantCheck.FACTOR * view.sensor().maxRangeM(), ConstantCheck.FURTHEST_M);
    Optional<AuditFinding> impossible =
        found(range -> range > most, "which no sonar reads", Severity.REFUSE);
    return impossible.isPresent()
        ? impossible
        : found(range -> range > limitM(view), "more than its reach", Severity.WARN);
  }

  /** As far as a reading may be in air of any temperature. */
  static double limitM(AuditView view) {
    return view.sensor().maxRangeM() * (1 + AuditView.AIR) + view.scatterM();
  }

  private Optional<AuditFinding> found(DoublePredicate isBeyond, String words, Severity severity) {
    int[] beyond = view.echoes().filter(i -> isBeyond.test(view.rangeM(i))).toArray();
    if (beyond.length == 0) {
      return Optional.empty();
    }
    double[] ranges = IntStream.of(beyond).mapToDouble(view::rangeM).sorted().distinct().toArray();
    String most = Say.number(ranges[ranges.length - 1]);
    boolean isOne = ranges.length == 1;
    boolean isMost = 2 * beyond.length > view.echoes().toArray().length;
    List<Integer> rows = view.inFile(IntStream.of(beyond));
    return Optional.of(
        new AuditFinding(
            AuditCheck.RANGE_LIMIT,
            File.READINGS,
            Say.readings(beyond.length)
                + (isOne ? " of " : " of up to ")
                + most
                + " m before max_range_m = "
                + Say.number(view.sensor().maxRangeM())
                + ", "
                + words,
            rows,
            "leave range_m empty where there was no echo, or write metres",
            isMost ? "" : mend(ranges),
            isMost ? severity : Severity.WARN));
  }

  /** Nothing mends most of the readings but what is known of their unit. */
  private String mend(double[] ranges) {
    return ranges.length == 1
        ? "--no-echo " + Say.exact(ranges[0])
        : "--no-echo-above " + Say.exact(view.sensor().maxRangeM());
  }
}
