package simbad.gap.score;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import simbad.definition.Effect;
import simbad.gap.diagnosis.BudgetEntry;
import simbad.gap.diagnosis.Interval;
import simbad.gap.fit.CalibratedLog;
import simbad.gap.fit.Hypothesis;
import simbad.gap.fixture.Worlds;
import simbad.sonar.frame.Pose;
import simbad.sonar.ping.PingLog;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.ReadingRow;

/** Gaps by hand, of two runs that are a block each, and gaps that were measured. */
class GapGainTest {
  private static final int EACH = 30;
  private static final Hypothesis OFFSET = Worlds.effect(Effect.RANGE_OFFSET, "constant", 0.02);

  private static PingLog twoRuns() {
    List<ReadingRow> rows = new ArrayList<>();
    for (int i = 0; i < 2 * EACH; i++) {
      String run = i < EACH ? "a" : "b";
      Pose pose = Pose.of(0.01 * i, 1, 0);
      rows.add(new ReadingRow(run, "s", 0.1 * (i % EACH), pose, NoEcho.NO_ECHO));
    }
    return new PingLog(rows);
  }

  /** The same gap at all pings of a run, and the same expectation everywhere. */
  private static GapMeter.Gaps gaps(double first, double second, double expected) {
    double[] observed = new double[2 * EACH];
    Arrays.setAll(observed, i -> i < EACH ? first : second);
    double[] own = new double[2 * EACH];
    Arrays.fill(own, expected);
    return new GapMeter.Gaps(observed, own);
  }

  private static Interval shrinkage95(GapMeter.Gaps before, GapMeter.Gaps after) {
    Blocks blocks = new Blocks(twoRuns());
    assertEquals(2, blocks.count());
    return new GapGain(before, after).shrinkage95(blocks, 5);
  }

  @Test
  void gain_isOfTheMeans() {
    GapGain gain = new GapGain(gaps(1, 3, 0.5), gaps(0.5, 1.5, 0.3));
    assertEquals(2, gain.beforeM(), 1e-12);
    assertEquals(1, gain.afterM(), 1e-12);
    assertEquals(0.3, gain.floorM(), 1e-12);
    assertEquals(0.5, gain.shrinkage(), 1e-12);
    GapGain none = new GapGain(gaps(0, 0, 0.5), gaps(0, 0, 0.3));
    assertEquals(0, none.shrinkage(), "there is no gap before");
    assertEquals(0, none.floorM(), "nothing is left to be scatter");
    GapMeter.Gaps empty = new GapMeter.Gaps(new double[0], new double[0]);
    assertEquals(0, new GapGain(empty, empty).beforeM());
  }

  @Test
  void worthNaming_isAHundredth() {
    assertTrue(new GapGain(gaps(1, 1, 0), gaps(0.98, 0.99, 0)).isWorthNaming());
    assertFalse(new GapGain(gaps(1, 1, 0), gaps(0.99, 0.995, 0)).isWorthNaming());
  }

  /** Twice what is expected of the set-up, moved or not, and of the fit to all rows. */
  @Test
  void much_isMoreThanTwiceTheScatter() {
    GapMeter.Gaps much = gaps(0.21, 0.21, 0.1);
    GapMeter.Gaps little = gaps(0.19, 0.19, 0.1);
    assertTrue(new GapGain(much, much).leavesMuch());
    assertFalse(new GapGain(much, little).leavesMuch());
    assertFalse(new GapGain(much, much, much, little).leavesMuch(), "half of the places is few");
    assertFalse(new GapGain(much, much, little, much).leavesMuch(), "a set-up takes it up");
    assertTrue(new GapGain(much, little).isManyFloors());
    assertFalse(new GapGain(little, little).isManyFloors());
    GapGain beside = new GapGain(much, much).beside(little);
    assertSame(little, beside.open());
    assertSame(much, beside.after());
    assertSame(much, beside.fitted());
  }

  /** Where both blocks shrink by as much another log does so too. */
  @Test
  void blocksThatAgree_leaveNothingOpen() {
    Interval same = shrinkage95(gaps(1, 3, 0), gaps(0.25, 0.75, 0));
    assertEquals(0.75, same.low(), 1e-12);
    assertEquals(0.75, same.high(), 1e-12);
    Interval gone = shrinkage95(gaps(1, 3, 0), gaps(0, 0, 0));
    assertEquals(new Interval(1, 1), gone);
    Interval none = shrinkage95(gaps(0, 0, 0), gaps(0, 0, 0));
    assertEquals(new Interval(0, 0), none);
  }

  /**
   * Of one block half is left, of the other all: of both 0.75. Either is drawn twice once in four
   * times, so that its end is that of 95 %; by root 2 and more it is wider for another log.
   */
  @Test
  void blocksThatPart_openTheInterval() {
    Interval open = shrinkage95(gaps(1, 1, 0), gaps(0.5, 1, 0));
    assertEquals(1 - 0.75 * Math.pow(1 / 0.75, 2.1), open.low(), 1e-9);
    assertEquals(1 - 0.75 * Math.pow(0.5 / 0.75, 2.1), open.high(), 1e-9);
  }

