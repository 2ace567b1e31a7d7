/** A trivial diagnosis to compare with: the sort of residual that is largest names the effect. */
@NullMarked
package simbad.blindworld.baseline;

import org.jspecify.annotations.NullMarked;
