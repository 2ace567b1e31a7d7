/**
 * Runs steps on a thread, in time with the wall clock or as fast as they go.
 *
 * <p>May not know: what a step does.
 */
@NullMarked
package simbad.kernel.run;

import org.jspecify.annotations.NullMarked;
