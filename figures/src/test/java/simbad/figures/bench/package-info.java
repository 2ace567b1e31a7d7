/** Tests. */
@NullMarked
package simbad.figures.bench;

import org.jspecify.annotations.NullMarked;
