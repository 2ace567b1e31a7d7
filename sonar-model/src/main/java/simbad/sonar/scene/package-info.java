/**
 * What a simulator believes: the sensor's figures, the obstacles, where they stand, and at which
 * distance each is lost.
 *
 * <p>Values only; what a sensor makes of a scene is the business of {@code simbad.sonar.model}.
 */
@NullMarked
package simbad.sonar.scene;

import org.jspecify.annotations.NullMarked;
