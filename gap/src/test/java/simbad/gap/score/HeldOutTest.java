package simbad.gap.score;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;
import simbad.definition.Effect;
import simbad.gap.fit.CalibratedLog;
import simbad.gap.fit.Fit;
import simbad.gap.fit.Fitter;
import simbad.gap.fit.Fold;
import simbad.gap.fit.Hypothesis;
import simbad.gap.fixture.Worlds;
import simbad.gap.score.HeldOut.Scored;

class HeldOutTest {
  private static final Hypothesis OFFSET = Worlds.effect(Effect.RANGE_OFFSET, "constant", 0.05);

  /** What has no values has nothing to learn: both halves together are the whole. */
  @Test
  void withoutValues_theScoreIsTheLikelihood() {
    CalibratedLog given = read(2);
    Fitter fitter = new Fitter(given, Fold.ALL);
    Fit nominal = fitter.refine(Hypothesis.NONE, 0);
    Fit offset = fitter.refine(OFFSET, 0);
    List<Scored> scored =
        new HeldOut(given, new Blocks(given.log())).score(List.of(offset, nominal));
    assertEquals(Hypothesis.NONE, scored.get(0).hypothesis(), "the smaller first");
    assertEquals(nominal.logLikelihood(), scored.get(0).heldOut(), 1e-9);
    assertEquals(nominal.logLikelihood(), scored.get(0).inSample(), 1e-9);
  }

  /** Half of the square of a standard normal number for each half: 1 nat on average. */
  @Test
  void oneValue_costsOneNat() {
    double loss = 0;
    for (int seed = 2; seed < 14; seed++) {
      CalibratedLog given = read(seed);
      Fit offset = new Fitter(given, Fold.ALL).refine(OFFSET, 0);
      Scored scored = new HeldOut(given, new Blocks(given.log())).score(List.of(offset)).get(0);
      loss += scored.inSample() - scored.heldOut();
    }
    // Of one log it scatters by 1.7 nats, of the mean of twelve by 0.5.
    assertEquals(1, loss / 12, 2);
  }

  /** Nearer than the edge at 1.5 m, where one row that flips costs more than any value does. */
  private static CalibratedLog read(long seed) {
    return Worlds.given(Worlds.read(Worlds.poses(300, 0.3, 1.3, 1), OFFSET, seed));
  }

  /** Each value fits a nat of chance, and the worst of those that were scored lost 3 more. */
  @Test
  void guess_losesWhatTheWorstLost() {
    Fit two = new Fit(Worlds.effect(Effect.HYSTERESIS, "both", 0.1), -50);
    int values = two.hypothesis().size();
    List<Scored> scored =
        List.of(
            new Scored(Hypothesis.NONE, -100, -100),
            new Scored(OFFSET, -80, -84),
            new Scored(OFFSET, -80, -79));
    assertEquals(-50 - values - 3, HeldOut.guess(two, scored).heldOut(), 1e-12);
    assertEquals(-50, HeldOut.guess(two, scored).inSample());
    assertEquals(-50 - values, HeldOut.guess(two, List.of()).heldOut(), 1e-12);
    assertEquals(
        -50 - values,
        HeldOut.guess(two, scored.subList(2, 3)).heldOut(),
        1e-12,
        "nothing is won by what predicted better than it fitted");
  }
}
