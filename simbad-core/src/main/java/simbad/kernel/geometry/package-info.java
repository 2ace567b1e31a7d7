/**
 * Solid geometry of the simulated world: rigid placements, rays, world-frame extents and the shapes
 * that bodies are made of.
 *
 * <p>Frame everywhere: metres, x to the right, y up, z towards the viewer; headings in radians,
 * counter-clockwise as seen from above, 0 along +x. Buffers ({@link
 * simbad.kernel.geometry.Placement}, {@link simbad.kernel.geometry.Ray}, {@link
 * simbad.kernel.geometry.Extent}) are mutable so that a simulation step allocates nothing.
 *
 * <p>May not know: who owns a body, what a sensor is, Java 3D or any toolkit.
 */
@NullMarked
package simbad.kernel.geometry;

import org.jspecify.annotations.NullMarked;
