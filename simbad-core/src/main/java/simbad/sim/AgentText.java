package simbad.sim;

import java.text.DecimalFormat;
import java.text.DecimalFormatSymbols;
import java.util.Locale;

/** Describes agents in lines of text: metres, seconds, degrees. */
final class AgentText {
  private AgentText() {}

  static String of(SimpleAgent agent) {
    return String.join(
        "\n",
        "class:     " + agent.getClass().getSimpleName(),
        "name:      " + agent.getName(),
        "counter:   " + agent.getCounter(),
        "lifetime:  " + text(agent.getLifeTime()) + " s",
        "collision: " + (agent.collisionDetected() ? "yes" : "no"),
        "x:         " + text(agent.placement().xM()) + " m",
        "y:         " + text(agent.placement().yM()) + " m",
        "z:         " + text(agent.placement().zM()) + " m",
        "heading:   " + text(Math.toDegrees(agent.getHeadingRad())) + " degrees");
  }

  /** Describes what only robots have. */
  static String ofRobot(Agent robot) {
    FrameMeter meter = robot.frameMeter;
    return String.join(
        "\n",
        "odometer:  " + text(robot.getOdometer()) + " m",
        "steps/s:   " + text(meter.fps) + " now",
        "           " + text(meter.fpsSinceStart) + " on average",
        robot.getKinematicModel().toString(threeDigits()));
  }

  private static String text(double number) {
    return threeDigits().format(number);
  }

  private static DecimalFormat threeDigits() {
    return new DecimalFormat("0.000", DecimalFormatSymbols.getInstance(Locale.ROOT));
  }
}
