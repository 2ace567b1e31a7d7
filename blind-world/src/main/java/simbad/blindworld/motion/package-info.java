/**
 * How a robot moves that is told speeds: commands, what becomes of them on the way to the wheels,
 * the way over the floor, and what a tracker says of it. Written from physics and the format's
 * text; shares no code with any diagnosis. The same seed gives the same bytes.
 */
@NullMarked
package simbad.blindworld.motion;

import org.jspecify.annotations.NullMarked;
