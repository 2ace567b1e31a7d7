/**
 * Explains a log: which sets of effects predict rows that they were not fitted on, what is left
 * over, how far the gap shrinks.
 */
@NullMarked
package simbad.gap.explain;

import org.jspecify.annotations.NullMarked;
