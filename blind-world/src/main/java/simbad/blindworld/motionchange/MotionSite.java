package simbad.blindworld.motionchange;

import java.util.random.RandomGenerator;
import simbad.blindworld.check.Checks;
import simbad.blindworld.motion.Commands;
import simbad.blindworld.motion.Outing;
import simbad.blindworld.motion.Robot;

/**
 * Where an effect is to be put in: what its size may depend on, and chance. A size is 1 for a
 * practical one and 0 for a change of nothing.
 */
public final class MotionSite {

  private final Robot robot;
  private final Commands typical;
  private final Outing outing;
  private final RandomGenerator random;
  private final double size;

  /** A robot on an outing, of whose first run the commands are typical. */
  public MotionSite(Robot robot, Outing outing, RandomGenerator random, double size) {
    this.robot = robot;
    this.outing = outing;
    this.typical = outing.runs().get(0).commands();
    this.random = random;
    this.size = Checks.notNegative("size", size);
  }

  Robot robot() {
    return robot;
  }

  /** The distance of the wheels. */
  double baseM() {
    return robot.wheelBaseM();
  }

  /** A quantile of the speeds that are told, where it is told to move. */
  double speed(double level) {
    return Math.max(1e-3, typical.speedQuantile(level));
  }

  /** A quantile of the turn rates that are told, where it is told to turn. */
  double turn(double level) {
    return Math.max(1e-3, typical.turnQuantile(level));
  }

  /** How long the log is. */
  double logS() {
    return outing.durationS();
  }

  /** True when the robot is told to go back often enough for it to show. */
  boolean reverses() {
    int changes = 0;
    double last = 0;
    for (int i = 0; i < typical.size(); i++) {
      double v = typical.at(i).vMPerS();
      changes += v * last < 0 ? 1 : 0;
      last = v == 0 ? last : v;
    }
    return changes >= 6;
  }

  double size() {
    return size;
  }

  /** The practical size times the size. */
  double sized(double practical) {
    return practical * size;
  }

  /** The practical size times the size, up or down by chance. */
  double eitherWay(double practical) {
    return random.nextBoolean() ? sized(practical) : -sized(practical);
  }

  /** The same of a factor: 1 + s for longer, 1 / (1 + s) for shorter. */
  double factor(double practical) {
    double factor = 1 + sized(practical);
    return random.nextBoolean() ? factor : 1 / factor;
  }

  double between(double low, double high) {
    return random.nextDouble(low, high);
  }

  RandomGenerator random() {
    return random;
  }
}
