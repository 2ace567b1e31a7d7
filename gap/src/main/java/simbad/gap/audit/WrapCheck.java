package simbad.gap.audit;

import java.util.Optional;
import java.util.stream.IntStream;
import simbad.gap.audit.AuditFinding.File;
import simbad.gap.fit.Robust;

/**
 * Whether ranges start again from 0: beyond the greatest of them the scene goes on, and every
 * reading lacks the same.
 */
final class WrapCheck {
  private static final int LEAST = 5;

  private final AuditView view;

  WrapCheck(AuditView view) {
    this.view = view;
  }

  Optional<AuditFinding> find() {
    double limit = SensorLimitCheck.limitM(view);
    double greatest =
        view.echoes().mapToDouble(view::rangeM).filter(range -> range <= limit).max().orElse(0);
    int[] beyond =
        view.echoes()
            .filter(view::isExpected)
            .filter(i -> view.expectedM(i) > greatest + view.toleranceM(greatest))
            .toArray();
    if (beyond.length < LEAST) {
      return Optional.empty();
    }
    double[] lacking = IntStream.of(beyond).mapToDouble(this::lackingM).toArray();
    double period = Robust.median(lacking);
    // A value that reads as it should lies below the end; the end is no further than the greatest.
    double slack = view.toleranceM(greatest);
    if (period < greatest - slack || period > 2 * greatest + slack) {
      return Optional.empty();
    }
    int[] hits = IntStream.of(beyond).filter(i -> isWrapped(i, period)).toArray();
    double chance = Math.min(1, 2 * slackM(greatest) / greatest);
    boolean shows =
        hits.length >= LEAST
            && varies(hits)
            && Tail.atLeast(hits.length, beyond.length, chance) < Tail.LEVEL;
    return shows ? Optional.of(finding(hits, period)) : Optional.empty();
  }

  private double lackingM(int i) {
    return view.expectedM(i) - view.rangeM(i);
  }

  private boolean isWrapped(int i, double period) {
    double off = Math.IEEEremainder(lackingM(i) - period, period);
    return Math.abs(off) <= slackM(view.expectedM(i));
  }

  /** Half of what a range may be off: the period was taken from the readings themselves. */
  private double slackM(double distance) {
    return view.toleranceM(distance) / 2;
  }

  /** With one distance only, any reading lacks the same. */
  private boolean varies(int[] hits) {
    double[] sorted = IntStream.of(hits).mapToDouble(view::expectedM).sorted().toArray();
    double spread = sorted[3 * sorted.length / 4] - sorted[sorted.length / 4];
    return spread > 2 * slackM(sorted[sorted.length / 2]);
  }

  private AuditFinding finding(int[] hits, double period) {
    return new AuditFinding(
        AuditCheck.WRAP,
        File.READINGS,
        Say.readings(hits.length)
            + " too short by the same "
            + Say.number(period)
            + " m, and none longer: ranges start again from 0 there",
        view.inFile(IntStream.of(hits)),
        "let the program count with more bits, or leave these rows out",
        "",
        Severity.WARN);
  }
}
