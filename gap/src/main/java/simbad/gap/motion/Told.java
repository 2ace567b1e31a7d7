package simbad.gap.motion;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import simbad.motion.MotionRun;
import simbad.motion.effect.MotionForm;

/**
 * What a log says, slips left out or not.
 *
 * @param given steps that were explained
 * @param sent the runs with every command, also those that repeat the one before
 * @param odds of sets of effects
 * @param gap before and after the most probable set
 * @param scatter beside it
 */
record Told(
    MotionSteps given, List<MotionRun> sent, Odds odds, MotionGap gap, NoiseFindings scatter) {
  /** Returns by how much a form of the most probable set makes the log likelier, in nats. */
  double gain(MotionForm form) {
    MotionFit best = odds.best().fit();
    double[][] without = given.residuals(best.hypothesis().without(form).chain());
    double lost = best.score() - Whitening.logDensity(given, best.noises(), without);
    return lost / odds.clumping();
  }

  /** Returns the worth of each effect of the most probable set, by {@link MotionSigns}. */
  Map<String, Double> worths() {
    double with = gap.fitted(odds.best().hypothesis().chain());
    double left = gap.ratio() - gap.floor(odds.best().fit().noises());
    Map<String, Double> worths = new TreeMap<>();
    for (String effect : odds.best().hypothesis().effects()) {
      double without = gap.fitted(odds.lacking(effect).hypothesis().chain());
      worths.put(effect, MotionSigns.worth(without - with, left));
    }
    return worths;
  }
}
