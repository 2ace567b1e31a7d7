package simbad.gap.search;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import simbad.definition.Effect;
import simbad.gap.calibrate.Calibration;
import simbad.gap.calibrate.SetupLeave;
import simbad.gap.fit.CalibratedLog;
import simbad.gap.fit.Fit;
import simbad.gap.fit.Fitter;
import simbad.gap.fit.Fold;
import simbad.gap.fit.Hypothesis;
import simbad.gap.fixture.LevelWorlds;
import simbad.gap.fixture.Worlds;
import simbad.gap.score.HeldOut.Scored;
import simbad.sonar.effect.Definitions;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;
import simbad.sonar.ping.PingLog;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.ReadingRow;

/** Searches among two or three effects, all others being excluded: each set is met. */
class FewEffectsTest {
  private static final double WORTH = 10;
  private static final Hypothesis OFFSET = Worlds.effect(Effect.RANGE_OFFSET, "constant", 0.05);
  private static final Hypothesis DROPOUT = Worlds.effect(Effect.DROPOUT, "single", 0.3);

  private static Set<Effect> allBut(Effect... some) {
    Set<Effect> others = new TreeSet<>(Definitions.effects());
    others.removeAll(List.of(some));
    return others;
  }

  private static Search search(CalibratedLog given, Effect... some) {
    return new Search(given, allBut(some), WORTH, Optional.empty());
  }

  private static CalibratedLog drawn(Hypothesis truth) {
    return Worlds.given(Worlds.read(Worlds.poses(200, 0.3, 1.3, 61), truth, 62));
  }

  private static Set<Set<Effect>> effects(List<Scored> sets) {
    Set<Set<Effect>> all = new HashSet<>();
    sets.forEach(set -> all.add(new TreeSet<>(set.hypothesis().effects())));
    assertEquals(sets.size(), all.size(), "each set once");
    return all;
  }

  private static Scored of(List<Scored> sets, Effect... effects) {
    return sets.stream()
        .filter(set -> Set.copyOf(set.hypothesis().effects()).equals(Set.of(effects)))
        .findFirst()
        .orElseThrow();
  }

  @Test
  void twoEffects_areFoundAloneAndTogether() {
    Hypothesis truth = OFFSET.and(DROPOUT.forms().get(0), 0.3);
    List<Scored> sets = search(drawn(truth), Effect.RANGE_OFFSET, Effect.DROPOUT).run();
    assertEquals(
        Set.of(
            Set.of(),
            Set.of(Effect.RANGE_OFFSET),
            Set.of(Effect.DROPOUT),
            Set.of(Effect.RANGE_OFFSET, Effect.DROPOUT)),
        effects(sets));
    assertEquals(2, sets.get(0).hypothesis().forms().size());
    assertEquals(
        sets, sets.stream().sorted(Comparator.comparingDouble(one -> -one.heldOut())).toList());
    Hypothesis best = sets.get(0).hypothesis();
    int shift = best.effects().indexOf(Effect.RANGE_OFFSET);
    // Some 130 echoes that scatter by 6 mm, and 0.3 of 200.
    assertEquals(0.05, best.valuesOf(shift)[0], 0.002);
    assertEquals(0.3, best.valuesOf(1 - shift)[0], 0.13);
  }

  /** Each set's score is that of the values that it has. */
  @Test
  void inSample_isTheLikelihoodOfTheValues() {
    CalibratedLog given = drawn(OFFSET);
    Fitter fitter = new Fitter(given, Fold.ALL);
    for (Scored set : search(given, Effect.RANGE_OFFSET, Effect.DROPOUT).run()) {
      assertEquals(fitter.logLikelihood(set.hypothesis()), set.inSample(), 1e-9, set.toString());
      assertTrue(set.heldOut() < set.inSample() + 1e-9, "it was fitted to the rest");
    }
  }

  /** What gains less than it has to is not built upon. */
  @Test
  void whatIsNotWorthIt_isNotBuiltUpon() {
    List<Scored> sets = search(drawn(Hypothesis.NONE), Effect.ABSORPTION, Effect.DROPOUT).run();
    assertEquals(
        Set.of(Set.of(), Set.of(Effect.ABSORPTION), Set.of(Effect.DROPOUT)), effects(sets));
    assertTrue(of(sets).heldOut() > sets.get(0).heldOut() - WORTH);
  }

