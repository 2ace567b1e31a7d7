/** What every page and picture that is written as text has in common. */
@NullMarked
package simbad.figures.markup;

import org.jspecify.annotations.NullMarked;
