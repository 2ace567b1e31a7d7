package simbad.blindworld.motionchange;

import static simbad.blindworld.motion.MotionChange.commands;

import java.util.List;
import java.util.Map;
import java.util.random.RandomGenerator;
import simbad.blindworld.motion.Commands;
import simbad.blindworld.motion.Commands.Speeds;
import simbad.blindworld.motion.MotionChange;
import simbad.blindworld.motion.MotionChange.Stage;
import simbad.blindworld.motionchange.MotionForm.Drawn;

/** Effects on what is told: dead-band, saturation, command-quantization. */
final class CommandForms {

  private CommandForms() {}

  static List<MotionForm> all() {
    return List.of(
        MotionForm.anywhere("dead-band", "nothing below", CommandForms::nothingBelow),
        MotionForm.anywhere("dead-band", "less by it", CommandForms::lessBy),
        MotionForm.anywhere("dead-band", "sticks until pushed", CommandForms::sticks),
        MotionForm.differential("dead-band", "of each wheel", CommandForms::deadWheels),
        MotionForm.anywhere("saturation", "hard", CommandForms::hard),
        MotionForm.anywhere("saturation", "soft", CommandForms::soft),
        MotionForm.anywhere("saturation", "of the speed", CommandForms::ofSpeed),
        MotionForm.differential("saturation", "of each wheel", CommandForms::ofWheels),
        MotionForm.differential("saturation", "the curve is kept", CommandForms::keepsCurve),
        MotionForm.anywhere("command-quantization", "rounded", CommandForms::roundedSteps),
        MotionForm.anywhere("command-quantization", "cut", CommandForms::cutSteps),
        MotionForm.differential("command-quantization", "of each wheel", CommandForms::wheelSteps));
  }

  /** The greatest command that does nothing, as a share of a common one. */
  private static double bandV(MotionSite site) {
    return site.sized(0.3) * site.speed(0.5);
  }

  private static double bandW(MotionSite site) {
    return site.sized(0.3) * site.turn(0.5);
  }

  private static Map<String, Object> both(double v, double w) {
    return Map.of("m_s", v, "rad_s", w);
  }

  private static double above(double value, double band) {
    return Math.abs(value) < band ? 0 : value;
  }

  private static Drawn nothingBelow(MotionSite site) {
    double v = bandV(site);
    double w = bandW(site);
    return new Drawn(
        both(v, w), commands(s -> new Speeds(above(s.vMPerS(), v), above(s.wRadPerS(), w))));
  }

  private static double less(double value, double by) {
    return Math.signum(value) * Math.max(0, Math.abs(value) - by);
  }

  private static Drawn lessBy(MotionSite site) {
    double v = bandV(site) / 3;
    double w = bandW(site) / 3;
    return new Drawn(
        both(v, w), commands(s -> new Speeds(less(s.vMPerS(), v), less(s.wRadPerS(), w))));
  }

  /** Friction at rest: starts at a command and stops at two thirds of it. */
  private static Drawn sticks(MotionSite site) {
    double v = bandV(site);
    double w = bandW(site);
    return new Drawn(
        both(v, w), MotionChange.heard(Stage.COMMAND, (told, random) -> stuck(told, v, w)));
  }

  private static Commands stuck(Commands told, double v, double w) {
    boolean[] moves = new boolean[2];
    return told.each(
        s -> {
          moves[0] = Math.abs(s.vMPerS()) >= (moves[0] ? v * 2 / 3 : v);
          moves[1] = Math.abs(s.wRadPerS()) >= (moves[1] ? w * 2 / 3 : w);
          return new Speeds(moves[0] ? s.vMPerS() : 0, moves[1] ? s.wRadPerS() : 0);
        });
  }

  private static Drawn deadWheels(MotionSite site) {
    double rim = 0.7 * bandV(site);
    return new Drawn(
        Map.of("rim_m_s", rim), commands(s -> s.rims(site.baseM(), r -> above(r, rim))));
  }

  /** Where commands are cut: from just under the greatest down to two fifths of it. */
  private static double share(MotionSite site) {
    return Math.max(0.4, 1 - site.sized(0.25));
  }

