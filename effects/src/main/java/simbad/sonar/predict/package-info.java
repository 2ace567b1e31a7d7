/**
 * The nominal model with changes: what it expects of a log, how probable it finds one, what it
 * forecasts, and the sensor that reads as it says. The fitted model and its file.
 */
@NullMarked
package simbad.sonar.predict;

import org.jspecify.annotations.NullMarked;
