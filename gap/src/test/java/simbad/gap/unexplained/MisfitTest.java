package simbad.gap.unexplained;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import simbad.definition.Effect;
import simbad.gap.diagnosis.Interval;
import simbad.gap.fit.CalibratedLog;
import simbad.gap.fit.Hypothesis;
import simbad.gap.fixture.Worlds;
import simbad.gap.score.Blocks;
import simbad.gap.score.GapGain;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.ReadingRow;

class MisfitTest {
  private static CalibratedLog drawn(Hypothesis truth, long seed) {
    return Worlds.given(Worlds.read(Worlds.poses(2000, 0.3, 2.2, seed), truth, seed + 1));
  }

  private static double top(CalibratedLog given, Hypothesis hypothesis) {
    return Misfit.of(given, hypothesis).top(5);
  }

  /** The greatest of some hundred standard normal numbers, five ways apart. */
  @Test
  void rightModel_isOffByChance() {
    for (long seed = 1; seed <= 5; seed++) {
      double top = top(drawn(Hypothesis.NONE, seed), Hypothesis.NONE);
      assertTrue(top > 1.5 && top < 3.9, "top " + top);
    }
  }

  @Test
  void rightModelWithMemory_isOffByChance() {
    Hypothesis bursts = Worlds.effect(Effect.DROPOUT, "bursts", 0.3, 12);
    for (long seed = 1; seed <= 3; seed++) {
      double top = top(drawn(bursts, seed), bursts);
      assertTrue(top > 1.5 && top < 4.1, "top " + top);
    }
  }

  @Test
  void wrongModel_isOff() {
    Hypothesis gain = Worlds.effect(Effect.GAIN, "factor", 0.8);
    assertTrue(top(drawn(gain, 7), Hypothesis.NONE) > 6);
    assertTrue(top(drawn(gain, 7), gain) < 4);
  }

  /** Silence where echoes are expected is off by the share of echoes that were expected. */
  @Test
  void sizeOfAMisfit_isTheShareThatIsOff() {
    List<ReadingRow> silent =
        Worlds.poses(500, 0.3, 2.2, 9).stream().map(MisfitTest::silent).toList();
    List<Misfit.Off> echoes =
        Misfit.of(Worlds.given(silent), Hypothesis.NONE).slices().stream()
            .filter(slice -> slice.kind() == Misfit.Kind.ECHO)
            .toList();
    assertTrue(echoes.stream().allMatch(slice -> slice.z() < 0 && slice.size() < 0));
    // Up to the threshold of 1.5 m all but what an edge of 5 cm lets go, and 2 % that are lost.
    double all = echoes.stream().mapToDouble(Misfit.Off::size).min().orElseThrow();
    assertEquals(-0.98, all, 0.02);
    double some =
        echoes.stream()
            .filter(slice -> slice.slice().axis().variable().equals("sensor"))
            .mapToDouble(Misfit.Off::size)
            .findFirst()
            .orElseThrow();
    assertEquals(-0.98 * 1.2 / 1.9, some, 0.06);
  }

  /** Bursts learn ping by ping that it is silent far off; where no reading is known they cannot. */
  @Test
  void memoryThatSoaksUpSomethingElse_isSeenAhead() {
    List<ReadingRow> rows =
        Worlds.read(Worlds.poses(2000, 0.3, 2.2, 9), Hypothesis.NONE, 10).stream()
            .map(row -> row.pose().position().xM() > 0.6 ? silent(row) : row)
            .toList();
    CalibratedLog given = Worlds.given(rows);
    Hypothesis bursts = Worlds.effect(Effect.DROPOUT, "bursts", 0.3, 10);
    Misfit misfit = Misfit.of(given, bursts);
    Misfit.Off worst =
        misfit.slices().stream()
            .filter(slice -> slice.kind() == Misfit.Kind.FORECAST)
            .findFirst()
            .orElseThrow();
    assertTrue(Math.abs(worst.z()) > 5, worst::toString);
    assertTrue(misfit.slices().size() > 100);
    assertTrue(
        misfit.slices().stream()
            .anyMatch(slice -> slice.kind() == Misfit.Kind.FORECAST && slice.slice().from() == 0),
        "the first slice of a cut is one of them");
  }

  private static ReadingRow silent(ReadingRow row) {
    return new ReadingRow(row.run(), row.sensor(), row.timeS(), row.pose(), NoEcho.NO_ECHO);
  }

  @Test
  void blocks_holdEveryPingOnceInHalves() {
    CalibratedLog given = drawn(Hypothesis.NONE, 11);
    Blocks blocks = new Blocks(given.log());
    assertEquals(12, blocks.count());
    for (int ping = 0; ping < given.log().size(); ping++) {
      assertEquals(blocks.half(0).holds(ping), !blocks.half(1).holds(ping));
    }
  }

  @Test
  void gain_isMeasuredOnRowsThatWereNotFitted() {
    Hypothesis offset = Worlds.effect(Effect.RANGE_OFFSET, "constant", 0.05);
    CalibratedLog given = drawn(offset, 13);
    Blocks blocks = new Blocks(given.log());
    GapGain gain = GapGain.of(given, blocks, offset);
    assertTrue(gain.afterM() < gain.beforeM() - 0.005, () -> "after " + gain.afterM());
    assertEquals(gain.afterM(), gain.floorM(), 0.1 * gain.afterM());
    assertEquals(1 - gain.afterM() / gain.beforeM(), gain.shrinkage(), 1e-12);
    Interval interval = gain.shrinkage95(blocks, 1);
    assertEquals(interval, gain.shrinkage95(blocks, 1), "same seed");
    assertTrue(interval.low() < gain.shrinkage() && gain.shrinkage() < interval.high());
  }

  @Test
  void shrinkage_ofAnotherLogLiesInTheInterval() {
    Hypothesis offset = Worlds.effect(Effect.RANGE_OFFSET, "constant", 0.03);
    List<GapGain> gains = new ArrayList<>();
    List<Interval> intervals = new ArrayList<>();
    for (int seed = 0; seed < 20; seed++) {
      CalibratedLog given = drawn(offset, 40 + seed);
      Blocks blocks = new Blocks(given.log());
      gains.add(GapGain.of(given, blocks, offset));
      intervals.add(gains.get(seed).shrinkage95(blocks, 1));
    }
    int held = 0;
    for (int i = 0; i < gains.size(); i++) {
      double next = gains.get((i + 1) % gains.size()).shrinkage();
      held += intervals.get(i).low() <= next && next <= intervals.get(i).high() ? 1 : 0;
    }
    // 17 or more of 20 where 19 of 20 are meant: 98 times of 100.
    assertTrue(held >= 17, "held " + held + " of 20: " + intervals);
    assertTrue(intervals.stream().allMatch(i -> i.high() - i.low() < 0.8), "says something");
  }

  @Test
  void shrinkage_withoutAnExplanationIsNone() {
    CalibratedLog given = drawn(Hypothesis.NONE, 14);
    Blocks blocks = new Blocks(given.log());
    GapGain gain = GapGain.of(given, blocks, Hypothesis.NONE);
    assertEquals(new Interval(0, 0), gain.shrinkage95(blocks, 1));
  }
}