  private static double cut(double value, double most) {
    return Math.max(-most, Math.min(most, value));
  }

  private static Drawn hard(MotionSite site) {
    double v = share(site) * site.speed(1);
    double w = share(site) * site.turn(1);
    return new Drawn(
        both(v, w), commands(s -> new Speeds(cut(s.vMPerS(), v), cut(s.wRadPerS(), w))));
  }

  /** Straight up to half of the level and bent towards it above. */
  private static double bent(double value, double level) {
    double half = level / 2;
    double over = Math.abs(value) - half;
    return over <= 0 ? value : Math.signum(value) * (half + half * StrictMath.tanh(over / half));
  }

  private static Drawn soft(MotionSite site) {
    double v = site.speed(1) * share(site) * 1.15;
    double w = site.turn(1) * share(site) * 1.15;
    return new Drawn(
        both(v, w),
        site.size() > 0
            ? commands(s -> new Speeds(bent(s.vMPerS(), v), bent(s.wRadPerS(), w)))
            : commands(s -> s));
  }

  private static Drawn ofSpeed(MotionSite site) {
    double v = site.speed(1) * share(site);
    return new Drawn(Map.of("m_s", v), commands(s -> new Speeds(cut(s.vMPerS(), v), s.wRadPerS())));
  }

  private static double fastestRim(MotionSite site) {
    return site.speed(1) + site.turn(site.size() > 0 ? 0.5 : 1) * site.baseM() / 2;
  }

  private static Drawn ofWheels(MotionSite site) {
    double rim = share(site) * fastestRim(site);
    return new Drawn(Map.of("rim_m_s", rim), commands(s -> s.rims(site.baseM(), r -> cut(r, rim))));
  }

  /** When one wheel would be too fast both are slowed by the same factor. */
  private static Drawn keepsCurve(MotionSite site) {
    double rim = share(site) * fastestRim(site);
    double base = site.baseM();
    return new Drawn(
        Map.of("rim_m_s", rim),
        commands(
            s -> {
              double fastest = Math.max(Math.abs(s.left(base)), Math.abs(s.right(base)));
              double factor = fastest > rim ? rim / fastest : 1;
              return new Speeds(factor * s.vMPerS(), factor * s.wRadPerS());
            }));
  }

  private static double stepV(MotionSite site) {
    return site.sized(0.35) * site.speed(0.8);
  }

  private static double stepW(MotionSite site) {
    return site.sized(0.35) * site.turn(0.8);
  }

  private static double nearest(double value, double step) {
    return step > 0 ? Math.rint(value / step) * step : value;
  }

  private static double towardsZero(double value, double step) {
    return step > 0 ? Math.signum(value) * Math.floor(Math.abs(value) / step + 1e-9) * step : value;
  }

  private static Drawn roundedSteps(MotionSite site) {
    double v = stepV(site);
    double w = stepW(site);
    return new Drawn(
        both(v, w), commands(s -> new Speeds(nearest(s.vMPerS(), v), nearest(s.wRadPerS(), w))));
  }

  private static Drawn cutSteps(MotionSite site) {
    double v = stepV(site) / 2;
    double w = stepW(site) / 2;
    return new Drawn(
        both(v, w),
        commands(s -> new Speeds(towardsZero(s.vMPerS(), v), towardsZero(s.wRadPerS(), w))));
  }

  private static Drawn wheelSteps(MotionSite site) {
    double rim = stepV(site) * 0.8;
    return new Drawn(
        Map.of("rim_m_s", rim), commands(s -> s.rims(site.baseM(), r -> nearest(r, rim))));
  }

  /** A share of the commands is not heard, so that the one before is kept. */
  static MotionChange dropped(double share) {
    return MotionChange.heard(Stage.COMMAND, (told, random) -> kept(told, share, random));
  }

  private static Commands kept(Commands told, double share, RandomGenerator random) {
    Speeds[] last = {Speeds.ZERO};
    return told.each(
        s -> {
          last[0] = random.nextDouble() < share ? last[0] : s;
          return last[0];
        });
  }
}
