/** Fits hypotheses to a log: which values of an effect's parameters make its readings probable. */
@NullMarked
package simbad.gap.fit;

import org.jspecify.annotations.NullMarked;
