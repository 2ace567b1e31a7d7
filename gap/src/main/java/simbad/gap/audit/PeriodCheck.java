package simbad.gap.audit;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import simbad.gap.audit.AuditFinding.File;
import simbad.gap.fit.Robust;

/** Clocks that do not tick as the sensor does: of a regular one the median step. */
final class PeriodCheck {
  private static final int LEAST_ROWS = 20;

  /** Of a clock that is regular: the middle half of its steps, over their median. */
  private static final double REGULAR = 0.25;

  /** Milliseconds, microseconds. */
  private static final double[] PER_SECOND = {1e3, 1e6};

  /** A clock in another unit is so near to the sensor's period, as a factor. */
  private static final double UNIT = 1.5;

  /** From a whole multiple of the sensor's period: sensors take turns. */
  private static final double SAME = 0.25;

  private final double periodS;
  private final double medianS;
  private final boolean isRegular;

  PeriodCheck(AuditView view) {
    double[] steps =
        IntStream.range(1, view.size())
            .filter(view::follows)
            .mapToDouble(i -> view.row(i).timeS() - view.row(i - 1).timeS())
            .filter(step -> step > 0)
            .sorted()
            .toArray();
    periodS = view.sensor().updatePeriodS();
    medianS = Robust.median(steps);
    isRegular =
        steps.length >= LEAST_ROWS
            && steps[3 * steps.length / 4] - steps[steps.length / 4] <= REGULAR * medianS;
  }

  Optional<AuditFinding> find() {
    if (!isRegular) {
      return Optional.empty();
    }
    double times = medianS / periodS;
    for (double unit : PER_SECOND) {
      if (times > unit / UNIT && times < unit * UNIT) {
        return Optional.of(
            finding(
                ": t_s is not in seconds",
                "divide t_s by " + Say.number(unit),
                "--time-scale " + Say.number(1 / unit),
                Severity.WARN));
      }
    }
    double nearest = Math.max(1, Math.rint(times));
    return Math.abs(times - nearest) > SAME ? Optional.of(stated()) : Optional.empty();
  }

  /** The clock may well be right: what the scene says of the period is looked at first. */
  private AuditFinding stated() {
    String what =
        "update_period_s = "
            + Say.number(periodS)
            + ", but rows of a sensor are "
            + Say.number(medianS)
            + " s apart";
    return new AuditFinding(
        AuditCheck.PERIOD,
        File.SCENE,
        what,
        List.of(),
        "say in the scene how often it pings",
        "",
        Severity.NOTE);
  }

  private AuditFinding finding(String more, String suggestion, String mend, Severity severity) {
    String what =
        "rows of a sensor are "
            + Say.number(medianS)
            + " s apart, where update_period_s = "
            + Say.number(periodS)
            + more;
    return new AuditFinding(
        AuditCheck.PERIOD, File.READINGS, what, List.of(), suggestion, mend, severity);
  }
}
