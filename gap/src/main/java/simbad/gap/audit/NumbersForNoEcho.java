package simbad.gap.audit;

import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.IntStream;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.ReadingRow;

/**
 * Readings of a number for "no echo" that is the very range which no echo counts as. They make no
 * gap, so that no effect can be named for them, and yet no other one explains them: they are to be
 * read as what they mean.
 */
public final class NumbersForNoEcho {
  /** Where a sensor has no steps, ranges are told apart by the millimetre. */
  private static final double SAME_M = 1e-3;

  private NumbersForNoEcho() {}

  /**
   * Returns such rows.
   *
   * @param setup as the simulator believes it
   * @param rows of the log, or of its reference
   * @param audit of the log
   * @param file which of the two these rows are
   * @return indices of rows; none where no such number was found, or where most of these pings
   *     should have an echo: what is lost there is a gap, which an effect has to explain
   */
  public static Set<Integer> rows(
      SensingSetup setup, List<ReadingRow> rows, List<AuditFinding> audit, AuditFinding.File file) {
    boolean found =
        audit.stream()
            .filter(finding -> finding.file() == file)
            .filter(finding -> finding.check() == AuditCheck.NO_ECHO_CODE)
            .flatMap(finding -> finding.rows().stream())
            .anyMatch(row -> isOne(setup, rows.get(row)));
    if (!found) {
      return Set.of();
    }
    AuditView view = new AuditView(setup, rows);
    Set<Integer> numbers = new TreeSet<>();
    IntStream.range(0, rows.size())
        .filter(row -> isOne(setup, rows.get(row)))
        .forEach(numbers::add);
    long expected =
        IntStream.range(0, view.size())
            .filter(view::isExpected)
            .filter(i -> numbers.contains(view.inFile(i)))
            .count();
    return 2 * expected < numbers.size() ? numbers : Set.of();
  }

  private static boolean isOne(SensingSetup setup, ReadingRow row) {
    double stepM = Math.max(SAME_M, setup.sensor().resolutionM());
    return row.reading() instanceof Echo echo && Math.abs(echo.rangeM() - setup.noEchoM()) < stepM;
  }
}
