/**
 * The level law as a reference log shows it: how strongly each obstacle answers, how the echo fades
 * with distance and angle, how ranges change with the level of the echo; and how far the reference
 * leaves each of these open.
 */
@NullMarked
package simbad.gap.calibrate.level;

import org.jspecify.annotations.NullMarked;
