/**
 * How a robot moves when it is commanded: the nominal motion, changes of it, and the way between
 * poses that follows from a log of commands. Knows no sensor, no world and no file.
 *
 * <p>Frame inside: x along, y to the left, angles counter-clockwise; metres, seconds, radians.
 */
@NullMarked
package simbad.motion;

import org.jspecify.annotations.NullMarked;
