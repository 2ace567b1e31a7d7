package simbad.motion.effect;

import java.util.function.DoubleUnaryOperator;
import simbad.motion.MotionChange;

/** A change of what is commanded, of speed and turn each by itself. */
record CommandChange(DoubleUnaryOperator speed, DoubleUnaryOperator turn) implements MotionChange {
  @Override
  public double commandedSpeed(double command) {
    return speed.applyAsDouble(command);
  }

  @Override
  public double commandedTurn(double command) {
    return turn.applyAsDouble(command);
  }
}
