package simbad.gap.audit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import simbad.gap.fixture.Logs;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.sensing.ReadingRow;

/** The faults that people's logs have, in a ladder and in a drive: found, and nothing else. */
class PostedFaultTest {
  private static List<AuditCheck> warnings(SensingSetup setup, List<ReadingRow> rows) {
    return Audit.of(setup, rows).stream()
        .filter(one -> one.severity() != Severity.NOTE)
        .map(AuditFinding::check)
        .toList();
  }

  private static void assertFound(PostedFault fault, SensingSetup setup, List<ReadingRow> rows) {
    List<ReadingRow> spoilt = fault.spoil().spoil(rows, setup.sensor(), new SplittableRandom(1));
    List<AuditCheck> warnings = warnings(setup, spoilt);
    assertTrue(warnings.contains(fault.check()), fault.name() + ": " + warnings);
  }

  static Stream<PostedFault> inLadders() {
    // With the last value at the end of the tape only, it is stuck as well as held.
    return PostedFault.all().stream().filter(fault -> fault.check() != AuditCheck.HELD);
  }

  @ParameterizedTest
  @MethodSource("inLadders")
  void ladder_isFoundOut(PostedFault fault) {
    assertFound(fault, Logs.BOARD, Logs.ladder(16, 1));
  }

  static Stream<PostedFault> inDrives() {
    return PostedFault.all().stream();
  }

  @ParameterizedTest
  @MethodSource("inDrives")
  void drive_isFoundOut(PostedFault fault) {
    assertFound(fault, Logs.ROOM, Logs.drive(900, 1));
  }

  /** What is right is not warned of: thirty logs of either sort. */
  @Test
  void rightOnes_areNotWarnedOf() {
    for (int seed = 0; seed < 30; seed++) {
      assertEquals(List.of(), warnings(Logs.BOARD, Logs.ladder(16, seed)), "ladder " + seed);
      assertEquals(List.of(), warnings(Logs.ROOM, Logs.drive(500, seed)), "drive " + seed);
    }
  }

  /** Two columns, a few rows: the factor is found all the same. */
  @Test
  void shortLadders_areEnoughForFactors() {
    List<ReadingRow> rows = Logs.ladder(1, 3);
    Stream<PostedFault> units =
        PostedFault.all().stream().filter(fault -> fault.check() == AuditCheck.UNIT);
    units.forEach(fault -> assertFound(fault, Logs.BOARD, rows));
    assertEquals(16, IntStream.range(0, rows.size()).count(), "a ladder of sixteen");
  }
}
