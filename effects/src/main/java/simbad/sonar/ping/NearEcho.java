package simbad.sonar.ping;

import java.util.Optional;

/**
 * Near an obstacle its echo comes from where it adds up, not from its nearest point: a calibration
 * of the set-up, which counts under the level law only.
 *
 * @param only label of the obstacle; empty for all
 * @param field its near field; empty leaves all as it is
 */
public record NearEcho(Optional<String> only, Optional<NearField> field) implements EarChange {}
