package simbad.gap.locate;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.function.IntPredicate;
import org.junit.jupiter.api.Test;
import simbad.gap.diagnosis.GapKind;
import simbad.gap.fit.CalibratedLog;
import simbad.gap.fit.Hypothesis;
import simbad.gap.fixture.Worlds;
import simbad.gap.score.Blocks;
import simbad.sonar.frame.Pose;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.Reading;
import simbad.sonar.sensing.ReadingRow;

/** How sure an excess is, and of what kind it is: pings that look at a post from the front. */
class ConfirmationTest {
  private static CalibratedLog facing(double distanceM, Reading... readings) {
    List<ReadingRow> rows = new ArrayList<>();
    for (Reading reading : readings) {
      Pose pose = Pose.of(0, distanceM, Math.PI / 2);
      rows.add(new ReadingRow("r", "s", 0.05 * rows.size(), pose, reading));
    }
    return Worlds.given(rows);
  }

  private static Reading[] of(int silent, int echoes) {
    Reading[] readings = new Reading[silent + echoes];
    for (int i = 0; i < readings.length; i++) {
      readings[i] = i < silent ? NoEcho.NO_ECHO : new Echo(1);
    }
    return readings;
  }

  // ---------------------------------------------------------------- chance

  /** Ten places of ten readings: ten blocks, by where they were read. */
  private static double chance(double[] excess, IntPredicate holds) {
    List<ReadingRow> rows = new ArrayList<>();
    for (int i = 0; i < excess.length; i++) {
      Pose pose = Pose.of(0, 1 + i / 10, Math.PI / 2);
      rows.add(new ReadingRow("r", "s", 0.05 * i, pose, NoEcho.NO_ECHO));
    }
    Blocks blocks = new Blocks(Worlds.given(rows).log());
    assertEquals(10, blocks.count());
    return Confirmation.chance(excess, blocks, holds);
  }

  /** So much on the first so many pings of a block. */
  private static void put(double[] excess, int block, int pings, double each) {
    for (int i = 0; i < pings; i++) {
      excess[10 * block + i] = each;
    }
  }

  /** Four times 1 is a sum of 4 with a deviation of 2: beyond two deviations lie 2.275 %. */
  @Test
  void chance_isThatOfTheSumOverItsScatter() {
    double[] excess = new double[100];
    put(excess, 3, 4, 1);
    assertEquals(0.0227501319, chance(excess, i -> true), 1e-9);
    assertEquals(0.0227501319, chance(excess, i -> i / 10 == 3), 1e-9);
    put(excess, 3, 4, -1);
    assertEquals(1 - 0.0227501319, chance(excess, i -> true), 1e-9);
    put(excess, 3, 2, 1);
    assertEquals(0.5, chance(excess, i -> true), 1e-9, "1 + 1 - 1 - 1");
  }

  @Test
  void chance_isOne_whereNothingIsSeen() {
    double[] excess = new double[100];
    assertEquals(1, chance(excess, i -> true));
    put(excess, 3, 4, 1);
    assertEquals(1, chance(excess, i -> false));
    assertEquals(1, chance(excess, i -> i >= 40));
  }

  /** Blocks that all show the same do not clump: eight times 1 are 2.83 deviations. */
  @Test
  void blocksThatAgree_areAsManyIndependentPings() {
    double[] excess = new double[100];
    put(excess, 2, 4, 1);
    put(excess, 7, 4, 1);
    assertEquals(0.00233886749, chance(excess, i -> true), 1e-10);
  }

  /**
   * Sums of 12 and -4, squares of 36 and 4: off their shares of the total, 7.2 and 0.8, by 4.8
   * each. Twice 4.8^2 over 40, times 2 / 1, is 2.304: the total of 8 is 8 / sqrt(92.16) = 5/6
   * deviations.
   */
  @Test
  void blocksThatPart_clump() {
    double[] excess = new double[100];
    put(excess, 2, 4, 3);
    put(excess, 7, 4, -1);
    assertEquals(0.202328381, chance(excess, i -> true), 1e-9);
  }

  // ---------------------------------------------------------------- kinds

  private static GapKind kind(CalibratedLog given, double silent, double echo) {
    int size = given.log().size();
    double[] excess = new double[size];
    int[] pings = new int[size];
    for (int i = 0; i < size; i++) {
      pings[i] = i;
      excess[i] = given.log().echo(i) ? echo : silent;
    }
    return new Kinds(given.log(), given.forecast(given.model(Hypothesis.NONE)), excess).of(pings);
  }

  /** At 0.5 m an echo is expected for sure, but for 2 % of misses; at 3 m none. */
  @Test
  void kind_isWhatWasReadAgainstWhatWasExpected() {
    assertEquals(GapKind.MISSED_ECHO, kind(facing(0.5, of(5, 0)), 1, 0));
    assertEquals(GapKind.RANGE_ERROR, kind(facing(0.5, of(0, 5)), 0, 1));
    assertEquals(GapKind.PHANTOM_ECHO, kind(facing(3, of(0, 5)), 0, 1));
  }

  @Test
  void kind_isThatOfTheLargerExcess() {
    assertEquals(GapKind.MISSED_ECHO, kind(facing(0.5, of(5, 5)), 1, 0.5));
    assertEquals(GapKind.RANGE_ERROR, kind(facing(0.5, of(5, 5)), 0.5, 1));
  }

  /**
   * At the threshold 0.02 + 0.98 / 2 = 0.51 of ten are expected to be silent. Of six misses 0.9 are
   * too many; what 5.1 cost is given back to the four echoes: 0.49 (0.5 + 0.51) each is 1.98.
   */
  @Test
  void expectedMisses_areNotCounted() {
    assertEquals(GapKind.RANGE_ERROR, kind(facing(1.5, of(6, 4)), 1, 0.5));
    assertEquals(GapKind.MISSED_ECHO, kind(facing(1.5, of(9, 1)), 1, 0.5));
  }

  /** Five misses are as expected: for echoes 0.51 * 0.3 is less than 0.49 (0.3 + 0.51). */
  @Test
  void whatMissesCost_isGivenBackToEchoes() {
    assertEquals(GapKind.RANGE_ERROR, kind(facing(1.5, of(5, 5)), 1, 0.3));
    assertEquals(GapKind.PHANTOM_ECHO, kind(facing(1.5, of(0, 5)), 1, 0.3));
  }
}
