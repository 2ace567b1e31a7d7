/** Tests of a diagnosis's folder and page. */
@NullMarked
package simbad.figures.diagnosis;

import org.jspecify.annotations.NullMarked;
