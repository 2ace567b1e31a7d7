package simbad.sonar.sensing;

import simbad.sonar.check.Checks;
import simbad.sonar.frame.Pose;

/**
 * One reading of one sensor, with the pose that the bench or the odometry believed.
 *
 * @param run label of one continuous recording
 * @param sensor label of the transducer
 * @param timeS seconds; orders the rows of a run and sensor
 * @param pose of the sensor, as believed; of the robot, where the scene has the sensors' mounts
 * @param reading what was read
 * @param circumstances what else is known of it
 */
public record ReadingRow(
    String run,
    String sensor,
    double timeS,
    Pose pose,
    Reading reading,
    Circumstances circumstances) {

  /** Refuses a time that is no number. */
  public ReadingRow {
    Checks.finite("timeS", timeS);
  }

  /** Creates a row of which nothing else is known. */
  public ReadingRow(String run, String sensor, double timeS, Pose pose, Reading reading) {
    this(run, sensor, timeS, pose, reading, Circumstances.NONE);
  }

  /** Tells whether its time means anything. */
  public boolean isTimed() {
    return circumstances.isTimed();
  }

  /** Returns the same row with another reading. */
  public ReadingRow reading(Reading other) {
    return new ReadingRow(run, sensor, timeS, pose, other, circumstances);
  }

  /** Returns the same reading at another pose, under other circumstances. */
  public ReadingRow at(Pose other, Circumstances there) {
    return new ReadingRow(run, sensor, timeS, other, reading, there);
  }
}
