/** Tests. */
@NullMarked
package simbad.experiments.batch;

import org.jspecify.annotations.NullMarked;
