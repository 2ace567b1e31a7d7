/** Tests of fitted constants. */
@NullMarked
package simbad.benchmarks.constants;

import org.jspecify.annotations.NullMarked;
