package simbad.bench.capture;

import java.io.IOException;

/** Brings the obstacle where it is wanted: a machine, or a person who is told. */
@FunctionalInterface
public interface ObstacleStage {
  /**
   * Places the obstacle; returns when it stands.
   *
   * @param bearingDeg how far it is turned clockwise, seen from above, degrees
   * @param distanceM from the sensor to its axis of rotation, straight ahead, metres
   * @throws IOException if it cannot
   * @throws InterruptedException if the thread is interrupted meanwhile
   */
  void place(double bearingDeg, double distanceM) throws IOException, InterruptedException;
}
