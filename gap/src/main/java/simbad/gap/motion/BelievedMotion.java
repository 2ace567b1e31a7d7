package simbad.gap.motion;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import simbad.motion.MotionChain;
import simbad.motion.MotionRun;
import simbad.motion.Robot;
import simbad.motion.effect.FittedMotion;
import simbad.motion.effect.MotionForm;
import simbad.motion.effect.MotionParameter;
import simbad.motion.forecast.MotionForecast;
import simbad.motion.format.MotionData;

/**
 * What is believed of a robot, and what a reference has shown beside it.
 *
 * @param nominal forecast
 * @param noises by component
 * @param shown by the reference
 * @param reference that it was calibrated on, if any
 */
@SuppressWarnings("ArrayRecordComponent") // Three noises, never compared.
record BelievedMotion(
    MotionForecast nominal,
    Noise[] noises,
    List<FittedMotion> shown,
    Optional<Reference> reference) {

  /** The steps of a reference, and by how many times its blocks pull apart more than by chance. */
  record Reference(MotionSteps given, double clumping) {}

  /**
   * Calibrates a robot on a reference that is long enough, and takes it as stated without one.
   *
   * @param data with a reference or without
   */
  static BelievedMotion of(MotionData data) {
    Robot robot = data.robot();
    List<MotionRun> runs = data.reference().stream().map(MotionRun::withoutRepeats).toList();
    MotionSteps trusted = new MotionSteps(runs);
    return trusted.blockCount() < MotionDiagnoser.LEAST_BLOCKS
        ? stated(robot)
        : calibrated(robot, trusted);
  }

  private static BelievedMotion stated(Robot robot) {
    Noise place = Noise.believed(robot.trackSigmaM());
    Noise[] noises = {place, place, Noise.believed(robot.trackSigmaRad())};
    return new BelievedMotion(MotionForecast.believed(robot), noises, List.of(), Optional.empty());
  }

  private static BelievedMotion calibrated(Robot robot, MotionSteps trusted) {
    MotionSearch search = new MotionSearch(trusted, robot);
    ScoredMotion best = search.calibrated(new Odds(search.run(robot.motion())).best());
    MotionHypothesis set = best.hypothesis();
    return new BelievedMotion(
        MotionGap.forecast(trusted.runs(), set.chain()),
        best.fit().noises(),
        set.fitted(),
        Optional.of(new Reference(trusted, best.slopes().linear().clumping())));
  }

  /**
   * Takes what a log shows for a part of the set-up where log and reference may have it in common:
   * both tell each value within bounds only, and set-ups are off by about what is practical. Empty
   * where all of it is a change.
   *
   * @param found explanation of the log
   * @param gains by how many nats each of its forms makes the log likelier
   */
  Optional<BelievedMotion> learning(ScoredMotion found, ToDoubleFunction<MotionForm> gains) {
    if (reference.isEmpty()) {
      return Optional.empty();
    }
    Reference trusted = reference.get();
    MotionChain chain = nominal.chain();
    List<FittedMotion> more = new ArrayList<>(shown);
    for (FittedMotion one : found.hypothesis().fitted()) {
      MotionChain with = chain.with(one.change());
      double against = (logDensity(trusted, chain) - logDensity(trusted, with)) / trusted.clumping;
      if (together(against + unusual(one), gains.applyAsDouble(one.form())) < Odds.COST_NATS) {
        chain = with;
        more.add(one);
      }
    }
    return more.size() == shown.size()
        ? Optional.empty()
        : Optional.of(
            new BelievedMotion(
                MotionGap.forecast(trusted.given.runs(), chain), noises, more, reference));
  }

  /**
   * What two logs lose where they have one value instead of two, to second order: one loses a where
   * it takes the other's value, the other b, and a value between costs the least, 1 / (1/a + 1/b).
   */
  private static double together(double a, double b) {
    return a > 0 && b > 0 ? a * b / (a + b) : 0;
  }

  private double logDensity(Reference trusted, MotionChain chain) {
    return Whitening.logDensity(trusted.given, noises, trusted.given.residuals(chain));
  }

  /** How seldom set-ups are so far off, in nats: deviations in units of what is practical. */
  private static double unusual(FittedMotion one) {
    double square = 0;
    for (int i = 0; i < one.values().length; i++) {
      MotionParameter parameter = one.form().parameters().get(i);
      if (one.values()[i] != parameter.neutral()) {
        double off = (one.values()[i] - parameter.neutral()) / parameter.practical();
        square += off * off;
      }
    }
    return square / 2;
  }
}
