/**
 * How a robot moves and when a device acts: the displacement of one step from wheel or body speeds,
 * plans of timed motions, the clock that decides in which steps a device is updated.
 *
 * <p>May not know: bodies, sensors, the world's other objects, wall-clock time, any toolkit.
 */
@NullMarked
package simbad.kernel.motion;

import org.jspecify.annotations.NullMarked;
