package simbad.gap.motion;

import java.util.Locale;
import java.util.OptionalDouble;
import simbad.gap.diagnosis.Interval;
import simbad.motion.Robot;

/** What to do about wheels of two sizes: which one, and by how much. */
final class WheelRemedy {
  private static final String EFFECT = "wheel-asymmetry";
  private static final String BASE = "signed_base_m";

  /** A base that is known no better, as a share of it, tells no size. */
  private static final double VAGUE = 0.25;

  private WheelRemedy() {}

  /**
   * Returns a finding whose remedy says the wheel, where it is about one and the base is known.
   *
   * @param finding of any effect
   * @param robot as it is believed
   */
  static MotionFinding of(MotionFinding finding, Robot robot) {
    if (!finding.effect().equals(EFFECT) || finding.parameters().isEmpty()) {
      return finding;
    }
    double perMetre = finding.parameters().get(0).value();
    boolean isOne =
        finding.parameters().size() == 2 && finding.parameters().get(1).name().equals(BASE);
    if (isOne) {
      OptionalDouble base = base(finding.parameters().get(1), robot);
      return base.isPresent() ? finding.with(oneWheel(perMetre, base.getAsDouble())) : finding;
    }
    return finding.parameters().size() == 1 && robot.wheelBaseM() > 0
        ? finding.with(finding.remedy() + bothWheels(perMetre, robot.wheelBaseM()))
        : finding;
  }

  /** Above 0 the right wheel is meant, below 0 the left one. */
  private static OptionalDouble base(MotionFinding.Parameter fitted, Robot robot) {
    Interval ci95 = fitted.ci95();
    boolean isSided = ci95.low() > 0 || ci95.high() < 0;
    boolean isExact = ci95.high() - ci95.low() < 2 * VAGUE * Math.abs(fitted.value());
    if (isSided && robot.wheelBaseM() > 0) {
      return OptionalDouble.of(Math.copySign(robot.wheelBaseM(), fitted.value()));
    }
    return isSided && isExact ? OptionalDouble.of(fitted.value()) : OptionalDouble.empty();
  }

  private static String oneWheel(double perMetre, double signedBaseM) {
    double larger = perMetre * signedBaseM;
    return String.format(
        Locale.ROOT,
        "make the %s wheel %.2g %% %s, on a base of %.3g m: alone it adds %.4g rad per metre of its"
            + " way to every turn",
        signedBaseM > 0 ? "right" : "left",
        100 * Math.abs(larger),
        larger > 0 ? "larger" : "smaller",
        Math.abs(signedBaseM),
        perMetre);
  }

  private static String bothWheels(double perMetre, double baseM) {
    return String.format(
        Locale.ROOT,
        ": on a base of %.3g m the %s wheel is %.2g %% larger than the other",
        baseM,
        perMetre > 0 ? "right" : "left",
        100 * Math.abs(perMetre * baseM));
  }
}
