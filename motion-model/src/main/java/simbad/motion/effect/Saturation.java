package simbad.motion.effect;

import java.util.List;
import java.util.function.DoubleBinaryOperator;
import java.util.stream.DoubleStream;
import simbad.motion.Command;
import simbad.motion.CommandUse;
import simbad.motion.MotionChange;

/** Large commands are cut. */
final class Saturation {
  private static final double NONE = Double.POSITIVE_INFINITY;

  /** A knee as sharp as this is a corner. */
  private static final double HARD = 0.02;

  /** Sizes that are tried, each of which was commanded. */
  private static final int TRIES = 6;

  private static final MotionParameter RIM =
      MotionParameter.smooth("max_speed_m_s", 0.01, 20, NONE, 0.01);

  static final MotionForm SPEED =
      new MotionForm(
          "saturation",
          "saturation: speed",
          List.of(RIM.tried(use -> CommandUse.among(use.speeds(), TRIES))),
          p -> new CommandChange(v -> cut(v, p[0]), w -> w),
          "cut speeds at %s m/s",
          false);
  static final MotionForm TURN =
      new MotionForm(
          "saturation",
          "saturation: turning",
          List.of(
              MotionParameter.smooth("max_turn_rad_s", 0.02, 20, NONE, 0.03)
                  .tried(use -> CommandUse.among(use.turns(), TRIES))),
          p -> new CommandChange(v -> v, w -> cut(w, p[0])),
          "cut turn rates at %s rad/s",
          false);

  /**
   * Speeds that bend towards a limit: a battery that sags and friction that grows with speed. A
   * knee that is softer than half would bend all speeds, which is a scale.
   */
  static final MotionForm SOFT =
      new MotionForm(
          "saturation",
          "saturation: soft",
          List.of(
              RIM.tried(use -> CommandUse.among(use.speeds(), TRIES)),
              MotionParameter.smooth("max_turn_rad_s", 0.02, 20, NONE, 0.03)
                  .tried(use -> CommandUse.among(use.turns(), TRIES)),
              MotionParameter.smooth("softness", 0, 0.5, 0, 0.2).tried(0, 0.12, 0.25, 0.4)),
          p -> new CommandChange(v -> bent(v, p[0], p[2]), w -> bent(w, p[1], p[2])),
          "bend speeds towards a limit of %s m/s",
          false);

  /** Of the greatest speed over the greatest rate that were commanded. */
  private static final double[] SHARES = {0.1, 0.2, 0.35, 0.5, 0.75, 1};

  /**
   * Turning goes first: what the motors have left is for driving, so the greatest speed falls with
   * the rate of turning. A drive of two wheels whose rims reach M turns at w and goes ahead at M -
   * |w| times half its wheel base.
   */
  static final MotionForm TURN_FIRST =
      new MotionForm(
          "saturation",
          "saturation: speed while turning",
          List.of(
              RIM.tried(use -> CommandUse.among(use.speeds(), TRIES)),
              MotionParameter.smooth("lost_m_per_rad", 0, 5, 0, 0.02)
                  .besideTheOneBefore()
                  .tried(Saturation::lost)),
          p ->
              new WholeCommandChange(
                  (v, w) -> cut(v, Math.max(0, p[0] - p[1] * Math.abs(w))), (v, w) -> w),
          "cut speeds at %s m/s, and further while the robot turns",
          false);

  private Saturation() {}

  private static double[] lost(CommandUse use) {
    double[] speeds = use.speeds();
    double[] turns = use.turns();
    return speeds.length == 0 || turns.length == 0
        ? new double[0]
        : DoubleStream.of(SHARES)
            .map(share -> share * speeds[speeds.length - 1] / turns[turns.length - 1])
            .toArray();
  }

  /** Of each wheel by itself. */
  static MotionForm wheels(double wheelBaseM) {
    return new MotionForm(
        "saturation",
        "saturation: wheels",
        List.of(RIM.tried(use -> CommandUse.among(use.rims(), TRIES))),
        p -> new RimChange(wheelBaseM, rim -> cut(rim, p[0])),
        "cut speeds of a wheel at %s m/s",
        false);
  }

  /** Where a wheel would be too fast both are slowed by the same factor: the curve is kept. */
  static MotionForm keepingCurves(double wheelBaseM) {
    return new MotionForm(
        "saturation",
        "saturation: wheels, the curve kept",
        List.of(RIM.tried(use -> CommandUse.among(use.rims(), TRIES))),
        p ->
            new WholeCommandChange(
                (v, w) -> v * slowed(v, w, wheelBaseM, p[0]),
                (v, w) -> w * slowed(v, w, wheelBaseM, p[0])),
        "slow both wheels by one factor where one would go faster than %s m/s",
        false);
  }

  private static double slowed(double speed, double turn, double wheelBaseM, double most) {
    double fastest = Math.abs(speed) + Math.abs(turn) * wheelBaseM / 2;
    return fastest > most ? most / fastest : 1;
  }

  private static double cut(double command, double most) {
    return Math.abs(command) > most ? Math.copySign(most, command) : command;
  }

  /** The limiter of Cann (1980), whose exponent is 1 / softness; 0 is a plain cut. */
  private static double bent(double command, double most, double softness) {
    if (most == NONE || softness < HARD) {
      return cut(command, most);
    }
    double share = Math.pow(Math.abs(command) / most, 1 / softness);
    return command / Math.pow(1 + share, softness);
  }

  /**
   * A change of what is commanded in which speed and turn depend on each other.
   *
   * @param speed from commanded speed, m/s, and rate of turning, rad/s
   * @param turn the same for the rate
   */
  private record WholeCommandChange(DoubleBinaryOperator speed, DoubleBinaryOperator turn)
      implements MotionChange {
    @Override
    public Command commanded(Command command) {
      double newSpeed = speed.applyAsDouble(command.speedMPerS(), command.turnRadPerS());
      double newTurn = turn.applyAsDouble(command.speedMPerS(), command.turnRadPerS());
      boolean same = newSpeed == command.speedMPerS() && newTurn == command.turnRadPerS();
      return same ? command : new Command(command.timeS(), newSpeed, newTurn);
    }
  }
}
