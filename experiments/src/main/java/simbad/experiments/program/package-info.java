/**
 * Other people's programs, run as they are: without a window, with chance from a seed, for a number
 * of steps.
 */
@NullMarked
package simbad.experiments.program;

import org.jspecify.annotations.NullMarked;
