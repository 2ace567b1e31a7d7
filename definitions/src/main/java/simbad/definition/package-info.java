/**
 * What every effect has, whether it is one of a sensor or of a robot's motion: a name, parameters
 * with bounds, and traits that a search has to know. Knows the JDK only.
 */
@NullMarked
package simbad.definition;

import org.jspecify.annotations.NullMarked;
