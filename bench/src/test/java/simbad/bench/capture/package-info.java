/** Tests. */
@NullMarked
package simbad.bench.capture;

import org.jspecify.annotations.NullMarked;
