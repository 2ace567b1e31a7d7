/**
 * The frame: points, directions and poses on the plane that a robot drives on.
 *
 * <p>Simbad's world as seen from above: x to the right, z down the page, y towards the eye; metres
 * and radians. Headings, turns and bearings are positive counter-clockwise as seen so. A heading h
 * points along (x, z) = (cos h, -sin h). Headings, bearings and off-axis angles are types of their
 * own so that none is taken for another; degrees exist only in file names of columns and on
 * screens.
 *
 * <p>This package knows nothing of sensors, obstacles or files.
 */
@NullMarked
package simbad.sonar.frame;

import org.jspecify.annotations.NullMarked;
