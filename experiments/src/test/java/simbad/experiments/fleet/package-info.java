/** Tests. */
@NullMarked
package simbad.experiments.fleet;

import org.jspecify.annotations.NullMarked;
