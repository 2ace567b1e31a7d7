package simbad.blindworld.motionchange;

import static simbad.blindworld.motion.MotionChange.steps;

import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import simbad.blindworld.motion.MotionChange;
import simbad.blindworld.motion.MotionChange.Stage;
import simbad.blindworld.motion.Step;
import simbad.blindworld.motionchange.MotionForm.Drawn;

/**
 * Effects of wheels and of turning: speed-scale, turn-scale, wheel-scale, wheel-asymmetry,
 * turn-bias.
 */
final class ScaleForms {

  private ScaleForms() {}

  static List<MotionForm> all() {
    return List.of(
        MotionForm.anywhere("speed-scale", "factor", ScaleForms::speed),
        MotionForm.anywhere("speed-scale", "with a ripple", ScaleForms::speedRipple),
        MotionForm.anywhere("speed-scale", "more when fast", ScaleForms::speedWhenFast),
        MotionForm.anywhere("turn-scale", "factor", ScaleForms::turn),
        MotionForm.differential("turn-scale", "wheel base", ScaleForms::wheelBase),
        MotionForm.anywhere("turn-scale", "more when turning fast", ScaleForms::turnWhenFast),
        MotionForm.anywhere("wheel-scale", "factor", ScaleForms::wheels),
        MotionForm.anywhere("wheel-scale", "out of round", ScaleForms::wheelsRipple),
        MotionForm.differential("wheel-asymmetry", "radii", ScaleForms::radii),
        MotionForm.anywhere("wheel-asymmetry", "curvature", ScaleForms::curvature),
        MotionForm.anywhere("wheel-asymmetry", "a soft tyre", ScaleForms::softTyre),
        MotionForm.anywhere("turn-bias", "always", ScaleForms::biasAlways),
        MotionForm.anywhere("turn-bias", "while it drives", ScaleForms::biasDriving),
        MotionForm.anywhere("turn-bias", "a gyro that is held", ScaleForms::biasGyro));
  }

  private static Drawn scaled(double factor, Consumer<Step> rule) {
    return new Drawn(Map.of("factor", factor), steps(Stage.WHEEL, rule));
  }

  private static Drawn speed(MotionSite site) {
    double factor = site.factor(0.06);
    return scaled(factor, step -> step.scale(factor, 1));
  }

  /** Once in each turn of the wheels a third more and a third less of what is too much. */
  private static Drawn speedRipple(MotionSite site) {
    double factor = site.factor(0.06);
    double round = 2 * Math.PI * site.robot().wheelRadiusM();
    return scaled(factor, step -> step.scale(ripple(step, factor, round), 1));
  }

  private static double ripple(Step step, double factor, double roundM) {
    double phase = 2 * Math.PI * step.wayM() / roundM;
    return 1 + (factor - 1) * (1 + StrictMath.cos(phase) / 3);
  }

  /** Seven tenths of what is too much at rest, thirteen at the greatest speed. */
  private static Drawn speedWhenFast(MotionSite site) {
    double factor = site.factor(0.06);
    double most = site.speed(1);
    return scaled(
        factor,
        step ->
            step.scale(1 + (factor - 1) * (0.7 + 0.6 * Math.min(1, Math.abs(step.v()) / most)), 1));
  }

  private static Drawn turn(MotionSite site) {
    double factor = site.factor(0.07);
    return scaled(factor, step -> step.scale(1, factor));
  }

  /** The same rims on another base. */
  private static Drawn wheelBase(MotionSite site) {
    double factor = site.factor(0.07);
    double base = site.baseM() / factor;
    return new Drawn(
        Map.of("base_m", base), steps(Stage.WHEEL, step -> step.scale(1, site.baseM() / base)));
  }

  /** Tyres that scrub: where they touch the floor depends on how fast it turns. */
  private static Drawn turnWhenFast(MotionSite site) {
    double factor = site.factor(0.07);
    double most = site.turn(1);
    return scaled(
        factor,
        step ->
            step.scale(1, 1 + (factor - 1) * (0.8 + 0.4 * Math.min(1, Math.abs(step.w()) / most))));
  }

  private static Drawn wheels(MotionSite site) {
    double factor = site.factor(0.06);
    return scaled(factor, step -> step.scale(factor, factor));
  }

  private static Drawn wheelsRipple(MotionSite site) {
    double factor = site.factor(0.06);
    double round = 2 * Math.PI * site.robot().wheelRadiusM();
    return scaled(
        factor,
        step -> {
          double now = ripple(step, factor, round);
          step.scale(now, now);
        });
  }

  /** How much larger the right wheel is: a turn of 0.08 rad in a metre at a practical size. */
  private static double larger(MotionSite site) {
    return site.eitherWay(0.08) * site.baseM();
  }

  private static Drawn radii(MotionSite site) {
    double larger = larger(site);
    return new Drawn(
        Map.of("right_over_left", 1 + larger),
        steps(Stage.WHEEL, step -> step.scaleWheels(1 - larger / 2, 1 + larger / 2, site.baseM())));
  }

  private static Drawn curvature(MotionSite site) {
    double perM = site.eitherWay(0.08);
    return new Drawn(
        Map.of("rad_m", perM), steps(Stage.WHEEL, step -> step.addTurn(perM * step.v())));
  }

  /** A wheel that is pressed flat, with a spot that is less so. */
  private static Drawn softTyre(MotionSite site) {
    double larger = larger(site);
    double round = 2 * Math.PI * site.robot().wheelRadiusM();
    return new Drawn(
        Map.of("right_over_left", 1 + larger),
        steps(
            Stage.WHEEL,
            step -> step.scaleWheels(1, ripple(step, 1 + larger, round), site.baseM())));
  }

  private static double bias(MotionSite site) {
    return site.eitherWay(0.02);
  }

  private static Drawn turning(double perS, MotionChange change) {
    return new Drawn(Map.of("rad_s", perS), change);
  }

  private static Drawn biasAlways(MotionSite site) {
    double perS = bias(site);
    return turning(perS, steps(Stage.TURNING, step -> step.addTurn(perS)));
  }

  private static Drawn biasDriving(MotionSite site) {
    double perS = bias(site);
    return turning(
        perS,
        steps(
            Stage.TURNING,
            step -> step.addTurn(step.wantedV() == 0 && step.wantedW() == 0 ? 0 : perS)));
  }

  /** Holding a heading by a gyro that reads too much, which warms up by a tenth over the log. */
  private static Drawn biasGyro(MotionSite site) {
    double perS = bias(site);
    return turning(
        perS, steps(Stage.TURNING, step -> step.addTurn(perS * (0.95 + 0.1 * step.logShare()))));
  }
}
