/**
 * Shapes on the plane: outlines of obstacles, the cone of a sensor, polar threshold tables and the
 * shadows round an obstacle that follow from them.
 *
 * <p>Knows the frame, and nothing of sensors' noise, scenes, files or displays.
 */
@NullMarked
package simbad.sonar.shape;

import org.jspecify.annotations.NullMarked;
