/**
 * What a set of effects leaves unexplained: readings that it got wrong, slices of the log in which
 * it is off, and how probable these make something that has no name among the effects.
 */
@NullMarked
package simbad.gap.unexplained;

import org.jspecify.annotations.NullMarked;
