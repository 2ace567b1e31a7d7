/**
 * The three robots of Kranz (2014), section 4.2.6, as demos: each follows the edge of a detection
 * shadow round its obstacle.
 *
 * <p>May not know: how they are run.
 */
@NullMarked
package simbad.experiments.demo;

import org.jspecify.annotations.NullMarked;
