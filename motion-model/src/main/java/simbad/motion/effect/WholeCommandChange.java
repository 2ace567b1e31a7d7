package simbad.motion.effect;

import java.util.function.DoubleBinaryOperator;
import simbad.motion.Command;
import simbad.motion.MotionChange;

/**
 * A change of what is commanded in which speed and turn depend on each other.
 *
 * @param speed from commanded speed, m/s, and rate of turning, rad/s
 * @param turn the same for the rate
 */
record WholeCommandChange(DoubleBinaryOperator speed, DoubleBinaryOperator turn)
    implements MotionChange {
  @Override
  public Command commanded(Command command) {
    double newSpeed = speed.applyAsDouble(command.speedMPerS(), command.turnRadPerS());
    double newTurn = turn.applyAsDouble(command.speedMPerS(), command.turnRadPerS());
    boolean same = newSpeed == command.speedMPerS() && newTurn == command.turnRadPerS();
    return same ? command : new Command(command.timeS(), newSpeed, newTurn);
  }
}
