/** Exports: what was measured, as source for other programs. */
@NullMarked
package simbad.experiments.export;

import org.jspecify.annotations.NullMarked;
