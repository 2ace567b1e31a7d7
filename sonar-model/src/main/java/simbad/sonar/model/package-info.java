/**
 * What a sonar reads of a scene: the nominal model with its probabilities, and the sensors that a
 * belt can take.
 *
 * <p>This is the one implementation of the nominal model; the belt in the world, the simulated
 * board and the diagnosis all ask it. It knows no files, no simulator and no display.
 */
@NullMarked
package simbad.sonar.model;

import org.jspecify.annotations.NullMarked;
