package simbad.sonar.scene;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import simbad.sonar.check.Checks;
import simbad.sonar.frame.Placement;

/**
 * What a scene of the second format says beside sensor and obstacles.
 *
 * @param poseSigmaM standard deviation of the readings' places, metres, at least 0
 * @param headingSigmaRad standard deviation of their headings, radians, at least 0
 * @param robotFromSensor the mounts of the sensors by their names, where the readings carry the
 *     robot's pose: x forward, z to the right, turned counter-clockwise; empty where they carry the
 *     sensor's own
 * @param temperatureCompensated whether the sensor's ranges are; empty where that is not known
 * @param assumptions sentences for people; nothing reads them
 */
public record SetupDetails(
    double poseSigmaM,
    double headingSigmaRad,
    Map<String, Placement> robotFromSensor,
    Optional<Boolean> temperatureCompensated,
    List<String> assumptions) {
  /** Nothing is said. */
  public static final SetupDetails NONE =
      new SetupDetails(0, 0, Map.of(), Optional.empty(), List.of());

  /** Checks the deviations and copies the collections in their order. */
  public SetupDetails {
    Checks.notNegative("poseSigmaM", poseSigmaM);
    Checks.notNegative("headingSigmaRad", headingSigmaRad);
    robotFromSensor = Collections.unmodifiableMap(new LinkedHashMap<>(robotFromSensor));
    assumptions = List.copyOf(assumptions);
  }

  /** Returns the same with other mounts of the sensors. */
  public SetupDetails mounted(Map<String, Placement> mounts) {
    return new SetupDetails(
        poseSigmaM, headingSigmaRad, mounts, temperatureCompensated, assumptions);
  }
}
