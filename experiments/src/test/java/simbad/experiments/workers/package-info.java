/** Tests. */
@NullMarked
package simbad.experiments.workers;

import org.jspecify.annotations.NullMarked;
