package simbad.gap.fit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.Test;
import simbad.gap.fixture.Worlds;
import simbad.sonar.frame.Pose;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.ReadingRow;

class CalibratedLogTest {
  private static double[] silence(List<Double> distancesM) {
    List<ReadingRow> rows = new ArrayList<>();
    for (double distanceM : distancesM) {
      Pose facing = Pose.of(0, distanceM, Math.PI / 2);
      rows.add(new ReadingRow("r", "s", 0.05 * rows.size(), facing, NoEcho.NO_ECHO));
    }
    return Worlds.given(rows).logLikelihood(Hypothesis.NONE);
  }

  /**
   * Near the post silence is a miss, 0.02, at its threshold of 1.5 m a toss, far away certain; by a
   * thousandth it is anything.
   */
  @Test
  void silence_isWorthWhatItsPlaceSays() {
    List<Double> distances = new ArrayList<>(List.of(0.5, 1.5, 1.5, 3.0, 0.5));
    double[] found = silence(distances);
    assertEquals(Math.log(0.02), found[0], 0.05);
    assertEquals(Math.log(1 - 0.98 / 2), found[1], 0.01);
    assertEquals(found[1], found[2]);
    assertEquals(0, found[3], 0.002);
    assertEquals(found[0], found[4]);
    assertTrue(found[3] <= 0, "a probability");
    Collections.reverse(distances);
    double[] reversed = silence(distances);
    for (int i = 0; i < found.length; i++) {
      assertEquals(found[i], reversed[found.length - 1 - i]);
    }
  }
}
