package simbad.motion.format;

import java.util.List;
import simbad.motion.MotionRun;
import simbad.motion.Robot;

/**
 * What a motion folder holds.
 *
 * @param name of the folder
 * @param robot what the simulator believes
 * @param runs that are to be diagnosed; not empty
 * @param reference runs from when the simulation was trusted, or none
 */
public record MotionData(
    String name, Robot robot, List<MotionRun> runs, List<MotionRun> reference) {
  /** Copies the lists. */
  public MotionData {
    runs = List.copyOf(runs);
    reference = List.copyOf(reference);
  }
}
