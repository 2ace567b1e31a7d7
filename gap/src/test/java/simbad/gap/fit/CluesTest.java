package simbad.gap.fit;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import simbad.gap.fixture.Worlds;
import simbad.sonar.frame.Pose;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.Reading;
import simbad.sonar.sensing.ReadingRow;

class CluesTest {
  private static final Pose FACING = Pose.of(1, 0, Math.PI);
  private static final Pose AWAY = Pose.of(1, 0, 0);

  private static ReadingRow row(String run, double timeS, Pose pose, Reading reading) {
    return new ReadingRow(run, "s", timeS, pose, reading);
  }

  private static final LogClues CLUES =
      new LogClues(
          Worlds.given(
              List.of(
                  row("a", 0.0, FACING, new Echo(0.95)),
                  row("a", 0.1, FACING, NoEcho.NO_ECHO),
                  row("a", 0.2, AWAY, new Echo(0.95)),
                  row("a", 0.3, AWAY, NoEcho.NO_ECHO),
                  row("a", 0.4, FACING, new Echo(2)),
                  row("b", 0.0, FACING, new Echo(0.95)))),
          Hypothesis.NONE);

  /** The post's face is at 0.95 m; nothing else is there. */
  @Test
  void eachPing_isWhatItSaw() {
    assertArrayEquals(new int[] {0, 1, 4, 5}, CLUES.inCone(0).toArray(), "post in the cone");
    assertArrayEquals(new int[] {0, 4, 5}, CLUES.echoesInCone().toArray(), "and an echo");
    assertArrayEquals(new int[] {2, 4}, CLUES.strangeEchoes().toArray(), "not the post's");
    assertEquals(0.95, CLUES.nearestM(0), 1e-9);
    assertEquals(Double.POSITIVE_INFINITY, CLUES.nearestM(2));
    assertArrayEquals(
        new double[] {0.95, 0.95, 0.95, 0.95}, CLUES.audibleM().toArray(), 1e-9, "within 1.5 m");
  }

  @Test
  void before_isTheReadingOfTheSameSequence() {
    assertFalse(CLUES.hasEchoBefore(0), "the first");
    assertTrue(CLUES.hasEchoBefore(1));
    assertFalse(CLUES.hasEchoBefore(2), "silence before");
    assertFalse(CLUES.hasEchoBefore(5), "of another run");
  }
}
