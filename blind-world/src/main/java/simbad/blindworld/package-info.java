/**
 * The two programs of the withheld check, one that makes cases with sealed truths and one that
 * scores answers to them. No code is shared with any other room.
 */
@NullMarked
package simbad.blindworld;

import org.jspecify.annotations.NullMarked;
