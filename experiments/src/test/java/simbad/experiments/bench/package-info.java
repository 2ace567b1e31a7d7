/** Tests. */
@NullMarked
package simbad.experiments.bench;

import org.jspecify.annotations.NullMarked;
