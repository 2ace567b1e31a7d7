package simbad.motion.effect;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import simbad.motion.Robot;

/** The catalogue: every form of every effect that changes the mean motion, simplest first. */
public final class MotionForms {
  /** All forms. What makes motion scatter more is not among them: it has no mean to change. */
  public static final List<MotionForm> ALL =
      List.of(
          Scale.SPEED,
          Scale.TURN,
          Scale.WHEELS,
          Scale.SPEED_GROWING,
          Scale.TURN_GROWING,
          Veer.BIAS,
          Veer.ASYMMETRY,
          Veer.ONE_WHEEL,
          Delay.LATENCY,
          Delay.CLOCKS,
          Lag.CONSTANTS,
          Lag.BRAKING,
          Lag.BRAKING_BACK,
          Lag.ACCELERATION,
          Lag.SECOND,
          Lag.SECOND_BACK,
          Lag.SECOND_ACCELERATION,
          DeadBand.FORM,
          DeadBand.LESS,
          DeadBand.STICKS,
          Saturation.SPEED,
          Saturation.TURN,
          Saturation.TURN_FIRST,
          Saturation.SOFT,
          Quantization.FORM,
          Quantization.CUT,
          CaptureOffset.POINT,
          CaptureOffset.HEADING);

  /** What any robot may be off by a little: scales, turning that nobody asked for, lateness. */
  public static final List<MotionForm> PLAIN =
      List.of(Scale.SPEED, Scale.TURN, Veer.BIAS, Veer.ASYMMETRY, Delay.LATENCY, Lag.CONSTANTS);

  /** A factor of the speed, and one of turning, in this order. */
  public static final List<MotionForm> SCALES = List.of(Scale.SPEED, Scale.TURN);

  /** Motion that scatters more than believed. */
  public static final String MOTION_NOISE = "motion-noise";

  /** Now and then less way than commanded. */
  public static final String SLIP = "slip";

  private static final Map<String, String> HAPPENS =
      Map.ofEntries(
          Map.entry("speed-scale", "the robot drives faster or slower than commanded, by a factor"),
          Map.entry("turn-scale", "the robot turns faster or slower than commanded, by a factor"),
          Map.entry("wheel-scale", "both wheels are larger or smaller than believed"),
          Map.entry("turn-bias", "the robot turns by itself, at a constant rate"),
          Map.entry(
              "wheel-asymmetry",
              "the robot turns by itself while it drives, because one wheel is larger"),
          Map.entry("actuation-latency", "commands act late"),
          Map.entry("actuation-lag", "the speed follows a command only gradually"),
          Map.entry("dead-band", "small commands do nothing, or a part of every speed is lost"),
          Map.entry(
              "saturation",
              "speeds above a limit are cut; the limit may be lower while the robot turns"),
          Map.entry("command-quantization", "speeds come in steps"),
          Map.entry("time-offset", "the clocks of commands and track differ"),
          Map.entry(
              "capture-offset",
              "the tracker follows another point of the robot, or its heading is turned"),
          Map.entry("motion-noise", "the motion scatters more than believed"),
          Map.entry(
              "slip", "now and then the wheels slip: the robot goes less far than commanded"));

  private MotionForms() {}

  /**
   * Returns the forms that a robot may show: those of its wheels too where it is commanded by them.
   *
   * @param robot what is believed of it
   */
  public static List<MotionForm> of(Robot robot) {
    if (!robot.differential()) {
      return ALL;
    }
    List<MotionForm> forms = new ArrayList<>(ALL);
    forms.add(Lag.wheels(robot.wheelBaseM()));
    forms.add(DeadBand.wheels(robot.wheelBaseM()));
    forms.add(Saturation.wheels(robot.wheelBaseM()));
    forms.add(Saturation.keepingCurves(robot.wheelBaseM()));
    forms.add(Quantization.wheels(robot.wheelBaseM()));
    return forms;
  }

  /** Returns every name of the vocabulary of motion. */
  public static List<String> vocabulary() {
    return Stream.concat(ALL.stream().map(MotionForm::effect), Stream.of(SLIP, MOTION_NOISE))
        .distinct()
        .toList();
  }

  /**
   * Says in a few words what happens.
   *
   * @param effect a name of the {@link #vocabulary}
   * @throws IllegalArgumentException for any other name
   */
  public static String happens(String effect) {
    String happens = HAPPENS.get(effect);
    if (happens == null) {
      throw new IllegalArgumentException("'" + effect + "' is not the name of an effect of motion");
    }
    return happens;
  }

  /**
   * Finds a form that any robot may show.
   *
   * @param form its own name
   */
  public static Optional<MotionForm> find(String form) {
    return ALL.stream().filter(one -> one.form().equals(form)).findFirst();
  }

  /**
   * Finds a form of a robot.
   *
   * @param form its own name
   * @param robot what is believed of it
   */
  public static Optional<MotionForm> find(String form, Robot robot) {
    return of(robot).stream().filter(one -> one.form().equals(form)).findFirst();
  }
}
