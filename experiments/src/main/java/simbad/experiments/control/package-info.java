/**
 * Controllers: belt readings in, velocities out.
 *
 * <p>A controller knows readings and nothing else: no pose, no scene, no table, no simulator. The
 * architecture test holds it to that.
 */
@NullMarked
package simbad.experiments.control;

import org.jspecify.annotations.NullMarked;
