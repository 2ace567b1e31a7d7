/**
 * The changes that a world can hold: every name of the vocabulary in several forms, and changes
 * that no name covers.
 */
@NullMarked
package simbad.blindworld.effect;

import org.jspecify.annotations.NullMarked;