  // ---------------------------------------------------------------- budget

  /** An effect's share is what it takes away, the rest what is left beyond the floor. */
  @Test
  void budget_isOfTheMeans_withBlocksForItsIntervals() {
    CalibratedLog given = new CalibratedLog(Worlds.POST, List.of(), twoRuns());
    GapGain gain = new GapGain(gaps(1, 3, 0), gaps(0.5, 0.7, 0.2));
    List<BudgetEntry> budget = Budget.of(given, new Blocks(given.log()), OFFSET, gain, 4);
    assertEquals(
        List.of("range-offset", BudgetEntry.REST, BudgetEntry.FLOOR),
        budget.stream().map(BudgetEntry::what).toList());
    assertEntry(140, 50, 230, budget.get(0));
    assertEntry(40, 30, 50, budget.get(1));
    assertEntry(20, 20, 20, budget.get(2));
  }

  private static void assertEntry(double cm, double low, double high, BudgetEntry entry) {
    assertEquals(cm, entry.cm(), 1e-9, entry.toString());
    assertEquals(low, entry.ci95().low(), 1e-9, entry.toString());
    assertEquals(high, entry.ci95().high(), 1e-9, entry.toString());
  }

  /** More cannot be expected than is left. */
  @Test
  void floor_isNoMoreThanWhatIsLeft() {
    CalibratedLog given = new CalibratedLog(Worlds.POST, List.of(), twoRuns());
    GapGain gain = new GapGain(gaps(1, 1, 0), gaps(0.5, 0.5, 0.9));
    List<BudgetEntry> budget = Budget.of(given, new Blocks(given.log()), OFFSET, gain, 4);
    assertEntry(50, 50, 50, budget.get(0));
    assertEntry(0, 0, 0, budget.get(1));
    assertEntry(50, 50, 50, budget.get(2));
  }

  // ---------------------------------------------------------------- halves

  /** Six blocks of 25 rows; every other one is off to the other side. */
  private static CalibratedLog parted(Hypothesis beside, double offM) {
    List<ReadingRow> poses = Worlds.poses(150, 0.3, 1.3, 5);
    List<List<ReadingRow>> read = new ArrayList<>();
    for (double offset : new double[] {offM, -offM}) {
      Hypothesis truth = beside.and(OFFSET.forms().get(0), offset);
      read.add(Worlds.read(poses, truth, 6));
    }
    return Worlds.given(
        IntStream.range(0, 150).mapToObj(i -> read.get(i / 25 % 2).get(i)).toList());
  }

  /** What was fitted on one half is off by 4 cm on the other instead of 2 cm. */
  @Test
  void halves_arePredictedByTheOtherHalf() {
    CalibratedLog given = parted(Hypothesis.NONE, 0.02);
    GapGain gain = GapGain.of(given, new Blocks(given.log()), OFFSET);
    assertEquals(0.02, gain.afterM() - gain.beforeM(), 0.002);
    assertTrue(gain.shrinkage() < 0);
  }

  @Test
  void nothing_changesNothing() {
    CalibratedLog given = parted(Hypothesis.NONE, 0.02);
    GapGain gain = GapGain.of(given, new Blocks(given.log()), Hypothesis.NONE);
    assertSame(gain.before(), gain.after());
  }

  /** Fitted on all rows the offset is nothing: two halves to either side. */
  @Test
  void fitted_isOfTheValuesAsTheyAre() {
    CalibratedLog given = parted(Hypothesis.NONE, 0.02);
    GapGain gain = GapGain.of(given, new Blocks(given.log()), OFFSET.with(0));
    assertArrayEquals(gain.before().observedM(), gain.fitted().observedM(), 1e-12);
    assertFalse(Arrays.equals(gain.before().observedM(), gain.after().observedM()));
  }

  /** In either order of putting it in, an offset that is wrong on the other half makes it worse. */
  @Test
  void budgetOfTwo_isOfTheOtherHalf() {
    Hypothesis dropout = Worlds.effect(Effect.DROPOUT, "single", 0.2);
    CalibratedLog given = parted(dropout, 0.01);
    Hypothesis both = dropout.and(OFFSET.forms().get(0), 0.01);
    Blocks blocks = new Blocks(given.log());
    List<BudgetEntry> budget = Budget.of(given, blocks, both, GapGain.of(given, blocks, both), 3);
    // 0.8 of 1 cm, less what hides in the scatter of 3 mm.
    assertEquals(-0.7, budget.get(1).cm(), 0.2, budget.toString());
  }

  @Test
  void gains_areMeasuredOnce() {
    CalibratedLog given = parted(Hypothesis.NONE, 0.02);
    GapGains gains = new GapGains(given);
    assertSame(given, gains.given());
    GapGain gain = gains.of(OFFSET);
    assertSame(gain, gains.of(OFFSET));
    assertEquals(gain.afterM(), GapGain.of(given, gains.blocks(), OFFSET).afterM(), 1e-12);
    assertEquals(6, gains.blocks().count());
  }
}
