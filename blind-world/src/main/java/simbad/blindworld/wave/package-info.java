/**
 * The physics of an echo: air, burst, pistons, targets whose outlines scatter by physical optics,
 * and a receiver that waits for its threshold to be crossed. Knows nothing of what changes, nor of
 * a simulator's thresholds.
 */
@NullMarked
package simbad.blindworld.wave;

import org.jspecify.annotations.NullMarked;
