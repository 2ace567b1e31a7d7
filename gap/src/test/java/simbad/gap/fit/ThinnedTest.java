package simbad.gap.fit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class ThinnedTest {
  private static final int PINGS = 3001;

  @Test
  void holdsOneOfEachGroup_theSameOnesAgain() {
    Thinned thinned = new Thinned(PINGS, 3);
    for (int first = 0; first < PINGS; first += 3) {
      int own = first;
      long held = IntStream.range(own, Math.min(PINGS, own + 3)).filter(thinned::holds).count();
      assertEquals(1, held, "of the group at " + own);
    }
    Thinned again = new Thinned(PINGS, 3);
    assertTrue(IntStream.range(0, PINGS).allMatch(i -> again.holds(i) == thinned.holds(i)));
  }

  /** Sensors that take turns, and directions that alternate, are all among them. */
  @Test
  void noPeriodOfALogIsLeftOut() {
    Thinned thinned = new Thinned(PINGS, 3);
    for (int period : new int[] {2, 3, 6, 8}) {
      for (int phase = 0; phase < period; phase++) {
        int own = phase;
        long held =
            IntStream.range(0, PINGS).filter(i -> i % period == own && thinned.holds(i)).count();
        double expected = PINGS / (3.0 * period);
        assertTrue(Math.abs(held - expected) < 5 * Math.sqrt(expected), period + ": " + held);
      }
    }
  }
}
