package simbad.gap.unexplained;

import com.fasterxml.jackson.databind.JsonNode;
import simbad.gap.constants.FittedConstants;
import simbad.sonar.scene.SensorLaw;

/**
 * The constants that decide: how probable something without a name is by its {@link Signs}, and for
 * how much likelihoods are taken, under either law of hearing. They stand in one file with where
 * they come from, and benchmarks/fit-constants fits them anew.
 *
 * @param threshold those under the threshold rule
 * @param level those under the level law
 */
public record Constants(ThresholdConstants threshold, LevelConstants level) {
  private static final String FORMAT = "simbad-constants/2";
  private static final Constants OWN = of(FittedConstants.of(Constants.class));

  /** Returns those that the diagnosis uses. */
  public static Constants own() {
    return OWN;
  }

  /**
   * Reads constants.
   *
   * @param root of a file of format "simbad-constants/2"
   * @throws IllegalArgumentException if a field is missing or no number
   */
  public static Constants of(JsonNode root) {
    FittedConstants.check(root, FORMAT);
    return new Constants(
        ThresholdConstants.of(root.path("threshold")), LevelConstants.of(root.path("level")));
  }

  /** Returns those under a law. */
  public LawConstants under(SensorLaw.Model law) {
    return law == SensorLaw.Model.LEVEL ? level : threshold;
  }
}
