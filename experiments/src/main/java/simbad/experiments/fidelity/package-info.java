/**
 * The thesis's test of a sensor model, to be used again: point it at any model and any table, and
 * it returns the detection map, the trace, their errors and a verdict.
 */
@NullMarked
package simbad.experiments.fidelity;

import org.jspecify.annotations.NullMarked;
