package simbad.motion.effect;

import java.util.List;
import simbad.motion.Command;
import simbad.motion.CommandUse;
import simbad.motion.MotionChange;

/** Small commands do nothing. */
final class DeadBand {
  /** Values that are tried, each between two sizes that were commanded. */
  private static final int TRIES = 24;

  private static final MotionParameter SPEED =
      MotionParameter.smooth("dead_band_m_s", 0, 1, 0, 0.01).inSteps();

  private static final MotionParameter TURN =
      MotionParameter.smooth("dead_band_rad_s", 0, 3, 0, 0.03).inSteps();

  static final MotionForm FORM =
      new MotionForm(
          "dead-band",
          "dead-band",
          List.of(
              SPEED.tried(use -> CommandUse.between(use.speeds(), TRIES)),
              TURN.tried(use -> CommandUse.between(use.turns(), TRIES))),
          p -> new CommandChange(v -> cut(v, p[0]), w -> cut(w, p[1])),
          "commands below %s m/s do nothing: do not use them",
          false);

  /** What friction takes away is missing from larger commands, too. */
  static final MotionForm LESS =
      new MotionForm(
          "dead-band",
          "dead-band: less by it",
          List.of(
              MotionParameter.smooth("dead_band_m_s", 0, 1, 0, 0.01).tried(0.01, 0.05),
              MotionParameter.smooth("dead_band_rad_s", 0, 3, 0, 0.03).tried(0.03, 0.1)),
          p -> new CommandChange(v -> less(v, p[0]), w -> less(w, p[1])),
          "every speed is %s m/s too low: command that much more",
          false);

  /** Friction at rest: what has started goes on at a command that would not start it. */
  static final MotionForm STICKS =
      new MotionForm(
          "dead-band",
          "dead-band: sticks",
          List.of(
              SPEED.tried(use -> CommandUse.between(use.speeds(), TRIES)),
              TURN.tried(use -> CommandUse.between(use.turns(), TRIES)),
              MotionParameter.smooth("stops_at_share", 0, 1, 1, Double.POSITIVE_INFINITY)
                  .inSteps()
                  .tried(0.4, 0.6, 0.8)),
          p -> new Sticking(p[0], p[1], p[2]),
          "commands below %s m/s do not start it: begin with more",
          false);

  private DeadBand() {}

  /**
   * What sticks until it is pushed.
   *
   * @param speedMPerS least that starts the way
   * @param turnRadPerS least that starts a turn
   * @param share of it at which it stops again
   */
  private record Sticking(double speedMPerS, double turnRadPerS, double share)
      implements MotionChange {
    @Override
    public boolean remembers() {
      return true;
    }

    @Override
    public Command commanded(Command command) {
      return commanded(command, Command.STAND);
    }

    @Override
    public Command commanded(Command command, Command before) {
      double speed = moved(command.speedMPerS(), before.speedMPerS(), speedMPerS);
      double turn = moved(command.turnRadPerS(), before.turnRadPerS(), turnRadPerS);
      boolean same = speed == command.speedMPerS() && turn == command.turnRadPerS();
      return same ? command : new Command(command.timeS(), speed, turn);
    }

    private double moved(double command, double before, double band) {
      return cut(command, before == 0 ? band : share * band);
    }
  }

  /** Of each wheel by itself. */
  static MotionForm wheels(double wheelBaseM) {
    return new MotionForm(
        "dead-band",
        "dead-band: wheels",
        List.of(SPEED.tried(use -> CommandUse.between(use.rims(), TRIES))),
        p -> new RimChange(wheelBaseM, rim -> cut(rim, p[0])),
        "wheel speeds below %s m/s do nothing: do not use them",
        false);
  }

  private static double cut(double command, double band) {
    return Math.abs(command) < band ? 0 : command;
  }

  private static double less(double command, double band) {
    return Math.copySign(Math.max(0, Math.abs(command) - band), command);
  }
}
