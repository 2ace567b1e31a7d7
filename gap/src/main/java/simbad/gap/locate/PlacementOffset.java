package simbad.gap.locate;

import java.util.List;
import simbad.gap.diagnosis.Interval;
import simbad.sonar.check.Checks;

/**
 * How far the echoes of one placement lie from those that were expected, in the middle.
 *
 * @param label its word in the log; its number from 1 where it has none
 * @param distanceM of the echo that the simulator expects there, metres
 * @param pings echoes that were compared, by their number in the log
 * @param beforeM median of the readings less what the simulator expects, metres
 * @param afterM the same of the diagnosed model
 * @param after95 95 % interval of afterM: scatter of the readings and half a step of theirs
 * @param isOff whether it is further from the other placements than these are from each other, and
 *     those beside it are not off to the same side
 */
public record PlacementOffset(
    String label,
    double distanceM,
    List<Integer> pings,
    double beforeM,
    double afterM,
    Interval after95,
    boolean isOff) {
  /** Copies the list and checks that all are numbers. */
  public PlacementOffset {
    Checks.finite("distanceM", distanceM);
    Checks.finite("beforeM", beforeM);
    Checks.finite("afterM", afterM);
    pings = List.copyOf(pings);
  }

  /** Returns how many echoes were compared. */
  public int rows() {
    return pings.size();
  }

  /** Returns half the width of the interval, metres. */
  public double halfM() {
    return (after95.high() - after95.low()) / 2;
  }
}
