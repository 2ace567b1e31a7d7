package simbad.bench.board;

import java.util.Locale;
import simbad.sonar.check.Checks;

/**
 * One thing that the simulated board is told; firmware-pic18/gpsim/commands.h lists them.
 *
 * @param text one line
 */
public record BoardOrder(String text) {
  private static final double MICROSECONDS = 1e6;

  /**
   * Puts what answers at a distance.
   *
   * @param distanceM metres, at least 0
   */
  public static BoardOrder distance(double distanceM) {
    return number("distance", "distanceM", distanceM);
  }

  /** Lets nothing answer. */
  public static BoardOrder nothing() {
    return new BoardOrder("distance none");
  }

  /**
   * Sets the temperature of the air.
   *
   * @param temperatureC degrees Celsius, at least -273
   */
  public static BoardOrder temperature(double temperatureC) {
    Checks.atLeast("temperatureC", temperatureC, -273);
    return new BoardOrder("temperature " + decimal(temperatureC));
  }

  /** Sets what is wrong with the sensor's line. */
  public static BoardOrder fault(SensorFault fault) {
    return new BoardOrder("fault " + fault.order());
  }

  /**
   * Sets the shortest trigger that the sensor takes.
   *
   * @param durationS seconds, at least 0; 10 microseconds to begin with
   */
  public static BoardOrder leastTrigger(double durationS) {
    return number("trigger", "durationS", durationS * MICROSECONDS);
  }

  /**
   * Resets the processor.
   *
   * @param cause of the reset
   * @param delayS simulated seconds from now, at least 0
   */
  public static BoardOrder reset(ResetCause cause, double delayS) {
    return number("reset " + cause.word(), "delayS", delayS * MICROSECONDS);
  }

  /**
   * Puts bytes on the serial line that nobody sent, the same ones every time.
   *
   * @param count at least 0
   */
  public static BoardOrder garbage(int count) {
    return number("garbage", "count", count);
  }

  /**
   * Sets the speed of the line's far end.
   *
   * @param baud bits per second, at least 1
   */
  public static BoardOrder baud(double baud) {
    return number("baud", "baud", baud);
  }

  /**
   * Lets the far end hear nothing for a while.
   *
   * @param durationS simulated seconds from now, at least 0
   */
  public static BoardOrder silence(double durationS) {
    return number("silence", "durationS", durationS * MICROSECONDS);
  }

  /**
   * Sets how fast simulated time passes.
   *
   * @param factor simulated per real second; 0 for as fast as it goes
   */
  public static BoardOrder pace(double factor) {
    return number("pace", "factor", factor);
  }

  /**
   * Asks for {@link BoardWorld#wake}.
   *
   * @param timeS simulated time, at least 0; now if it is past
   */
  public static BoardOrder wakeAt(double timeS) {
    return number("wake", "timeS", timeS * MICROSECONDS);
  }

  /** Ends the simulation. */
  public static BoardOrder stop() {
    return new BoardOrder("stop");
  }

  private static BoardOrder number(String order, String name, double value) {
    Checks.notNegative(name, value);
    return new BoardOrder(order + " " + decimal(value));
  }

  private static String decimal(double value) {
    return String.format(Locale.ROOT, "%.9f", value);
  }
}
