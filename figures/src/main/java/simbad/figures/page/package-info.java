/**
 * The kit of every report: one style sheet, one script, one writer of HTML, tables, pictures and
 * the graphs that pages draw themselves.
 *
 * <p>A page is one file that asks for nothing else. Pictures are SVG in it, so that they take the
 * reader's theme and stay sharp; the script only adds to what can be read without it. Strings are
 * text and are escaped; markup has a type of its own, {@link simbad.figures.page.Html}. The same
 * calls give the same bytes.
 */
@NullMarked
package simbad.figures.page;

import org.jspecify.annotations.NullMarked;
