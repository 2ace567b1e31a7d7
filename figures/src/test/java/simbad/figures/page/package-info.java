/** Tests of the kit of pages, and the browser in which pages are looked at. */
@NullMarked
package simbad.figures.page;

import org.jspecify.annotations.NullMarked;
