package simbad.gap.motion;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import simbad.motion.CommandUse;
import simbad.motion.effect.MotionForm;
import simbad.motion.effect.MotionParameter;

/** Fits the values of a hypothesis and the noise beside it to a whole log. */
final class MotionFitter {
  private static final int ROUNDS = 6;
  private static final int OUTER = 3;
  private static final double ENOUGH_NATS = 0.02;
  private static final double LITTLE_NATS = 1;
  private static final double STRONGEST = 1e3;

  /** A value that jumps is looked for by these shares of it. */
  private static final double[] NUDGES = {0.03, -0.03, 0.01, -0.01, 0.003, -0.003, 0.001, -0.001};

  /** Of many values that are tried, so many are tried on the whole log. */
  private static final int KEPT = 4;

  private final MotionSteps given;
  private final MotionSteps sample;
  private final CommandUse use;

  MotionFitter(MotionSteps given, CommandUse use) {
    this.given = given;
    sample = given.sample();
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
    Slopes slopes = new Slopes(given, from);
    boolean nudging = true;
    for (int round = 0; round < OUTER; round++) {
      Settled settled = settled(slopes, ROUNDS);
      MotionFit stepped = nudging ? nudged(settled.fit) : settled.fit;
      nudging = stepped.score() > settled.fit.score();
      MotionFit next =
          with(
              stepped.hypothesis(),
              stepped.residuals(),
              NoiseFit.near(given, stepped.residuals(), stepped.noises()));
      boolean done = next.score() - best.score() < 1;
      best = next.score() > best.score() ? next : best;
      if (done || round + 1 == OUTER) {
        break;
      }
      slopes = nudging ? new Slopes(given, best) : settled.slopes(best);
    }
    return best;
  }

  /**
   * A fit after steps.
   *
   * @param fit after them
   * @param before slopes from before the last one
   * @param gain of the last one, nats
   */
  private record Settled(MotionFit fit, Slopes before, double gain) {
    /** Returns the slopes, with the noise of another fit: after a small step they are the same. */
    Slopes slopes(MotionFit other) {
      return gain < LITTLE_NATS ? before.of(other) : before.anew(other);
    }
  }

  /** Damped steps of Gauss and Newton, the noise as it is. */
  private Settled settled(Slopes first, int rounds) {
    Settled settled = new Settled(first.fit(), first, 0);
    double damping = 1e-4;
    for (int round = 0; round < rounds && !first.isEmpty(); round++) {
      MotionFit best = settled.fit;
      Slopes slopes = settled.slopes(best);
      MotionFit next = best;
      for (; damping < STRONGEST && next.score() <= best.score(); damping *= 30) {
        next = with(slopes.stepped(damping), best.noises());
      }
      double gain = next.score() - best.score();
      if (gain <= 0) {
        return new Settled(best, slopes, 0);
      }
      settled = new Settled(next, slopes, gain);
      if (gain < ENOUGH_NATS) {
        break;
      }
      damping = Math.max(1e-6, damping / 1000);
    }
    return settled;
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
   *
   * @param base slopes of the fit
   * @param form that is put beside it
   */
  MotionFit screened(Slopes base, MotionForm form) {
    MotionFit from = base.fit();
    MotionHypothesis start = from.hypothesis().with(form, form.neutralValues());
    MotionFit best = new MotionFit(start, from.residuals(), from.noises(), from.score());
    int first = from.hypothesis().values().length;
    List<MotionParameter> parameters = form.parameters();
    if (parameters.size() == 2 && parameters.get(1).beside()) {
      return stepped(base, likeliest(best, pairs(start, first, parameters)));
    }
    for (int i = 0; i < parameters.size(); i++) {
      double[] tries = parameters.get(i).tries().apply(use);
      best = likeliest(best, tried(best.hypothesis(), first + i, tries));
    }
    return stepped(base, best);
  }

  private MotionFit stepped(Slopes base, MotionFit from) {
    Slopes slopes = new Slopes(given, from, Optional.of(base));
    return settled(slopes, 1).fit();
  }

  /** The second value is looked for beside each try of the first. */
  private List<MotionHypothesis> pairs(
      MotionHypothesis start, int first, List<MotionParameter> parameters) {
    double[] others = parameters.get(1).tries().apply(use);
    return tried(start, first, parameters.get(0).tries().apply(use)).stream()
        .flatMap(own -> Stream.concat(Stream.of(own), tried(own, first + 1, others).stream()))
        .toList();
  }

  private static List<MotionHypothesis> tried(MotionHypothesis from, int index, double[] tries) {
    MotionParameter parameter = from.parameters().get(index);
    return Arrays.stream(tries)
        .filter(value -> value != from.values()[index])
        .mapToObj(value -> from.withValue(index, parameter.within(value)))
        .toList();
  }

  private MotionFit likeliest(MotionFit base, List<MotionHypothesis> candidates) {
    MotionFit best = base;
    for (MotionHypothesis candidate : promising(candidates, base.noises())) {
      MotionFit fit = with(candidate, base.noises());
      best = fit.score() > best.score() ? fit : best;
    }
    return best;
  }

  /** Of many candidates the few that a part of a long log finds likeliest. */
  private List<MotionHypothesis> promising(List<MotionHypothesis> candidates, Noise[] noises) {
    if (candidates.size() <= KEPT || sample.size() == given.size()) {
      return candidates;
    }
    return candidates.stream()
        .map(one -> new Tried(one, -sampleScore(one, noises)))
        .sorted(Comparator.comparingDouble(Tried::loss))
        .limit(KEPT)
        .map(Tried::hypothesis)
        .toList();
  }

  private record Tried(MotionHypothesis hypothesis, double loss) {}

  private double sampleScore(MotionHypothesis hypothesis, Noise[] noises) {
    return Whitening.logDensity(sample, noises, sample.residuals(hypothesis.chain()));
  }
}
