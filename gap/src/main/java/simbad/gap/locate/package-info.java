/**
 * Where the gap lies: cuts of a log by distance, bearing, time and the like, and the places in
 * which more is off than elsewhere. Writes no files and draws nothing.
 */
@NullMarked
package simbad.gap.locate;

import org.jspecify.annotations.NullMarked;
