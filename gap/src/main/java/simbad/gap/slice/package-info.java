/**
 * Slices of a log: pings that have something in common, by bins of one variable or several. Whoever
 * cuts a log cuts it by these.
 */
@NullMarked
package simbad.gap.slice;

import org.jspecify.annotations.NullMarked;
