/**
 * What stands and moves in the simulated world, and the two questions asked of it: what does a ray
 * meet, and what does a ball touch. Both are answered through a tree of extents, so that their cost
 * grows with the logarithm of the number of bodies.
 *
 * <p>May not know: sensors, robots, time, Java 3D or any toolkit.
 */
@NullMarked
package simbad.kernel.scene;

import org.jspecify.annotations.NullMarked;
