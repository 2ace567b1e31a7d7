/**
 * Diagnoses data sets: puts together what the packages below fit, search, locate and say. Knows no
 * simulator, no display and no truth.
 */
@NullMarked
package simbad.gap;

import org.jspecify.annotations.NullMarked;
