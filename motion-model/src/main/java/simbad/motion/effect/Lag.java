package simbad.motion.effect;

import java.util.List;
import java.util.function.Function;
import simbad.motion.MotionChange;
import simbad.motion.Response;

/**
 * Speeds that approach the command gradually.
 *
 * @param own response, beside what was believed already
 * @param inSeries whether it follows what was believed instead of adding to it
 */
record Lag(Response own, boolean inSeries) implements MotionChange {
  private static final double NO_LIMIT = Double.POSITIVE_INFINITY;

  private static final List<MotionParameter> FIRST =
      List.of(constant("speed"), constant("turn"), braking("braking_factor"));

  private static final List<MotionParameter> BEHIND =
      List.of(constant("second_speed"), constant("second_turn"), braking("second_braking_factor"));

  private static final String BRAKES =
      "let the speed follow commands with a time constant of %s s, and with a different one while "
          + "braking";
  private static final String FOLLOWS =
      "let a second lag follow the first, with a time constant of %s s";

  static final MotionForm CONSTANTS =
      form(
          "time constants",
          FIRST.subList(0, 2),
          p -> new Lag(constants(p[0], p[1], 1, false), false),
          "let the speed follow commands with a time constant of %s s");

  static final MotionForm BRAKING =
      form(
          "other in braking",
          FIRST,
          p -> new Lag(constants(p[0], p[1], p[2], false), false),
          BRAKES);

  /** Whether a motor that is told to turn back brakes down to rest first differs between drives. */
  static final MotionForm BRAKING_BACK =
      form(
          "other in braking, also to turn back",
          FIRST,
          p -> new Lag(constants(p[0], p[1], p[2], true), false),
          BRAKES);

  static final MotionForm ACCELERATION =
      form(
          "greatest acceleration",
          List.of(acceleration(""), turnAcceleration("")),
          p -> new Lag(limits(p[0], p[1]), false),
          "limit accelerations to %s m/s2");

  /**
   * A motor behind a controller that is slow itself: two lags in series are one of second order.
   */
  static final MotionForm SECOND =
      form("a second one", BEHIND, p -> new Lag(constants(p[0], p[1], p[2], false), true), FOLLOWS);

  static final MotionForm SECOND_BACK =
      form(
          "a second one, braking also to turn back",
          BEHIND,
          p -> new Lag(constants(p[0], p[1], p[2], true), true),
          FOLLOWS);

  static final MotionForm SECOND_ACCELERATION =
      form(
          "a second one, greatest acceleration",
          List.of(acceleration("second_"), turnAcceleration("second_")),
          p -> new Lag(limits(p[0], p[1]), true),
          "limit accelerations of what the first lag gives to %s m/s2");

  /** Each wheel has a motor of its own, which accelerates its rim so much and no more. */
  static MotionForm wheels(double wheelBaseM) {
    return form(
        "greatest acceleration of a wheel",
        List.of(acceleration("")),
        p -> new Lag(rims(p[0], wheelBaseM), true),
        "limit the acceleration of each wheel's rim to %s m/s2");
  }

  private static MotionForm form(
      String name,
      List<MotionParameter> parameters,
      Function<double[], MotionChange> maker,
      String remedy) {
    return new MotionForm(
        "actuation-lag", "actuation-lag: " + name, parameters, maker, remedy, false);
  }

  private static MotionParameter constant(String of) {
    return MotionParameter.smooth(of + "_time_constant_s", 0, 3, 0, 0.03).tried(0.05, 0.15, 0.4);
  }

  private static MotionParameter braking(String name) {
    return MotionParameter.smooth(name, 0.05, 20, 1, NO_LIMIT).tried(0.4, 1, 2.5);
  }

  private static MotionParameter acceleration(String of) {
    return MotionParameter.smooth(of + "acceleration_m_s2", 0.01, 100, NO_LIMIT, 0.02)
        .tried(2, 1, 0.5, 0.25, 0.1);
  }

  private static MotionParameter turnAcceleration(String of) {
    return MotionParameter.smooth(of + "turn_acceleration_rad_s2", 0.05, 1000, NO_LIMIT, 0.1)
        .tried(10, 5, 2.5, 1, 0.5);
  }

  private static Response constants(
      double speedS, double turnS, double brakingFactor, boolean toTurnBack) {
    boolean differs = brakingFactor != 1;
    return new Response(speedS, turnS, brakingFactor, NO_LIMIT, NO_LIMIT, toTurnBack && differs, 0);
  }

  private static Response limits(double acceleration, double turnAcceleration) {
    return new Response(0, 0, 1, acceleration, turnAcceleration, false, 0);
  }

  private static Response rims(double acceleration, double wheelBaseM) {
    return acceleration < NO_LIMIT
        ? new Response(0, 0, 1, acceleration, NO_LIMIT, false, wheelBaseM)
        : Response.AT_ONCE;
  }

  @Override
  public Response response(Response before) {
    if (inSeries) {
      return before;
    }
    return new Response(
        before.speedTimeConstantS() + own.speedTimeConstantS(),
        before.turnTimeConstantS() + own.turnTimeConstantS(),
        before.brakingFactor() * own.brakingFactor(),
        Math.min(before.maxAccelerationMPerS2(), own.maxAccelerationMPerS2()),
        Math.min(before.maxTurnAccelerationRadPerS2(), own.maxTurnAccelerationRadPerS2()),
        before.brakesToTurnBack() || own.brakesToTurnBack(),
        before.rimBaseM());
  }

  @Override
  public Response then() {
    return inSeries ? own : Response.AT_ONCE;
  }
}
