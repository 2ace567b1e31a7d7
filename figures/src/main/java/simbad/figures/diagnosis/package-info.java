/**
 * The page of a diagnosis. Figures are SVG in the page itself, so that they take the reader's
 * theme. The same diagnosis gives the same bytes.
 */
@NullMarked
package simbad.figures.diagnosis;

import org.jspecify.annotations.NullMarked;
