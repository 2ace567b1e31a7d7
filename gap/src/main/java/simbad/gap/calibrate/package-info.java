/**
 * The set-up as a reference log shows it: which of the two laws predicts rows of the reference best
 * that it was not fitted on, how far that law is off there, and which effects belong to the set-up.
 */
@NullMarked
package simbad.gap.calibrate;

import org.jspecify.annotations.NullMarked;
