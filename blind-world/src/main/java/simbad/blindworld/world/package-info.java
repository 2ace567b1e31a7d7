/**
 * What a sonar reads in a world that may differ from what its scene says: geometry, pings,
 * forecasts by repeated simulation. Knows no effect by name and nothing of files but how a number
 * is written.
 */
@NullMarked
package simbad.blindworld.world;

import org.jspecify.annotations.NullMarked;
