package simbad.gap.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.function.IntToDoubleFunction;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simbad.gap.motion.MotionStrangers.Kind;
import simbad.gap.motion.MotionStrangers.Trace;
import simbad.motion.MotionChain;

/** What shows only on a long way ahead: what comes again, and what wanders for minutes. */
class LongTracesTest {
  private static final MotionSteps GIVEN = given();
  private static final double[] WAY = GIVEN.expected(MotionChain.EXACT)[0];
  private static final Noise[] NOISES = {
    new Noise(Drives.SIGMA_M, 0.005, Noise.GAUSSIAN),
    new Noise(Drives.SIGMA_M, 0.005, Noise.GAUSSIAN),
    new Noise(Drives.SIGMA_RAD, 0.02, Noise.GAUSSIAN)
  };

  private static MotionSteps given() {
    Drives drives = new Drives(82);
    drives.seconds = 400;
    return new MotionSteps(drives.data().runs());
  }

  private static double[][] patterned(int component, IntToDoubleFunction pattern) {
    double[][] residuals = GIVEN.residuals(MotionChain.EXACT);
    for (int i = 0; i < GIVEN.size(); i++) {
      residuals[component][i] += pattern.applyAsDouble(i);
    }
    return residuals;
  }

  private static Trace trace(Kind kind, double[][] residuals) {
    MotionHypothesis none = new MotionHypothesis(MotionChain.EXACT, List.of(), new double[0]);
    ScoredMotion best = ScoredMotion.of(GIVEN, new MotionFit(none, residuals, NOISES, 0));
    return MotionStrangersTest.strangers(GIVEN, best).traces(residuals).stream()
        .filter(one -> one.kind() == kind)
        .findFirst()
        .orElseThrow();
  }

  private static double share(IntToDoubleFunction pattern, double[] residuals) {
    double own = 0;
    for (int i = 0; i < residuals.length; i++) {
      own += Math.pow(pattern.applyAsDouble(i), 2);
    }
    return own / Arrays.stream(residuals).map(r -> r * r).sum();
  }

  /** A wheel out of round, of 30 cm or 1 m around, that makes ways or turns. */
  @ParameterizedTest
  @CsvSource({"0, 0.3, 0.2", "2, 1, 1"})
  void whatComesAgainIsARipple(int component, double aroundM, double size) {
    double[] gone = new double[WAY.length];
    double sum = 0;
    for (int i = 0; i < gone.length; i++) {
      gone[i] = sum + WAY[i] / 2;
      sum += WAY[i];
    }
    IntToDoubleFunction wave = i -> size * WAY[i] * Math.cos(2 * Math.PI * gone[i] / aroundM + 0.6);
    double[][] residuals = patterned(component, wave);
    Trace ripple = trace(Kind.RIPPLE, residuals);

    assertTrue(MotionUnknown.gain(ripple) > 10, ripple::toString);
    // Lengths are tried by fifths of a percent: over the whole way they get out of step a little.
    double all = share(wave, residuals[component]);
    assertTrue(ripple.share() > 0.7 * all && ripple.share() < 1.1 * all, all + ": " + ripple);
  }

  /** A scale that is a tenth more for a minute and a tenth less for the next. */
  @Test
  void whatWandersForMinutesIsADrift() {
    IntToDoubleFunction wave = i -> (GIVEN.step(i).from().timeS() % 160 < 80 ? 0.1 : -0.1) * WAY[i];
    double[][] residuals = patterned(0, wave);
    Trace drift = trace(Kind.DRIFT, residuals);

    // Each of four values may differ in ten parts of the log.
    assertEquals(4 * 9, drift.values());
    assertTrue(MotionUnknown.gain(drift) > 3, drift::toString);
    double all = share(wave, residuals[0]);
    assertTrue(drift.share() > 0.4 * all && drift.share() < 1.1 * all, all + ": " + drift);
    assertEquals(0, drift.raw(), 0);
  }

  /** By chance chi-square is about as large as it has freedoms, 18 nats. */
  @Test
  void whatIsSteadyIsNone() {
    double[][] residuals = GIVEN.residuals(MotionChain.EXACT);
    Trace drift = trace(Kind.DRIFT, residuals);

    assertTrue(drift.nats() > 8 && drift.nats() < 32, drift::toString);
    assertTrue(MotionUnknown.gain(drift) < 0, drift::toString);
    assertTrue(MotionUnknown.gain(trace(Kind.RIPPLE, residuals)) < 0);
  }
}
