/** Tests of exports. */
@NullMarked
package simbad.experiments.export;

import org.jspecify.annotations.NullMarked;
