package simbad.gap.motion;

import java.util.ArrayList;
import java.util.List;
import simbad.motion.CommandUse;
import simbad.motion.effect.MotionForm;
import simbad.motion.effect.MotionParameter;

/** Fits the values of a hypothesis and the noise beside it to a whole log. */
final class MotionFitter {
  private static final int ROUNDS = 6;
  private static final int OUTER = 3;
  private static final double ENOUGH_NATS = 0.02;
  private static final double STRONGEST = 1e3;

  /** A value that jumps is looked for by these shares of it. */
  private static final double[] NUDGES = {0.03, -0.03, 0.01, -0.01, 0.003, -0.003};

  private final MotionSteps given;
  private final CommandUse use;

  MotionFitter(MotionSteps given, CommandUse use) {
    this.given = given;
    this.use = use;
  }

  /** Returns a hypothesis as it stands, its noise searched afresh. */
  MotionFit asItIs(MotionHypothesis hypothesis) {
    double[][] residuals = given.residuals(hypothesis.chain());
    return with(hypothesis, residuals, NoiseFit.afresh(given, residuals));
  }

  /** Returns a hypothesis as it stands, before a noise. */
  MotionFit with(MotionHypothesis hypothesis, Noise[] noises) {
    return with(hypothesis, given.residuals(hypothesis.chain()), noises);
  }

  private MotionFit with(MotionHypothesis hypothesis, double[][] residuals, Noise[] noises) {
    double score = Whitening.logDensity(given, noises, residuals);
    return new MotionFit(hypothesis, residuals, noises, score);
  }

  /** Fits values and noise in turn. */
  MotionFit fit(MotionFit from) {
    MotionFit best = from;
    for (int round = 0; round < OUTER; round++) {
      MotionFit stepped = nudged(settled(best, ROUNDS));
      MotionFit next =
          with(
              stepped.hypothesis(),
              stepped.residuals(),
              NoiseFit.near(given, stepped.residuals(), stepped.noises()));
      boolean done = next.score() - best.score() < 1;
      best = next.score() > best.score() ? next : best;
      if (done) {
        break;
      }
    }
    return best;
  }

  /** Damped steps of Gauss and Newton, the noise as it is. */
  MotionFit settled(MotionFit from, int rounds) {
    MotionFit best = from;
    double damping = 1e-4;
    for (int round = 0; round < rounds; round++) {
      Slopes slopes = new Slopes(given, best);
      if (slopes.isEmpty()) {
        return best;
      }
      MotionFit next = best;
      for (; damping < STRONGEST && next.score() <= best.score(); damping *= 30) {
        next = with(slopes.stepped(damping), best.noises());
      }
      double gain = next.score() - best.score();
      best = gain > 0 ? next : best;
      damping = Math.max(1e-6, damping / 1000);
      if (gain < ENOUGH_NATS) {
        return best;
      }
    }
    return best;
  }

  private MotionFit nudged(MotionFit from) {
    MotionFit best = from;
    List<MotionParameter> parameters = from.hypothesis().parameters();
    for (int i = 0; i < parameters.size(); i++) {
      if (parameters.get(i).stepped()) {
        for (double share : NUDGES) {
          double value = parameters.get(i).within(best.hypothesis().values()[i] * (1 + share));
          MotionFit tried = with(best.hypothesis().withValue(i, value), best.noises());
          best = tried.score() > best.score() ? tried : best;
        }
      }
    }
    return best;
  }

  /**
   * Puts a form beside a fit: each of its values in turn from what its definition says to try, then
   * a step of all values. The noise stays, so that the score is a lower bound.
   */
  MotionFit screened(MotionFit base, MotionForm form) {
    MotionHypothesis start = base.hypothesis().with(form, form.neutralValues());
    MotionFit best = new MotionFit(start, base.residuals(), base.noises(), base.score());
    int first = base.hypothesis().values().length;
    List<MotionParameter> parameters = form.parameters();
    if (isSecondNothingAlone(parameters)) {
      return settled(scannedBeside(best, first, parameters), 1);
    }
    for (int i = 0; i < parameters.size(); i++) {
      best = scanned(best, first + i, parameters.get(i).tries().apply(use));
    }
    return settled(best, 1);
  }

  /** Where there is no limit, by how much it would fall says nothing. */
  private static boolean isSecondNothingAlone(List<MotionParameter> parameters) {
    return parameters.size() == 2
        && Double.isInfinite(parameters.get(0).neutral())
        && Double.isFinite(parameters.get(1).neutral());
  }

  /** The second value is looked for beside each try of the first. */
  private MotionFit scannedBeside(MotionFit base, int first, List<MotionParameter> parameters) {
    double[] others = parameters.get(1).tries().apply(use);
    MotionFit best = base;
    for (double value : parameters.get(0).tries().apply(use)) {
      MotionFit own = with(base.hypothesis().withValue(first, value), base.noises());
      MotionFit both = scanned(own, first + 1, others);
      best = both.score() > best.score() ? both : best;
    }
    return best;
  }

  private MotionFit scanned(MotionFit base, int index, double[] tries) {
    MotionParameter parameter = base.hypothesis().parameters().get(index);
    List<MotionFit> fits = new ArrayList<>();
    for (double value : tries) {
      if (value != base.hypothesis().values()[index]) {
        fits.add(with(base.hypothesis().withValue(index, parameter.within(value)), base.noises()));
      }
    }
    MotionFit best = base;
    for (MotionFit fit : fits) {
      best = fit.score() > best.score() ? fit : best;
    }
    return best;
  }
}
