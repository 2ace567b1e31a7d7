package simbad.bench.board;

import java.util.List;

/**
 * Decides what the simulated board meets. Called by one thread, while simulated time stands still;
 * it goes on when the method returns.
 */
public interface BoardWorld {
  /**
   * The sensor was triggered.
   *
   * @param number of the ping, from 1; counts what the sensor took, whatever the program counts
   * @param timeS simulated seconds since the start
   * @return what is to be done before the burst leaves, in this order
   */
  List<BoardOrder> ping(long number, double timeS);

  /**
   * A time that {@link BoardOrder#wakeAt} asked for has come, or the simulation begins.
   *
   * @param timeS simulated seconds since the start; 0 at the beginning
   * @return what is to be done now, in this order
   */
  default List<BoardOrder> wake(double timeS) {
    return List.of();
  }

  /**
   * Tells how long the sensor's pulse is.
   *
   * @param number of the ping
   * @param pulseS seconds
   */
  default void pulse(long number, double pulseS) {}

  /**
   * Tells that a trigger was too short for the sensor.
   *
   * @param timeS simulated seconds since the start
   * @param triggerS how long it was, in seconds
   */
  default void refused(double timeS, double triggerS) {}
}
