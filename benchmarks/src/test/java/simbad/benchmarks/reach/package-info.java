/** Tests of how far diagnoses reach. */
@NullMarked
package simbad.benchmarks.reach;

import org.jspecify.annotations.NullMarked;
