/**
 * Obstacles that a sonar hears as a real one does: bodies with their detection shadows in the
 * world, the catalogue of measured types, and the belt that senses them.
 *
 * <p>Works headless; only the mesh of a shadow for the world view needs a display.
 */
@NullMarked
package simbad.obstacles;

import org.jspecify.annotations.NullMarked;
