package simbad.sonar.sensing;

import simbad.sonar.frame.Pose;

/**
 * One reading of one sensor, with the pose that the bench or the odometry believed.
 *
 * @param run label of one continuous recording
 * @param sensor label of the transducer
 * @param timeS seconds; orders the rows of a run and sensor
 * @param pose of the sensor, as believed
 * @param reading what was read
 */
public record ReadingRow(String run, String sensor, double timeS, Pose pose, Reading reading) {}
