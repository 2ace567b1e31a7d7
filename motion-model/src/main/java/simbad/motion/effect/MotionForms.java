package simbad.motion.effect;

import java.util.List;
import java.util.Optional;

/** The catalogue: every form of every effect that changes the mean motion, simplest first. */
public final class MotionForms {
  /** All forms. What makes motion scatter more is not among them: it has no mean to change. */
  public static final List<MotionForm> ALL =
      List.of(
          Scale.SPEED,
          Scale.TURN,
          Scale.WHEELS,
          Veer.BIAS,
          Veer.ASYMMETRY,
          Delay.LATENCY,
          Delay.CLOCKS,
          Lag.CONSTANTS,
          Lag.BRAKING,
          Lag.ACCELERATION,
          DeadBand.FORM,
          Saturation.SPEED,
          Saturation.TURN,
          Quantization.FORM,
          CaptureOffset.POINT,
          CaptureOffset.HEADING);

  /** Motion that scatters more than believed. */
  public static final String MOTION_NOISE = "motion-noise";

  /** Now and then less way than commanded. */
  public static final String SLIP = "slip";

  private MotionForms() {}

  /**
   * Finds a form.
   *
   * @param form its own name
   */
  public static Optional<MotionForm> find(String form) {
    return ALL.stream().filter(one -> one.form().equals(form)).findFirst();
  }
}
