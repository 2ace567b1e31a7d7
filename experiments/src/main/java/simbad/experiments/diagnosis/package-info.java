/**
 * A diagnosis's folder: its files and its page. Figures are SVG in the page itself, so that they
 * take the reader's theme. The same diagnosis gives the same bytes.
 */
@NullMarked
package simbad.experiments.diagnosis;

import org.jspecify.annotations.NullMarked;
