/**
 * Pictures of threshold tables, traces, errors and detection maps, as PNG and SVG.
 *
 * <p>Records of numbers go in, a {@link simbad.figures.plot.PlotFigure} comes out. Lengths are
 * metres and angles radians; only labels speak of degrees and centimetres. The plan views use the
 * world's frame seen from above: x to the right, z down the page, bearing 0 along +z and bearing 90
 * along +x.
 *
 * <p>Equal records give equal bytes on one machine: nothing here reads a clock, a random generator
 * or the locale, and text is drawn as outlines. Another machine may map the logical font
 * "SansSerif" to another face.
 *
 * <p>This package draws. It does not know how a table is measured, how a trace comes about or how
 * an error is defined.
 */
@NullMarked
package simbad.figures.plot;

import org.jspecify.annotations.NullMarked;
