/**
 * The set-up as a reference log shows it, under the level law: how strongly each obstacle answers,
 * how the echo fades with distance and angle, how ranges walk with the level; which of the two laws
 * foretells the reference better where it was not fitted, and how far that one is off.
 */
@NullMarked
package simbad.gap.calibrate;

import org.jspecify.annotations.NullMarked;
