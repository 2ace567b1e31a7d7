/**
 * What changes in a world of waves between its calibration and its readings: by the vocabulary's
 * names and outside it, as things that happen to sonar, air, obstacles, timer and robot.
 */
@NullMarked
package simbad.blindworld.wavechange;

import org.jspecify.annotations.NullMarked;
