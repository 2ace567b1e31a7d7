package simbad.gap.explain;

import java.util.Arrays;
import java.util.Set;
import simbad.definition.Effect;
import simbad.definition.Trait;
import simbad.gap.fit.Evidence;
import simbad.gap.fit.Hypothesis;
import simbad.sonar.change.Burst;
import simbad.sonar.change.UnmodelledPost;
import simbad.sonar.effect.Definitions;
import simbad.sonar.frame.Point;
import simbad.sonar.ping.Change;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.Scene;
import simbad.sonar.shape.Outline;

/**
 * How probable it is that something is at work that the best set of effects does not account for.
 */
public final class Unknown {
  /** How many of the greatest misfits count. */
  static final int TOP = 5;

  /**
   * Of logs that were checked and fitted well, so many held what has no name; of those that fitted
   * badly, so many did (docs/method/gap.md).
   */
  private static final double LEAST = 0.005;

  private static final double MOST = 0.965;

  /** By chance the mean of the five greatest misfits reaches this. */
  private static final double CHANCE = 3;

  // A logistic regression over development worlds (docs/method/gap.md).
  private static final double BASE = -4.8;
  private static final double PER_MISFIT = 2.2;
  private static final double SOAKING = 0.75;
  private static final double PER_LEFT = 1.75;
  private static final double PER_SHARE_LEFT = 1;
  private static final double THIRD = 1;
  private static final double LITTLE = -0.5;

  /** Two effects that take away less than this share of the gap stand for something else. */
  private static final double WORTH_TWO = 0.2;

  private static final double TWO_FOR_LITTLE = 2.5;

  /** What hangs on no place takes up a little of anything. */
  static final Set<Effect> SOAK = Definitions.with(Trait.SOAKS_UP);

  /** What is left of a gap over what an explanation expects of itself: bounds of what counts. */
  private static final double LEAST_LEFT = 0.5;

  private static final double MOST_LEFT = 4;

  /**
   * A level law is off in some slice by more than chance, since it has one beam and one receiver
   * for all. Where that does not show in the gap it is no sign of something without a name: in 22
   * wave worlds with nothing changed the gap was at most 1.39 times what the law expected of
   * itself, in 12 with something else at least 1.54 times.
   */
  private static final double WITHIN_ITSELF = 1.4;

  /** So far over chance misfits count then. */
  private static final double MOST_UNSEEN = 1;

  private static final double MILLIMETRE = 1e-3;

  /** Nothing that was named leaves so much; less sure than what misfits show. */
  private static final double REST = 0.9;

  /** A gap that is left and is a smaller share of the gap before does not matter. */
  private static final double SMALL_SHARE = 0.05;

  private static final double PRACTICAL_M = 0.002;

  /**
   * In 711 checked worlds the longest bursts there may be were never bursts (21 of 21); in 375 none
   * of the posts beside a known obstacle was there (5 of 5), and those that were stood 0.59 m off
   * or more (6 of 6).
   */
  private static final double STAND_IN = 6;

  /** Nobody overlooks what stands so near to what he put up. */
  private static final double BESIDE_M = 0.05;

  private static final double NEARLY = 0.99;

  private Unknown() {}

  /**
   * Estimates the probability.
   *
   * @param evidence the log
   * @param open the same before a set-up that has moved as far as its reference leaves open
   * @param calibration of the log
   * @param gain of the best set
   * @param best the best set of effects
   */
  public static double probability(
      Evidence evidence, Evidence open, Calibration calibration, Gain gain, Hypothesis best) {
    Misfit misfit =
        calibration
            .leeway()
            .map(leeway -> Misfit.of(evidence, best, leeway))
            .orElseGet(() -> Misfit.of(open, best));
    double[] vary = calibration.blocksVary();
    double off = misfit.top(TOP, vary[0], vary[1]);
    off /= calibration.misfitTimes(CHANCE, evidence.log().size());
    if (calibration.modelError().isPresent() && isWithinItself(gain)) {
      off = Math.min(off, CHANCE + MOST_UNSEEN);
    }
    double logit =
        BASE + PER_MISFIT * Math.max(0, off - CHANCE) + left(gain, calibration.gapTimes());
    if (best.size() > 0) {
      logit += named(best, gain.shrinkage());
    }
    Scene scene = evidence.setup().scene();
    // A value that would go on beyond what there is fits something else.
    if (best.isAtBound() || best.changes().stream().anyMatch(c -> isStandIn(c, scene))) {
      logit += STAND_IN;
    }
    return LEAST + (MOST - LEAST) / (1 + Math.exp(-logit));
  }

  /** Whether the gap before is hardly more than the set-up expects of itself. */
  private static boolean isWithinItself(Gain gain) {
    return gain.beforeM() < WITHIN_ITSELF * mean(gain.before().expectedM());
  }

  /**
   * Returns the probability where so much is left that nothing is explained, though the misfits
   * alone would not say so: a value at the end of a search, or twice the scatter that is expected.
   */
  public static double besideARest(double probability) {
    return probability > 0.5 ? probability : REST;
  }

  /** By what is left of the gap; next to nothing does not matter, however sure it is. */
  static double left(Gain gain) {
    return left(gain, 1);
  }

  /** The same where the set-up itself is off by some times what it expects. */
  private static double left(Gain gain, double times) {
    double expected = times * mean(gain.after().expectedM());
    double ratio = (gain.afterM() + MILLIMETRE) / (expected + MILLIMETRE);
    double over = PER_LEFT * Math.log(Math.max(LEAST_LEFT, Math.min(MOST_LEFT, ratio)));
    double little = Math.max(PRACTICAL_M, SMALL_SHARE * (gain.beforeM() - gain.floorM()));
    return over + (gain.afterM() - expected < little ? LITTLE : 0);
  }

  /**
   * By what was named and what it takes away: three effects at once are rarer than one thing that
   * has no name.
   */
  static double named(Hypothesis best, double shrinkage) {
    boolean soaks = best.effects().stream().anyMatch(SOAK::contains);
    return (soaks ? SOAKING : 0)
        + (best.forms().size() > 2 ? THIRD : 0)
        + (best.forms().size() > 1 && shrinkage < WORTH_TWO ? TWO_FOR_LITTLE : 0)
        + PER_SHARE_LEFT * Math.min(1, 1 - shrinkage);
  }

  /** Bursts longer than there are, or an object where a known one stands. */
  static boolean isStandIn(Change change, Scene scene) {
    if (change instanceof Burst burst) {
      return burst.lengthPings() > NEARLY * Burst.LONGEST_PINGS;
    }
    return change instanceof UnmodelledPost post
        && scene.obstacles().stream().anyMatch(obstacle -> isBeside(post, obstacle));
  }

  private static boolean isBeside(UnmodelledPost post, Obstacle obstacle) {
    Point own = obstacle.worldFromObstacle().obstacleFromWorld(new Point(post.xM(), post.zM()));
    Outline outline = obstacle.outline();
    double beyondItsCore = Math.hypot(own.xM(), own.zM()) - outline.distanceM(0, 0);
    double apart = Math.min(beyondItsCore, outline.distanceM(own.xM(), own.zM()));
    return apart < BESIDE_M + post.radiusM();
  }

  private static double mean(double[] values) {
    return Arrays.stream(values).average().orElse(0);
  }
}
