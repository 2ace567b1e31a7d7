package simbad.gap.unexplained;

import java.util.Arrays;
import java.util.Set;
import simbad.definition.Effect;
import simbad.definition.Trait;
import simbad.gap.fit.CalibratedLog;
import simbad.gap.fit.Hypothesis;
import simbad.gap.score.GapGain;
import simbad.sonar.change.Burst;
import simbad.sonar.change.UnmodelledPost;
import simbad.sonar.effect.Definitions;
import simbad.sonar.frame.Point;
import simbad.sonar.ping.Change;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.Scene;
import simbad.sonar.shape.Outline;

/**
 * What speaks for something that the best set of effects does not account for; how probable that
 * makes it, {@link Constants} say.
 */
public final class Unknown {
  /** By chance the mean of the five greatest misfits reaches this. */
  private static final double CHANCE = 3;

  /** Two effects that take away less than this share of the gap stand for something else. */
  private static final double WORTH_TWO = 0.2;

  /** What depends on no place takes up a little of anything. */
  public static final Set<Effect> SOAK = Definitions.with(Trait.SOAKS_UP);

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

  /** A gap that is left and is a smaller share of the gap before does not matter. */
  private static final double SMALL_SHARE = 0.05;

  private static final double PRACTICAL_M = 0.002;

  /** Nobody overlooks what stands so near to what he put up. */
  private static final double BESIDE_M = 0.05;

  private static final double NEARLY = 0.99;

  private Unknown() {}

  /**
   * Finds what speaks for it.
   *
   * @param given the log
   * @param open the same before a set-up that has moved as far as its reference leaves open
   * @param doubt of the set-up
   * @param gain of the best set
   * @param best the best set of effects
   */
  public static Signs signs(
      CalibratedLog given, CalibratedLog open, SetupDoubt doubt, GapGain gain, Hypothesis best) {
    Misfit misfit =
        doubt
            .leeway()
            .map(leeway -> Misfit.of(given, best, leeway))
            .orElseGet(() -> Misfit.of(open, best));
    double[] vary = doubt.blocksVary();
    double off = misfit.top(Misfit.TOP, vary[0], vary[1]);
    off /= doubt.misfitTimes(CHANCE, given.log().size());
    if (doubt.isHeldOut() && isWithinItself(gain)) {
      off = Math.min(off, CHANCE + MOST_UNSEEN);
    }
    Signs signs =
        signs(Math.max(0, off - CHANCE), gain, doubt.gapTimes(), best, given.setup().scene());
    return Strays.of(given, best).goWithDistance() ? signs.withStandIn() : signs;
  }

  /**
   * Returns why a part of an explanation stands in for something else, in words; empty where that
   * is not known.
   *
   * @param given the log
   * @param best the best set of effects
   */
  public static String standsIn(CalibratedLog given, Hypothesis best) {
    Strays strays = Strays.of(given, best);
    return strays.goWithDistance() ? strays.words() : "";
  }

  /** Three effects at once are rarer than one thing that has no name. */
  static Signs signs(double misfit, GapGain gain, double times, Hypothesis best, Scene scene) {
    double shrinkage = gain.shrinkage();
    boolean isNamed = best.size() > 0;
    // A value that would go on beyond what there is fits something else.
    boolean standIn =
        best.isAtBound() || best.changes().stream().anyMatch(c -> isStandIn(c, scene));
    return new Signs(
        misfit,
        left(gain, times),
        isLittle(gain, times),
        isNamed ? Math.min(1, 1 - shrinkage) : 0,
        best.effects().stream().anyMatch(SOAK::contains),
        best.forms().size() > 2,
        best.forms().size() > 1 && shrinkage < WORTH_TWO,
        standIn);
  }

  /** Whether the gap before is hardly more than the set-up expects of itself. */
  private static boolean isWithinItself(GapGain gain) {
    return gain.beforeM() < WITHIN_ITSELF * mean(gain.before().expectedM());
  }

  /**
   * What is left of the gap over what is expected, as a logarithm, where the set-up itself is off
   * by some times what it expects.
   */
  static double left(GapGain gain, double times) {
    double expected = times * mean(gain.after().expectedM());
    double ratio = (gain.afterM() + MILLIMETRE) / (expected + MILLIMETRE);
    return Math.log(Math.max(LEAST_LEFT, Math.min(MOST_LEFT, ratio)));
  }

  /** Whether what is left does not matter, however sure it is. */
  static boolean isLittle(GapGain gain, double times) {
    double expected = times * mean(gain.after().expectedM());
    double little = Math.max(PRACTICAL_M, SMALL_SHARE * (gain.beforeM() - gain.floorM()));
    return gain.afterM() - expected < little;
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
