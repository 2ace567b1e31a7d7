package simbad.gap.calibrate;

import java.util.ArrayList;
import java.util.List;
import simbad.sonar.ping.Change;
import simbad.sonar.ping.Geometry;
import simbad.sonar.ping.LevelChange;
import simbad.sonar.ping.LevelEars;

/**
 * Echoes that are stronger by so much in each ping: of a set-up that has moved.
 *
 * @param byPing decibels
 */
@SuppressWarnings("ArrayRecordComponent") // read only
record LevelShift(double[] byPing) implements LevelChange {
  @Override
  public double addedDb(LevelEars ears, Geometry geometry, int line) {
    return byPing[line / geometry.obstacles()];
  }

  /** Returns this beside other changes. */
  List<Change> and(List<Change> changes) {
    List<Change> all = new ArrayList<>(changes);
    all.add(this);
    return all;
  }
}
