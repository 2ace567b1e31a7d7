package simbad.gap.diagnosis;

import java.util.List;
import simbad.definition.Effect;
import simbad.sonar.check.Checks;
import simbad.sonar.sensing.ReadingRow;

/**
 * What to measure next so that effects that are tied come apart.
 *
 * @param separates the tied effects
 * @param poses where to ping, in the order to drive them
 * @param expectedLogOdds nats that those pings are expected to bring between the two, the less
 *     favourable truth assumed
 */
public record NextExperiment(
    List<Effect> separates, List<ReadingRow> poses, double expectedLogOdds) {
  /** Copies the lists. */
  public NextExperiment {
    Checks.number("expectedLogOdds", expectedLogOdds);
    separates = List.copyOf(separates);
    poses = List.copyOf(poses);
  }
}
