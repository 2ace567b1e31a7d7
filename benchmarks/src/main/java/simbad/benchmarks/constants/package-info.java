/** Fits the constants that decide a diagnosis to finished checks whose truth is open. */
@NullMarked
package simbad.benchmarks.constants;

import org.jspecify.annotations.NullMarked;
