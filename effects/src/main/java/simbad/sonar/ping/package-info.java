/**
 * A ping in stages, and what may be changed at each: where the sensor and the obstacles really are,
 * at which distance an obstacle is lost, what else answers, what is lost, what range is measured,
 * how it is reported. An interface for each stage says what a change does there.
 *
 * <p>Knows no fitting, no files, no display.
 */
@NullMarked
package simbad.sonar.ping;

import org.jspecify.annotations.NullMarked;
