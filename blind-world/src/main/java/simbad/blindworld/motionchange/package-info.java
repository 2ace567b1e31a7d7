/**
 * What can be at work in a robot's motion: the vocabulary's effects and what it has no name for.
 */
@NullMarked
package simbad.blindworld.motionchange;

import org.jspecify.annotations.NullMarked;
