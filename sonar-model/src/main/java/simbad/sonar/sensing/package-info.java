/**
 * What a belt and a sensor model say to each other: poses of transducers in, readings out.
 *
 * <p>This package knows nothing of scenes or of how a reading comes about, so that a belt can take
 * any sensor: cones over outlines, thin rays through a simulated world, a fitted diagnosis.
 */
@NullMarked
package simbad.sonar.sensing;

import org.jspecify.annotations.NullMarked;
