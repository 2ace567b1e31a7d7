/**
 * How well a set of effects does: on rows that it was not fitted on, in probability against other
 * sets, and in centimetres of the gap that it takes away.
 */
@NullMarked
package simbad.gap.score;

import org.jspecify.annotations.NullMarked;
