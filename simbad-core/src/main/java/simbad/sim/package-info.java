/**
 * Simbad's public names: agents, static objects, devices, the environment and the simulator, with
 * the signatures that programs written for Simbad expect.
 *
 * <p>A facade: what happens is computed by {@code simbad.kernel}. Vectors and transforms of Java 3D
 * appear in signatures and work without a display; no scene graph node is made here. Frame and
 * units are the kernel's: metres, y up, headings in radians, counter-clockwise from above, 0 along
 * +x.
 *
 * <p>May not know: windows; the panels that show a device are made without a display. Nothing here
 * is safe for use by several threads, except that {@link simbad.sim.Simulator} guards its own
 * methods.
 */
@NullMarked
package simbad.sim;

import org.jspecify.annotations.NullMarked;
