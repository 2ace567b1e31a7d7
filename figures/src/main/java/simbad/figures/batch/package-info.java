/** The page of a batch. */
@NullMarked
package simbad.figures.batch;

import org.jspecify.annotations.NullMarked;
