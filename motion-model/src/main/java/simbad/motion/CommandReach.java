package simbad.motion;

import java.util.List;
import simbad.sonar.check.Checks;

/**
 * How far the commands of a log reach: beyond them nothing is known of a robot.
 *
 * @param speedMPerS greatest size of a commanded speed, infinite where nothing bounds it
 * @param turnRadPerS the same of the rate of turning
 */
public record CommandReach(double speedMPerS, double turnRadPerS) {
  /** All commands alike: nothing is known of a log. */
  public static final CommandReach ANY =
      new CommandReach(Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY);

  /** Commands that are larger by rounding alone are not beyond. */
  private static final double ROUNDING = 1e-6;

  /** Checks the sizes. */
  public CommandReach {
    Checks.notNegativeOrInfinite("speedMPerS", speedMPerS);
    Checks.notNegativeOrInfinite("turnRadPerS", turnRadPerS);
  }

  /** Looks through the commands of runs; of none both sizes are 0. */
  public static CommandReach of(List<MotionRun> runs) {
    double speed = 0;
    double turn = 0;
    for (MotionRun run : runs) {
      for (Command command : run.commands()) {
        speed = Math.max(speed, Math.abs(command.speedMPerS()));
        turn = Math.max(turn, Math.abs(command.turnRadPerS()));
      }
    }
    return new CommandReach(speed, turn);
  }

  /** Tells whether commands of up to these sizes lie within. */
  public boolean holds(double upToMPerS, double upToRadPerS) {
    return upToMPerS <= speedMPerS + ROUNDING && upToRadPerS <= turnRadPerS + ROUNDING;
  }
}
