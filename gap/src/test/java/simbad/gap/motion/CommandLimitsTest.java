package simbad.gap.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import simbad.gap.audit.AuditCheck;
import simbad.gap.audit.AuditFinding;
import simbad.gap.audit.Severity;
import simbad.motion.Command;
import simbad.motion.format.MotionRow;

/** Commands that no robot follows: 20 m/s and 60 rad/s are the most. */
class CommandLimitsTest {
  /** Ten commands that move it and two that do not, some of which are said. */
  private static List<MotionRow<Command>> rows(int from, Command... said) {
    List<MotionRow<Command>> rows = new ArrayList<>();
    for (Command one : said) {
      rows.add(new MotionRow<>(from + rows.size(), one));
    }
    while (rows.size() < 10) {
      rows.add(new MotionRow<>(from + rows.size(), new Command(rows.size(), -0.1, 0.1)));
    }
    rows.add(new MotionRow<>(from + 10, new Command(10, 0, 0)));
    rows.add(new MotionRow<>(from + 11, new Command(11, 0, 0)));
    return rows;
  }

  private static List<AuditFinding> findings(Command... said) {
    return CommandCheck.of(Map.of("a", rows(0, said)));
  }

  @Test
  void whatARobotMayDoIsNoFinding() {
    assertEquals(List.of(), findings(new Command(0, 20, -60), new Command(1, -20, 60)));
  }

  /** One of ten that move it is a slip, two are a unit. */
  @Test
  void aTenthIsASlip_andMoreAWrongUnit() {
    AuditFinding slip = findings(new Command(0, 25, 0)).get(0);
    AuditFinding unit = findings(new Command(0, 25, 0), new Command(1, -150, 0)).get(0);

    assertEquals(Severity.WARN, slip.severity());
    assertEquals("up to 25.00 m/s is commanded, which no such robot does", slip.what());
    assertEquals("leave these rows out", slip.suggestion());
    assertEquals(Severity.REFUSE, unit.severity());
    assertEquals(
        "up to 150.0 m/s is commanded, which no such robot does: speeds look like millimetres",
        unit.what());
    assertTrue(unit.suggestion().startsWith("write metres and radians"), unit.suggestion());
    assertEquals(AuditCheck.COMMAND_UNIT, unit.check());
    assertEquals(List.of(0, 1), unit.rows());
  }

  @Test
  void turnsAreLookedAtByThemselves() {
    List<AuditFinding> found = findings(new Command(0, 25, -61), new Command(1, 0, 90));

    assertEquals(2, found.size());
    assertEquals(List.of(0), found.get(0).rows());
    assertEquals(List.of(0, 1), found.get(1).rows());
    assertTrue(found.get(1).what().startsWith("up to 90.00 rad/s"), found.get(1).what());
    assertTrue(found.get(1).what().endsWith("turns look like degrees"), found.get(1).what());
  }

  /** All runs together, in the order of rows; at most a thousand are listed. */
  @Test
  void runsAreLookedAtTogether() {
    Map<String, List<MotionRow<Command>>> two = new TreeMap<>();
    two.put("a", rows(100, new Command(0, 30, 0)));
    two.put("b", rows(0, new Command(0, 40, 0)));
    AuditFinding found = CommandCheck.of(two).get(0);
    assertEquals(List.of(0, 100), found.rows());
    assertEquals(Severity.WARN, found.severity());

    List<MotionRow<Command>> many =
        IntStream.range(0, 1200).mapToObj(i -> new MotionRow<>(i, new Command(i, 99, 0))).toList();
    assertEquals(1000, CommandCheck.of(Map.of("a", many)).get(0).rows().size());
  }
}
