/** The page of a withheld check. */
@NullMarked
package simbad.figures.blindcheck;

import org.jspecify.annotations.NullMarked;
