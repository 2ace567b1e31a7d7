package simbad.motion.effect;

import java.util.function.DoubleUnaryOperator;
import simbad.motion.Command;
import simbad.motion.MotionChange;
import simbad.motion.Unicycle;

/** A change of what each wheel's rim is commanded. */
record RimChange(double wheelBaseM, DoubleUnaryOperator rim) implements MotionChange {
  @Override
  public Command commanded(Command command) {
    double half = command.turnRadPerS() * wheelBaseM / 2;
    double left = command.speedMPerS() - half;
    double right = command.speedMPerS() + half;
    double newLeft = rim.applyAsDouble(left);
    double newRight = rim.applyAsDouble(right);
    if (newLeft == left && newRight == right) {
      return command;
    }
    return new Command(
        command.timeS(),
        Unicycle.speedOfWheels(newLeft, newRight),
        Unicycle.turnOfWheels(newLeft, newRight, wheelBaseM));
  }
}
