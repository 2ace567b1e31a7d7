package simbad.gap.explain;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import simbad.gap.fit.Evidence;
import simbad.gap.fit.Fit;
import simbad.gap.fit.Fitter;
import simbad.gap.fit.Fold;
import simbad.gap.fit.Hypothesis;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.PingLog;
import simbad.sonar.effect.SetupForms;
import simbad.sonar.scene.SensingSetup;

/**
 * What a reference log says of the set-up: in what it is a little off while the simulation is
 * trusted, and how far its readings hang together.
 *
 * @param setup the calibrated forms with their values; none without a reference
 * @param clumping by how much sums over blocks of readings vary more than those of independent
 *     readings would; 1 without a reference
 */
public record Calibration(Hypothesis setup, double clumping) {
  /** There is no reference: the set-up is as it is believed to be. */
  public static final Calibration NONE = new Calibration(Hypothesis.NONE, 1);

  private static final double WORTH_NATS = 4;
  private static final int ROUNDS = 3;

  /** A threshold is off by a few per cent; what the reference does not show stays near 0. */
  private static final double PRIOR = 0.05;

  /** Calibrates. */
  public static Calibration of(SensingSetup setup, PingLog reference) {
    Evidence evidence = new Evidence(setup, List.of(), reference);
    Fitter fitter = new Fitter(evidence, Fold.ALL);
    Hypothesis best = Hypothesis.NONE;
    List<Form> waves = new ArrayList<>();
    for (Form form : SetupForms.all(setup)) {
      if (form.name().startsWith("threshold")) {
        waves.add(form);
      } else {
        best = tried(fitter, best, form);
      }
    }
    for (int round = 0; round < ROUNDS; round++) {
      for (Form wave : waves) {
        best = waved(fitter, best, wave);
      }
      if (best.size() > 0) {
        best = refinedScatter(fitter, best, waves);
      }
    }
    return new Calibration(best, clumping(evidence, best));
  }

  /**
   * Lets the thresholds move a little from where the reference left them: the bearings of a log are
   * not those of its reference, and what a set-up is off by is no effect.
   *
   * @param evidence of the log, calibrated
   * @param explanation that stays as it is
   * @return the explanation and the thresholds' waves
   */
  public Hypothesis loosened(Evidence evidence, Hypothesis explanation) {
    if (setup.forms().isEmpty()) {
      return explanation;
    }
    Fitter fitter = new Fitter(evidence, Fold.ALL);
    Hypothesis loose = explanation;
    for (Form form : SetupForms.all(evidence.setup())) {
      if (form.name().startsWith("threshold")) {
        loose = waved(fitter, waved(fitter, loose, form), form);
      }
    }
    return loose;
  }

  private static Hypothesis tried(Fitter fitter, Hypothesis base, Form form) {
    double[] start =
        form.parameters().stream().mapToDouble(p -> p.tries().get(p.tries().size() - 1)).toArray();
    Fit fit = fitter.refine(base.and(form, start), base.size(), 40 + 25 * start.length);
    return fit.logLikelihood() - fitter.logLikelihood(base) > WORTH_NATS ? fit.hypothesis() : base;
  }

  /** Newton's steps for one coefficient after the other: they hardly depend on each other. */
  private static Hypothesis waved(Fitter fitter, Hypothesis base, Form wave) {
    Hypothesis with = base.forms().contains(wave) ? base : base.and(wave, wave.neutral());
    int from = offset(with, wave);
    double[] values = with.values();
    double here = penalised(fitter, with, values, from);
    for (int i = from; i < from + wave.parameters().size(); i++) {
      double step = 0.01;
      double[] up = moved(values, i, step);
      double[] down = moved(values, i, -step);
      double high = penalised(fitter, with, up, from);
      double low = penalised(fitter, with, down, from);
      double curve = (high - 2 * here + low) / (step * step);
      double slope = (high - low) / (2 * step);
      double move = curve < 0 ? Math.max(-0.04, Math.min(0.04, -slope / curve)) : 0;
      double[] next = moved(values, i, move);
      double there = penalised(fitter, with, next, from);
      if (there > here) {
        values = next;
        here = there;
      }
    }
    return with.with(values);
  }

  private static double penalised(Fitter fitter, Hypothesis form, double[] values, int from) {
    double away = 0;
    for (int i = from; i < values.length; i++) {
      away += values[i] * values[i];
    }
    return fitter.logLikelihood(form.with(values)) - away / (2 * PRIOR * PRIOR);
  }

  private static double[] moved(double[] values, int index, double by) {
    double[] moved = values.clone();
    moved[index] += by;
    return moved;
  }

  private static int offset(Hypothesis hypothesis, Form form) {
    int from = 0;
    for (Form each : hypothesis.forms()) {
      if (each.equals(form)) {
        break;
      }
      from += each.parameters().size();
    }
    return from;
  }

  /** The scatter again, now that the thresholds are known better. */
  private static Hypothesis refinedScatter(Fitter fitter, Hypothesis best, List<Form> waves) {
    Hypothesis waved = Hypothesis.NONE;
    Hypothesis rest = Hypothesis.NONE;
    for (int i = 0; i < best.forms().size(); i++) {
      Form form = best.forms().get(i);
      if (waves.contains(form)) {
        waved = waved.and(form, best.valuesOf(i));
      } else {
        rest = rest.and(form, best.valuesOf(i));
      }
    }
    Hypothesis all = waved;
    for (int i = 0; i < rest.forms().size(); i++) {
      all = all.and(rest.forms().get(i), rest.valuesOf(i));
    }
    return fitter.refine(all, waved.size(), 30 + 25 * rest.size()).hypothesis();
  }

  /** Mean square of the blocks' sums of surprises, each in units of what chance gives. */
  private static double clumping(Evidence evidence, Hypothesis setup) {
    Surprise surprise = new Surprise(evidence, setup);
    Blocks blocks = new Blocks(evidence.log());
    double[] sum = new double[blocks.count()];
    double[] variance = new double[blocks.count()];
    for (int i = 0; i < evidence.log().size(); i++) {
      sum[blocks.of(i)] += (evidence.log().echo(i) ? 1 : 0) - surprise.expected[i];
      variance[blocks.of(i)] += surprise.expected[i] * (1 - surprise.expected[i]);
    }
    double[] square = new double[sum.length];
    int count = 0;
    for (int i = 0; i < sum.length; i++) {
      if (variance[i] > 0.5) {
        square[count++] = sum[i] * sum[i] / variance[i];
      }
    }
    return count == 0 ? 1 : Math.max(1, Arrays.stream(square, 0, count).average().orElse(1));
  }
}
