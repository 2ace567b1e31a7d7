/**
 * Sonars, rooms and obstacles drawn at random, and the user who calibrates a scene in them. The
 * user sees readings only. Knows nothing of what will change.
 */
@NullMarked
package simbad.blindworld.wavesetup;

import org.jspecify.annotations.NullMarked;