  /** What something else has told of is fitted as well, if it is of effects that are looked for. */
  @Test
  void offered_isAStart() {
    CalibratedLog given = drawn(Hypothesis.NONE);
    Hypothesis both = OFFSET.and(DROPOUT.forms().get(0), 0.3);
    Search search = search(given, Effect.RANGE_OFFSET, Effect.DROPOUT);
    search.offer(both);
    Scored offered = of(search.run(), Effect.RANGE_OFFSET, Effect.DROPOUT);
    assertEquals(0, offered.hypothesis().valuesOf(0)[0], 0.003, "and its values refined");
    Search other = search(given, Effect.GAIN, Effect.DROPOUT);
    other.offer(both);
    other.offer(Hypothesis.NONE);
    assertTrue(other.run().stream().noneMatch(set -> set.hypothesis().has(Effect.RANGE_OFFSET)));
  }

  /** Echoes from nowhere are left over by what may be named, and none where that is all. */
  @Test
  void isOff_whereSomethingIsLeft() {
    Search none = search(drawn(OFFSET), Effect.RANGE_OFFSET);
    none.run();
    assertFalse(none.isOff());
    List<ReadingRow> strange = new ArrayList<>();
    for (ReadingRow row : Worlds.read(Worlds.poses(200, 0.3, 1.3, 61), OFFSET, 62)) {
      strange.add(
          strange.size() % 4 == 0
              ? new ReadingRow(row.run(), row.sensor(), row.timeS(), row.pose(), new Echo(3.3))
              : row);
    }
    Search search = search(Worlds.given(strange), Effect.RANGE_OFFSET);
    search.run();
    assertTrue(search.isOff());
  }

  /** The runners-up are begun from as well: what they and another do is met. */
  @Test
  void further_beginsFromTheRunnersUp() {
    Hypothesis truth = OFFSET.and(DROPOUT.forms().get(0), 0.3);
    Search search = search(drawn(truth), Effect.RANGE_OFFSET, Effect.DROPOUT, Effect.ABSORPTION);
    List<Scored> first = search.run();
    Set<Set<Effect>> met = effects(first);
    List<Scored> more = search.further();
    assertTrue(effects(more).containsAll(met));
    assertEquals(
        Set.copyOf(first.get(0).hypothesis().effects()),
        Set.copyOf(more.get(0).hypothesis().effects()));
  }

  // ---------------------------------------------------------------- plain

  /** A wrong constant and where the tape began, each of which alone would do half of the work. */
  @Test
  void law_isOfScaleAndOffsetTogether() {
    Hypothesis speed = Worlds.effect(Effect.SOUND_SPEED, "scale", 360);
    CalibratedLog given = drawn(speed.and(OFFSET.forms().get(0), 0.05));
    List<Form> forms = Forms.all(Worlds.POST, List.of("s"));
    Fit law = new PlainFamily(given, forms).law();
    assertEquals(
        Set.of(Effect.SOUND_SPEED, Effect.RANGE_OFFSET), Set.copyOf(law.hypothesis().effects()));
    double atTruth =
        new Fitter(given, Fold.ALL).logLikelihood(speed.and(OFFSET.forms().get(0), 0.05));
    assertTrue(law.logLikelihood() > atTruth - 1);
  }

  @Test
  void law_isOfLess_whereLessIsLookedFor() {
    CalibratedLog given = drawn(OFFSET);
    Fit offset = new PlainFamily(given, OFFSET.forms()).law();
    assertEquals(List.of(Effect.RANGE_OFFSET), offset.hypothesis().effects());
    assertEquals(0.05, offset.hypothesis().values()[0], 0.002);
    Fit none = new PlainFamily(given, DROPOUT.forms()).law();
    assertEquals(Hypothesis.NONE, none.hypothesis());
    assertEquals(
        new Fitter(given, Fold.ALL).logLikelihood(Hypothesis.NONE), none.logLikelihood(), 1e-9);
  }

  // ---------------------------------------------------------------- levels

  /** Before a set-up that moves a set is likelier by what that is worth, in both scores. */
  @Test
  void setUpThatMoves_isCountedIn() {
    Calibration calibration =
        Calibration.of(LevelWorlds.POST, new PingLog(LevelWorlds.log(500, 71)));
    PingLog log =
        new PingLog(
            Worlds.read(LevelWorlds.POST, LevelWorlds.poses(200, 72), LevelWorlds.truth(), 73));
    CalibratedLog given = calibration.given(LevelWorlds.POST, log);
    SetupLeave leave = new SetupLeave(given, calibration);
    Set<Effect> excluded = allBut(Effect.GAIN, Effect.RANGE_OFFSET);
    List<Scored> still = new Search(given, excluded, WORTH, Optional.empty()).run();
    List<Scored> moved = new Search(given, excluded, WORTH, Optional.of(leave)).run();
    double nats = leave.natsWithValues(Hypothesis.NONE);
    assertTrue(nats > 0.1, () -> "worth " + nats);
    assertEquals(of(still).inSample() + nats, of(moved).inSample(), 1e-9);
    assertEquals(of(still).heldOut() + nats, of(moved).heldOut(), 1e-9);
  }
}
