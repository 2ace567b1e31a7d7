package simbad.gap.diagnosis;

import java.util.List;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.sensing.ReadingRow;

/**
 * A gap data set: what the simulator believes and what was really read.
 *
 * @param name of its folder
 * @param setup as the simulator believes it
 * @param readings in the file's order
 * @param reference readings taken while the simulation was trusted; empty where there are none
 */
public record DataSet(
    String name, SensingSetup setup, List<ReadingRow> readings, List<ReadingRow> reference) {
  /** Copies the lists. */
  public DataSet {
    readings = List.copyOf(readings);
    reference = List.copyOf(reference);
  }
}
