package simbad.gap.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import simbad.motion.CommandUse;
import simbad.motion.MotionChain;
import simbad.motion.MotionRun;
import simbad.motion.effect.MotionForm;
import simbad.motion.effect.MotionForms;

/** Values that were put into drives are found again. */
class MotionFitterTest {
  private static final MotionHypothesis NONE =
      new MotionHypothesis(MotionChain.EXACT, List.of(), new double[0]);

  private static MotionForm form(String name) {
    return MotionForms.find(name).orElseThrow();
  }

  /** Of one drive, with what it was told. */
  private static final class Log {
    private final MotionSteps given;
    private final MotionFitter fitter;

    Log(Consumer<Drives> world) {
      Drives drives = new Drives(65);
      drives.seconds = 80;
      world.accept(drives);
      List<MotionRun> runs = drives.data().runs();
      given = new MotionSteps(runs);
      fitter = new MotionFitter(given, CommandUse.of(runs, 0));
    }

    MotionFit screened(MotionForm form) {
      return fitter.screened(new Slopes(given, fitter.asItIs(NONE)), form);
    }

    MotionFit from(MotionForm form, double... start) {
      return fitter.fit(fitter.asItIs(NONE.with(form, start)));
    }
  }

  @Test
  void asItIsOnlyTheNoiseIsSearched() {
    Log log = new Log(drives -> drives.speedFactor = 1.2);
    MotionHypothesis off = NONE.with(form("speed-scale"), new double[] {1.1});
    MotionFit fit = log.fitter.asItIs(off);
    double score = Whitening.logDensity(log.given, fit.noises(), fit.residuals());

    assertSame(off, fit.hypothesis());
    assertEquals(score, fit.score(), 1e-9);
    double likeliest = 0;
    for (double[] residuals : log.given.residuals(off.chain())) {
      likeliest += NoiseFit.likeliest(log.given, log.given.loads(), residuals);
    }
    assertEquals(likeliest, score, 1e-6);
    // Before a noise that is said.
    Noise[] noises = {Noise.believed(0.01), Noise.believed(0.01), Noise.believed(0.01)};
    MotionFit said = log.fitter.with(off, noises);
    assertSame(noises, said.noises());
    assertEquals(Whitening.logDensity(log.given, noises, fit.residuals()), said.score(), 1e-9);
  }

  @Test
  void aSmoothValueIsFitted_andItsNoiseWithIt() {
    Log log = new Log(drives -> drives.speedFactor = 1.2);
    MotionFit fit = log.from(form("speed-scale"), 1);

    assertEquals(1.2, fit.hypothesis().values()[0], 0.003);
    assertTrue(fit.score() > log.fitter.asItIs(NONE).score() + 100);
    // The tracker alone scatters.
    assertEquals(Drives.SIGMA_M, fit.noises()[0].tracker(), 0.0003);
    assertTrue(fit.noises()[0].process() < 0.003);
  }

  @Test
  void aScreenedFormIsTriedWhereItSays() {
    MotionForm late = form("actuation-latency");
    Log log = new Log(drives -> drives.lateS = 0.3);
    MotionFit screened = log.screened(late);

    assertEquals(0.3, screened.hypothesis().values()[0], 0.05);
    assertTrue(screened.score() > log.fitter.asItIs(NONE).score() + 100);
    assertEquals(0.3, log.fitter.fit(screened).hypothesis().values()[0], 0.01);
    // What is not there is left neutral, or nearly so.
    MotionFit none = new Log(drives -> {}).screened(late);
    assertTrue(none.hypothesis().values()[0] < 0.03);
    assertSame(late, none.hypothesis().forms().get(0));
  }

  /** A greatest speed that turning takes from: neither is found without the other. */
  @Test
  void aValueBesideAnotherIsTriedWithEachOfIts() {
    Log log =
        new Log(
            drives -> {
              drives.mostSpeed = 0.25;
              drives.lostPerTurn = 0.15;
            });
    MotionFit fit = log.fitter.fit(log.screened(form("saturation: speed while turning")));

    assertEquals(0.25, fit.hypothesis().values()[0], 0.005);
    assertEquals(0.15, fit.hypothesis().values()[1], 0.01);
  }

  /** Steps make motion jump: no slope leads to them, but a value nearby is nudged. */
  @Test
  void aStepIsNudged() {
    Log log = new Log(drives -> drives.speedStep = 0.04);
    MotionForm steps = form("command-quantization");
    MotionFit start = log.fitter.asItIs(NONE.with(steps, new double[] {0.0403, 0}));
    MotionFit fit = log.fitter.fit(start);

    assertTrue(fit.score() > start.score() + 10);
    assertTrue(Math.abs(fit.hypothesis().values()[0] - 0.04) < 0.00025);
    assertEquals(0, fit.hypothesis().values()[1], 0);
    MotionFit screened = log.screened(steps);
    assertEquals(0.04, log.fitter.fit(screened).hypothesis().values()[0], 0.001);
  }

  /** Of many tries those go on that a part of a long log finds likeliest. */
  @Test
  void aLongLogIsScreenedOnAPart() {
    Log log =
        new Log(
            drives -> {
              drives.seconds = 410;
              drives.lateS = 0.4;
              drives.deadSpeed = 0.1;
            });
    MotionFit late = log.screened(form("actuation-latency"));
    MotionFit dead = log.fitter.screened(new Slopes(log.given, late), form("dead-band"));

    assertEquals(0.4, dead.hypothesis().values()[0], 0.02);
    assertEquals(0.1, dead.hypothesis().values()[1], 0.01);
    assertTrue(dead.score() > late.score() + 100);
  }
}
