/**
 * The one door for work that is cut into pieces: numbers in, results in the order of the numbers
 * out, on the cores of this machine or on a cluster.
 *
 * <p>It knows nothing of what the work is.
 */
@NullMarked
package simbad.experiments.workers;

import org.jspecify.annotations.NullMarked;
