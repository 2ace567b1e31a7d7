package simbad.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;

class CommandReachTest {
  @Test
  void reach_isTheGreatestSizeOfAllRuns() {
    MotionRun slow = new MotionRun("a", List.of(new Command(0, 0.1, -1.5)), List.of());
    MotionRun back = new MotionRun("b", List.of(new Command(0, -0.3, 1)), List.of());
    assertEquals(new CommandReach(0.3, 1.5), CommandReach.of(List.of(slow, back)));
    assertEquals(new CommandReach(0, 0), CommandReach.of(List.of()));
  }

  @Test
  void beyond_isWhatIsLargerInEither() {
    CommandReach reach = new CommandReach(0.3, 1.5);
    assertTrue(reach.holds(0.3 + 1e-9, 1.5));
    assertFalse(reach.holds(0.31, 1));
    assertFalse(reach.holds(0.1, 1.6));
    assertTrue(CommandReach.ANY.holds(1e9, 1e9));
  }

  @Test
  void sizes_areChecked() {
    assertThrows(IllegalArgumentException.class, () -> new CommandReach(-1, 0));
    assertThrows(IllegalArgumentException.class, () -> new CommandReach(0, Double.NaN));
  }
}
