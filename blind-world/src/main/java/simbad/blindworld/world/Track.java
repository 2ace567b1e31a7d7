package simbad.blindworld.world;

import java.util.List;

/**
 * The rows of one transducer within one run.
 *
 * @param run the run's label
 * @param sensor the transducer's label
 * @param rows indices into the recording, in the order of time; never empty
 */
public record Track(String run, String sensor, List<Integer> rows) {

  /** Copies the list. */
  public Track {
    rows = List.copyOf(rows);
  }
}
