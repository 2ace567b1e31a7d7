package simbad.blindworld.motionchange;

import java.util.List;
import java.util.Objects;
import java.util.random.RandomGenerator;
import simbad.blindworld.motion.Acting;
import simbad.blindworld.motion.AnyStep;
import simbad.blindworld.motion.Commands;
import simbad.blindworld.motion.Commands.Speeds;
import simbad.blindworld.motion.Outing;
import simbad.blindworld.motion.Robot;
import simbad.blindworld.motion.Step;
import simbad.blindworld.world.FixedChance;
import simbad.blindworld.world.Pose;

/**
 * A robot and what it is told, such that the sizes of changes are round numbers: speeds of 0.1 to
 * 0.5 m/s and turn rates of 0.2 to 1 rad/s, each as often, over 100 s. The middle ones are 0.3 and
 * 0.6, those at 0.7 are 0.4 and 0.8, those from 0.8 on are 0.5 and 1.
 */
final class MotionGround {

  static final double BASE_M = 0.15;
  static final double WHEEL_M = 0.03;
  static final double STEP_S = 0.02;
  static final double LOG_S = 100;

  private static final Commands TOLD =
      new Commands(
          new double[] {0, 1, 2, 3, 4},
          new double[] {0.1, 0.2, 0.3, 0.4, 0.5},
          new double[] {0.2, 0.4, 0.6, 0.8, 1});

  private MotionGround() {}

  static Robot robot(boolean differential, boolean separateClocks) {
    return new Robot(
        WHEEL_M, BASE_M, differential, Robot.Beliefs.NONE, Robot.Scatter.NONE, separateClocks);
  }

  static Outing outing(Commands told) {
    return new Outing(
        List.of(new Outing.Run("r", told, new double[] {0, LOG_S}, LOG_S, new Pose(0, 0, 0))));
  }

  static MotionSite site(RandomGenerator chance, double size) {
    return new MotionSite(robot(true, true), outing(TOLD), chance, size);
  }

  /** An effect of a size, with chance that always says the upper one and the middle. */
  static MotionEffect effect(String name, String form, double size) {
    return effect(name, form, size, new FixedChance(0.5));
  }

  static MotionEffect effect(String name, String form, double size, RandomGenerator chance) {
    return MotionVocabulary.draw(name, form, site(chance, size));
  }

  static double number(MotionEffect effect, String name) {
    return (Double) Objects.requireNonNull(effect.parameters().get(name), name);
  }

  /** What becomes of a speed and a turn rate that are told at once. */
  static Speeds heard(MotionEffect effect, double v, double w) {
    return heard(effect, new FixedChance(0.5), new double[] {0}, new double[][] {{v, w}}).at(0);
  }

  static Commands heard(
      MotionEffect effect, RandomGenerator chance, double[] timesS, double[]... speeds) {
    double[] v = new double[speeds.length];
    double[] w = new double[speeds.length];
    for (int i = 0; i < speeds.length; i++) {
      v[i] = speeds[i][0];
      w[i] = speeds[i][1];
    }
    return effect.change().heard().apply(new Commands(timesS, v, w), chance);
  }

  static Acting acting(MotionEffect effect) {
    return acting(effect, new FixedChance(0.5));
  }

  static Acting acting(MotionEffect effect, RandomGenerator chance) {
    Acting acting = effect.change().begin().apply(chance);
    acting.beginRun();
    return acting;
  }

  /** What a change makes of a step, which it returns. */
  static Step moved(MotionEffect effect, Step step) {
    acting(effect).move(step);
    return step;
  }

  /** The speeds of the next step of something that has a memory. */
  static Speeds next(Acting acting, double v, double w) {
    Step step = AnyStep.told(v, w);
    acting.move(step);
    return new Speeds(step.v(), step.w());
  }
}
